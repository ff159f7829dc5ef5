// SPDX-License-Identifier: Apache-2.0
#include "tracer/lane_step.h"

#include <cstddef>
#include <limits>

#include "core/lanes.h"
#include "tracer/absorbing_boundary.h"
#include "tracer/transparent_boundary.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/lane_step.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace pol::HWY_NAMESPACE {

// Only for its width. Everything is inlined into the functions of the instruction set (`flatten`): between functions of
// different sets wide lanes must not be passed. Without optimization nothing is inlined, so lanes stay narrow.
#ifdef __OPTIMIZE__
constexpr int lane_width = static_cast<int>(HWY_MAX_BYTES) >= 64 ? 8 : static_cast<int>(HWY_MAX_BYTES) >= 32 ? 4 : 2;
#else
constexpr int lane_width = 2;
#endif
using Real = Lanes<lane_width>;

HWY_INLINE Vec3<Real> load3(const double (&from)[3][RayBlock::size], int lane) {
    return {Real::load(from[0] + lane), Real::load(from[1] + lane), Real::load(from[2] + lane)};
}

HWY_INLINE void store3(const Vec3<Real>& v, double (&to)[3][RayBlock::size], int lane) {
    v.x.store(to[0] + lane);
    v.y.store(to[1] + lane);
    v.z.store(to[2] + lane);
}

HWY_INLINE Throughput<Real> load_throughput(const LaneBranches& from, int lane) {
    Throughput<Real> t;
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column)
            t.m[row][column] = {Real::load(from.throughput[4 * row + 2 * column] + lane),
                                Real::load(from.throughput[4 * row + 2 * column + 1] + lane)};
    return t;
}

HWY_INLINE void store_child(const PairChild<Real>& child, const Vec3<Real>& s, const Vec3<Real>& origin,
                            LaneBranches& to, int lane) {
    store3(origin, to.rays.origin, lane);
    store3(child.ray, to.rays.direction, lane);
    store3(s, to.s, lane);
    store3(child.p, to.p, lane);
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column) {
            child.throughput.m[row][column].re.store(to.throughput[4 * row + 2 * column] + lane);
            child.throughput.m[row][column].im.store(to.throughput[4 * row + 2 * column + 1] + lane);
        }
    child.weight.store(to.weight + lane);
}

[[gnu::flatten]] void begin_step(const CameraModel& camera, const double* x, const double* y, LaneBranches& branches) {
    for (int lane = 0; lane < RayBlock::size; lane += lane_width) {
        const auto ray = camera.ray(Real::load(x + lane), Real::load(y + lane));
        PairChild<Real> root;
        root.ray = ray.direction;
        root.p = ray.y;
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j) root.throughput.m[i][j] = {Real(i == j ? 1.0 : 0.0), Real(0.0)};
        root.weight = Real(1.0);
        store_child(root, ray.x, ray.origin, branches, lane);
    }
}

HWY_INLINE void store_hits(const Sphere& ball, const Vec3<Real>& origin, const Vec3<Real>& ray,
                           const BallMeeting<Real>& meeting, HitBlock& hits, int lane) {
    alignas(64) double facet[lane_width];
    select(meeting.met, Real(0.0), Real(-1.0)).store(facet);
    for (int i = 0; i < lane_width; ++i) hits.facet[lane + i] = static_cast<int>(facet[i]);
    meeting.distance.store(hits.distance + lane);
    store3(ball.normal_at(origin + ray * meeting.distance), hits.normal, lane);
}

[[gnu::flatten]] void exit_ball_step(const Sphere& ball, const RayBlock& rays, HitBlock& hits) {
    for (int lane = 0; lane < RayBlock::size; lane += lane_width) {
        const Vec3<Real> origin = load3(rays.origin, lane);
        const Vec3<Real> ray = load3(rays.direction, lane);
        store_hits(ball, origin, ray, ball.leave(origin, ray), hits, lane);
    }
}

[[gnu::flatten]] void enter_ball_step(const Sphere& ball, const RayBlock& rays, HitBlock& hits) {
    for (int lane = 0; lane < RayBlock::size; lane += lane_width) {
        const Vec3<Real> origin = load3(rays.origin, lane);
        const Vec3<Real> ray = load3(rays.direction, lane);
        store_hits(ball, origin, ray, ball.come_in(origin, ray), hits, lane);
    }
}

[[gnu::flatten]] void cross_step(const LaneBranches& from, const HitBlock& hits, double side, double n1, double n2,
                                 LaneBranches& reflected, LaneBranches& transmitted, double* reaches) {
    for (int lane = 0; lane < RayBlock::size; lane += lane_width) {
        const Vec3<Real> ray = load3(from.rays.direction, lane);
        const Vec3<Real> origin = load3(from.rays.origin, lane) + ray * Real::load(hits.distance + lane);
        const Vec3<Real> field[2]{load3(from.s, lane), load3(from.p, lane)};
        const Vec3<Real> normal = load3(hits.normal, lane) * Real(side);
        const auto boundary = transparent_boundary(ray, field, load_throughput(from, lane), normal, n1, n2);
        store_child(boundary.reflected, boundary.s, origin, reflected, lane);
        store_child(boundary.transmitted, boundary.s, origin, transmitted, lane);
        select(boundary.reaches, Real(1.0), Real(0.0)).store(reaches + lane);
    }
}

[[gnu::flatten]] void cross_absorbing_step(const LaneBranches& from, const HitBlock& hits, double side,
                                           const AbsorbingMedia& media, LaneBranches& reflected,
                                           LaneBranches& transmitted, double* reaches, double* on_the_way,
                                           double* at_boundary) {
    const Complex<Real> n1(Real(media.n1.re), Real(media.n1.im));
    const Complex<Real> n2(Real(media.n2.re), Real(media.n2.im));
    for (int lane = 0; lane < RayBlock::size; lane += lane_width) {
        const Vec3<Real> ray = load3(from.rays.direction, lane);
        const Real distance = Real::load(hits.distance + lane);
        const Vec3<Real> origin = load3(from.rays.origin, lane) + ray * distance;
        const Vec3<Real> field[2]{load3(from.s, lane), load3(from.p, lane)};
        const Vec3<Real> normal = load3(hits.normal, lane) * Real(side);
        Throughput<Real> throughput = load_throughput(from, lane);
        Real k1 = n1.re;
        Real lost(0.0);
        if (media.n1.im != 0.0) {
            const Vec3<Real> k = ray * Real::load(from.index + lane);
            k1 = sqrt(length2(k));
            const auto along = attenuation(pair_absorption(media.absorption, n1.re, k), distance);
            lost = Real::load(from.weight + lane) * along.lost;
            throughput.scale(along.amplitude);
        }
        const auto boundary = absorbing_boundary(ray, field, throughput, normal, n1, n2, k1, false);
        store_child(boundary.reflected, boundary.s, origin, reflected, lane);
        store_child(boundary.transmitted, boundary.s, origin, transmitted, lane);
        k1.store(reflected.index + lane);
        boundary.behind.store(transmitted.index + lane);
        select(boundary.reaches, Real(1.0), Real(0.0)).store(reaches + lane);
        lost.store(on_the_way + lane);
        boundary.absorbed.store(at_boundary + lane);
    }
}

[[gnu::flatten]] void look_step(const LaneBranches& branches, const OpenSurface* const* surfaces, std::size_t count,
                                LaneSights& sights) {
    for (int lane = 0; lane < RayBlock::size; lane += lane_width) {
        const Vec3<Real> origin = load3(branches.rays.origin, lane);
        const Vec3<Real> ray = load3(branches.rays.direction, lane);
        Real nearest(std::numeric_limits<double>::infinity());
        Real surface(-1.0);
        Real along(0.0);
        Real u(0.0);
        Real v(0.0);
        for (std::size_t i = 0; i < count; ++i) {
            const auto meeting = surfaces[i]->meet(origin, ray);
            const auto nearer = meeting.met & (meeting.distance < nearest);
            nearest = select(nearer, meeting.distance, nearest);
            surface = select(nearer, Real(static_cast<double>(i)), surface);
            along = select(nearer, meeting.along, along);
            u = select(nearer, meeting.u, u);
            v = select(nearer, meeting.v, v);
        }
        surface.store(sights.surface + lane);
        nearest.store(sights.distance + lane);
        along.store(sights.along + lane);
        u.store(sights.u + lane);
        v.store(sights.v + lane);
        const Stokes<Real> state = load_throughput(branches, lane).unpolarized();
        state.s0.store(sights.unpolarized[0] + lane);
        state.s1.store(sights.unpolarized[1] + lane);
        state.s2.store(sights.unpolarized[2] + lane);
        state.s3.store(sights.unpolarized[3] + lane);
    }
}

}  // namespace pol::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pol {
HWY_EXPORT(begin_step);
HWY_EXPORT(exit_ball_step);
HWY_EXPORT(enter_ball_step);
HWY_EXPORT(cross_step);
HWY_EXPORT(cross_absorbing_step);
HWY_EXPORT(look_step);

void begin_in_lanes(const CameraModel& camera, const double (&x)[RayBlock::size], const double (&y)[RayBlock::size],
                    LaneBranches& branches) {
    HWY_DYNAMIC_DISPATCH(begin_step)(camera, x, y, branches);
}

void exit_ball_in_lanes(const Sphere& ball, const RayBlock& rays, HitBlock& hits) {
    HWY_DYNAMIC_DISPATCH(exit_ball_step)(ball, rays, hits);
}

void enter_ball_in_lanes(const Sphere& ball, const RayBlock& rays, HitBlock& hits) {
    HWY_DYNAMIC_DISPATCH(enter_ball_step)(ball, rays, hits);
}

void cross_in_lanes(const LaneBranches& from, const HitBlock& hits, double side, double n1, double n2,
                    LaneBranches& reflected, LaneBranches& transmitted, double (&reaches)[RayBlock::size]) {
    HWY_DYNAMIC_DISPATCH(cross_step)(from, hits, side, n1, n2, reflected, transmitted, reaches);
}

void cross_absorbing_in_lanes(const LaneBranches& from, const HitBlock& hits, double side, const AbsorbingMedia& media,
                              LaneBranches& reflected, LaneBranches& transmitted, double (&reaches)[RayBlock::size],
                              double (&absorbed)[2][RayBlock::size]) {
    HWY_DYNAMIC_DISPATCH(cross_absorbing_step)
    (from, hits, side, media, reflected, transmitted, reaches, absorbed[0], absorbed[1]);
}

void look_in_lanes(const LaneBranches& branches, std::span<const OpenSurface* const> surfaces, LaneSights& sights) {
    HWY_DYNAMIC_DISPATCH(look_step)(branches, surfaces.data(), surfaces.size(), sights);
}

}  // namespace pol
#endif
