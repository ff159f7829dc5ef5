// SPDX-License-Identifier: Apache-2.0
#include "geometry/plane_scan.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "geometry/geometry_helpers.h"
#include "geometry/shapes.h"
#include "support/instruction_sets.h"

namespace pol {
namespace {

using test::dice;
using test::Dice;

/// Blocks of 16 rays of each kind for each solid; POLARISCOPE_SCAN_BLOCKS runs more.
int blocks() {
    const char* asked = std::getenv("POLARISCOPE_SCAN_BLOCKS");
    return asked == nullptr ? 400 : std::atoi(asked);
}

struct ScannedSolid {
    std::string name;
    HalfSpaceSolid solid;
};

std::vector<ScannedSolid> solids() {
    std::vector<ScannedSolid> all;
    for (const double size : {1.0, 1e-6, 1e6}) {
        for (const double offset : {0.0, 1e3}) {
            DMat4 placed(size);
            placed[3] = glm::dvec4(offset * size, -offset * size, offset * size, 1.0);
            const auto add = [&](const std::string& name, const Mesh& mesh) {
                all.push_back({name + " of size " + std::to_string(size) + " at " + std::to_string(offset),
                               HalfSpaceSolid::from_mesh(transformed(mesh, placed).value()).value()});
            };
            add("brilliant", make_mesh(BrilliantShape{}).value());
            add("box", make_mesh(BoxShape{}).value());
            add("prism", make_mesh(PrismShape{1.0, 1.0, 1.0}).value());
        }
    }
    // Where double itself has little left: 1e10 radii from the origin of the coordinates.
    DMat4 far(1e-7);
    far[3] = glm::dvec4(1e3, -1e3, 1e3, 1.0);
    const Mesh small = transformed(make_mesh(BoxShape{}).value(), far).value();
    all.push_back({"small box far away", HalfSpaceSolid::from_mesh(small).value()});
    return all;
}

DVec3 vertex(const HalfSpaceSolid& solid, Dice& random) {
    return solid.vertices()[static_cast<std::size_t>(random.next() * static_cast<double>(solid.vertices().size()))];
}

DVec3 inner_point(const HalfSpaceSolid& solid, Dice& random) {
    return solid.center() + 0.3 * random.next() * solid.radius() * random.direction();
}

/// Tiny, of any size: to miss an edge by.
double whisker(Dice& random) {
    return (random.next() < 0.5 ? -1.0 : 1.0) * std::pow(10.0, -17.0 + 16.0 * random.next());
}

/// Along an edge of a facet, beside it and askew by whiskers: nearly in two planes at once.
void ray_along_an_edge(const HalfSpaceSolid& solid, Dice& random, DVec3& o, DVec3& d) {
    const auto& triangles = solid.mesh().triangles;
    const auto& triangle = triangles[static_cast<std::size_t>(random.next() * static_cast<double>(triangles.size()))];
    const DVec3& a = solid.vertices()[triangle[0]];
    const DVec3& b = solid.vertices()[triangle[1]];
    o = a + random.next() * (b - a) + whisker(random) * solid.radius() * random.direction();
    d = unit(unit(b - a) + whisker(random) * random.direction());
}

/// A ray that is inside or on the boundary, `skip` as of a ray that has been reflected there.
void inner_ray(const HalfSpaceSolid& solid, int kind, Dice& random, RayBlock& rays, int lane, int& skip) {
    skip = -1;
    DVec3 o = inner_point(solid, random);
    DVec3 d = random.direction();
    if (kind > 0) {  // on a facet: from inside to it
        const FacetHit hit = solid.exit(o, d, -1);
        if (hit) {
            o += hit.distance * d;
            skip = hit.facet;
            const DVec3 normal = solid.plane(hit.facet).normal;
            d = random.direction();
            if (dot(d, normal) > 0.0) d = -d;
            // along the facet, leaning in or out of it by whiskers
            if (kind == 3) d = unit(d - (1.0 + whisker(random)) * dot(d, normal) * normal);
        }
    }
    if (kind == 2) {  // through an edge or a corner, or just past it
        const double along = random.next() < 0.3 ? 0.0 : random.next();
        const DVec3 aim = vertex(solid, random) * (1.0 - along) + vertex(solid, random) * along +
                          whisker(random) * solid.radius() * random.direction();
        if (glm::distance(aim, o) > 1e-3 * solid.radius()) d = unit(aim - o);
    }
    if (kind == 4) o = solid.center() + (0.9 + 3.0 * random.next()) * solid.radius() * random.direction();
    if (kind == 5)
        d = DVec3(random.next() < 0.5, random.next() < 0.5, 0.0), d = length2(d) > 0.0 ? unit(d) : DVec3(0, 0, -1);
    if (kind == 6) ray_along_an_edge(solid, random, o, d);
    set_ray(rays, lane, o, d);
}

TEST(PlaneScan, FindsTheFacetAndTheDistanceOfTheExactScanForRaysFromInside) {
    const test::EveryInstructionSet restore;
    const auto every = test::instruction_sets();
    ASSERT_GE(every.size(), 2U) << "this machine runs one instruction set only: nothing was compared";
    Dice random = dice(11);
    for (const ScannedSolid& scanned : solids()) {
        const PlaneScan scan(scanned.solid);
        for (int block = 0; block < blocks(); ++block) {
            for (int kind = 0; kind < 7; ++kind) {
                RayBlock rays;
                int skip[RayBlock::size];
                for (int lane = 0; lane < RayBlock::size; ++lane)
                    inner_ray(scanned.solid, kind, random, rays, lane, skip[lane]);
                for (const std::int64_t target : every) {
                    hwy::SetSupportedTargetsForTest(target);
                    HitBlock hits;
                    scan.exit(rays, skip, RayBlock::size, hits);
                    for (int lane = 0; lane < RayBlock::size; ++lane) {
                        const FacetHit expected =
                            scanned.solid.exit(origin_of(rays, lane), direction_of(rays, lane), skip[lane]);
                        ASSERT_EQ(hits.facet[lane], expected.facet)
                            << scanned.name << ", kind " << kind << ", " << hwy::TargetName(target);
                        ASSERT_EQ(hits.distance[lane], expected.distance) << scanned.name << ", kind " << kind;
                        if (!expected) continue;
                        for (int axis = 0; axis < 3; ++axis)
                            ASSERT_EQ(hits.normal[axis][lane], scanned.solid.plane(expected.facet).normal[axis]);
                    }
                }
            }
        }
    }
}

void outer_ray(const HalfSpaceSolid& solid, int kind, Dice& random, RayBlock& rays, int lane) {
    const double far = kind == 4 ? std::pow(10.0, 6.0 * random.next()) : 1.0 + 4.0 * random.next();
    DVec3 o = solid.center() + far * solid.radius() * random.direction();
    DVec3 aim = solid.center() + 1.1 * random.next() * solid.radius() * random.direction();
    if (kind == 1 || kind == 4) {
        const double along = random.next() < 0.3 ? 0.0 : random.next();
        aim = vertex(solid, random) * (1.0 - along) + vertex(solid, random) * along +
              whisker(random) * solid.radius() * random.direction();
    }
    if (kind == 2) o = inner_point(solid, random);
    DVec3 d = unit(aim - o);
    if (kind == 3) {  // in the plane of a facet, or nearly
        const Plane& plane = solid.plane(static_cast<int>(random.next() * solid.facet_count()));
        o -= (dot(plane.normal, o) - plane.offset) * (1.0 + whisker(random)) * plane.normal;
        d = unit(d - dot(plane.normal, d) * (1.0 + whisker(random)) * plane.normal);
    }
    if (kind == 5) d = -d;
    if (kind == 6) {
        ray_along_an_edge(solid, random, o, d);
        o -= 3.0 * random.next() * solid.radius() * d;
    }
    set_ray(rays, lane, o, d);
}

TEST(PlaneScan, FindsTheEntryOfTheExactScanForRaysFromOutside) {
    const test::EveryInstructionSet restore;
    const auto every = test::instruction_sets();
    Dice random = dice(12);
    for (const ScannedSolid& scanned : solids()) {
        const PlaneScan scan(scanned.solid);
        for (int block = 0; block < blocks(); ++block) {
            for (int kind = 0; kind < 7; ++kind) {
                RayBlock rays;
                for (int lane = 0; lane < RayBlock::size; ++lane) outer_ray(scanned.solid, kind, random, rays, lane);
                for (const std::int64_t target : every) {
                    hwy::SetSupportedTargetsForTest(target);
                    HitBlock hits;
                    scan.enter(rays, RayBlock::size, hits);
                    for (int lane = 0; lane < RayBlock::size; ++lane) {
                        const FacetHit expected =
                            scanned.solid.enter(origin_of(rays, lane), direction_of(rays, lane), -1);
                        ASSERT_EQ(hits.facet[lane], expected.facet)
                            << scanned.name << ", kind " << kind << ", " << hwy::TargetName(target);
                        if (expected) {
                            ASSERT_EQ(hits.distance[lane], expected.distance) << scanned.name << ", kind " << kind;
                        }
                    }
                }
            }
        }
    }
}

// 1 in 11 000 inner rays of a brilliant was measured to be too close to call; ten times as many would cost the scan its
// use.
TEST(PlaneScan, RarelyNeedsTheExactScan) {
    const HalfSpaceSolid solid = HalfSpaceSolid::from_mesh(make_mesh(BrilliantShape{}).value()).value();
    const PlaneScan scan(solid);
    Dice random = dice(13);
    int exact_exits = 0;
    int exact_entries = 0;
    constexpr int count = 6000;
    for (int block = 0; block < count; ++block) {
        RayBlock inside;
        RayBlock outside;
        int skip[RayBlock::size];
        for (int lane = 0; lane < RayBlock::size; ++lane) {
            inner_ray(solid, 1, random, inside, lane, skip[lane]);
            outer_ray(solid, 0, random, outside, lane);
        }
        HitBlock hits;
        exact_exits += scan.exit(inside, skip, RayBlock::size, hits);
        exact_entries += scan.enter(outside, RayBlock::size, hits);
    }
    EXPECT_LT(exact_exits, 1e-3 * count * RayBlock::size);
    EXPECT_LT(exact_entries, 1e-3 * count * RayBlock::size);
    RecordProperty("exact_exits", exact_exits);
    RecordProperty("exact_entries", exact_entries);
}

}  // namespace
}  // namespace pol
