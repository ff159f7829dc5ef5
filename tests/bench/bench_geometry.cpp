// SPDX-License-Identifier: Apache-2.0
// Nanoseconds per ray against the 73-plane brilliant: the half-space kernels and the Embree path.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "core/random.h"
#include "core/units.h"
#include "geometry/half_space_solid.h"
#include "geometry/plane_scan.h"
#include "geometry/ray_caster.h"
#include "geometry/shapes.h"

namespace pol {
namespace {

DVec3 direction(std::uint32_t i) {
    const RandomKey key{1, i, 0, 0};
    const double z = 2.0 * random_unit(key, 0) - 1.0;
    const double azimuth = 2.0 * pi * random_unit(key, 1);
    return {std::sqrt(1.0 - z * z) * std::cos(azimuth), std::sqrt(1.0 - z * z) * std::sin(azimuth), z};
}

Mesh stone() {
    return make_mesh(BrilliantShape{}).value();
}

struct Flight {
    DVec3 o, d;
};

std::vector<Flight> flights(double distance, double spread) {
    std::vector<Flight> all;
    for (std::uint32_t i = 0; i < 4096; ++i) {
        const DVec3 o = distance * direction(i);
        all.push_back({o, unit(spread * direction(i + 50000) - o)});
    }
    return all;
}

void enter_half_spaces(benchmark::State& state) {
    const HalfSpaceSolid solid = HalfSpaceSolid::from_mesh(stone()).value();
    const auto rays = flights(4.0, 0.9);
    std::size_t i = 0;
    for (auto _ : state) {
        const Flight& f = rays[i++ % rays.size()];
        benchmark::DoNotOptimize(solid.enter(f.o, f.d, -1));
    }
}
BENCHMARK(enter_half_spaces);

// A light ray bouncing about: every query waits for the one before it, as in a path.
void bounce_in_half_spaces(benchmark::State& state) {
    const HalfSpaceSolid solid = HalfSpaceSolid::from_mesh(stone()).value();
    DVec3 o(0.0);
    DVec3 d = direction(3);
    int left = -1;
    for (auto _ : state) {
        const FacetHit hit = solid.exit(o, d, left);
        const DVec3& n = solid.plane(hit.facet).normal;
        o += hit.distance * d;
        d = unit(d - 2.0 * dot(n, d) * n);
        left = hit.facet;
    }
    benchmark::DoNotOptimize(o);
}
BENCHMARK(bounce_in_half_spaces);

// Sixteen rays at once; the time is per block.
void enter_half_spaces_in_lanes(benchmark::State& state) {
    const HalfSpaceSolid solid = HalfSpaceSolid::from_mesh(stone()).value();
    const PlaneScan scan(solid);
    const auto rays = flights(4.0, 0.9);
    std::vector<RayBlock> blocks(rays.size() / RayBlock::size);
    for (std::size_t i = 0; i < rays.size(); ++i)
        set_ray(blocks[i / RayBlock::size], static_cast<int>(i % RayBlock::size), rays[i].o, rays[i].d);
    std::size_t i = 0;
    HitBlock hits;
    for (auto _ : state) {
        scan.enter(blocks[i++ % blocks.size()], RayBlock::size, hits);
        benchmark::DoNotOptimize(hits);
    }
    state.SetItemsProcessed(state.iterations() * RayBlock::size);
}
BENCHMARK(enter_half_spaces_in_lanes);

void bounce_in_half_spaces_in_lanes(benchmark::State& state) {
    const HalfSpaceSolid solid = HalfSpaceSolid::from_mesh(stone()).value();
    const PlaneScan scan(solid);
    RayBlock rays;
    HitBlock hits;
    int left[RayBlock::size];
    for (int lane = 0; lane < RayBlock::size; ++lane) {
        set_ray(rays, lane, DVec3(0.0), direction(static_cast<std::uint32_t>(lane)));
        left[lane] = -1;
    }
    for (auto _ : state) {
        scan.exit(rays, left, RayBlock::size, hits);
        for (int lane = 0; lane < RayBlock::size; ++lane) {
            const DVec3 n(hits.normal[0][lane], hits.normal[1][lane], hits.normal[2][lane]);
            const DVec3 d = direction_of(rays, lane);
            set_ray(rays, lane, origin_of(rays, lane) + hits.distance[lane] * d, unit(d - 2.0 * dot(n, d) * n));
            left[lane] = hits.facet[lane];
        }
    }
    state.SetItemsProcessed(state.iterations() * RayBlock::size);
}
BENCHMARK(bounce_in_half_spaces_in_lanes);

void enter_through_embree(benchmark::State& state) {
    const RayCaster caster = RayCaster::build({stone()}).value();
    const auto rays = flights(4.0, 0.9);
    std::size_t i = 0;
    for (auto _ : state) {
        const Flight& f = rays[i++ % rays.size()];
        benchmark::DoNotOptimize(caster.nearest(f.o, f.d));
    }
}
BENCHMARK(enter_through_embree);

void bounce_through_embree(benchmark::State& state) {
    const Mesh mesh = stone();
    const RayCaster caster = RayCaster::build({mesh}).value();
    DVec3 o(0.0);
    DVec3 d = direction(3);
    LeftFacet left[1]{{0, -1, -1}};
    for (auto _ : state) {
        const auto hit = caster.nearest(o, d, left);
        const DVec3& n = mesh.facets[static_cast<std::size_t>(hit->facet)].normal;
        o += hit->distance * d;
        d = unit(d - 2.0 * dot(n, d) * n);
        left[0] = {hit->mesh, hit->facet, hit->triangle};
    }
    benchmark::DoNotOptimize(o);
}
BENCHMARK(bounce_through_embree);

}  // namespace
}  // namespace pol
