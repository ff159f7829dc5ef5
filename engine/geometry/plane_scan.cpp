// SPDX-License-Identifier: Apache-2.0
#include "geometry/plane_scan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/plane_scan.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace pol::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Only what float chooses may depend on the instruction set: it uses fused operations where there are any. What double
// decides does not.

using FloatLanes = hn::CappedTag<float, RayBlock::size>;
using FloatVector = hn::Vec<FloatLanes>;

constexpr float scan_no_bound = std::numeric_limits<float>::infinity();

struct alignas(64) FloatRays {
    float origin[3][RayBlock::size];
    float direction[3][RayBlock::size];
};

// What the loops over the planes load again and again is loaded once: they store nothing.
HWY_INLINE FloatVector along_of(const FloatPlane& plane, FloatVector margin, const FloatRays& rays, std::size_t lane) {
    const FloatLanes lanes;
    const FloatVector x = hn::MulAdd(hn::Set(lanes, plane.x), hn::Load(lanes, rays.direction[0] + lane), margin);
    const FloatVector xy = hn::MulAdd(hn::Set(lanes, plane.y), hn::Load(lanes, rays.direction[1] + lane), x);
    return hn::MulAdd(hn::Set(lanes, plane.z), hn::Load(lanes, rays.direction[2] + lane), xy);
}

HWY_INLINE FloatVector ahead_of(const FloatPlane& plane, FloatVector margin, const FloatRays& rays, std::size_t lane) {
    const FloatLanes lanes;
    const FloatVector offset = hn::Sub(hn::Set(lanes, plane.offset), margin);
    const FloatVector x = hn::NegMulAdd(hn::Set(lanes, plane.x), hn::Load(lanes, rays.origin[0] + lane), offset);
    const FloatVector xy = hn::NegMulAdd(hn::Set(lanes, plane.y), hn::Load(lanes, rays.origin[1] + lane), x);
    return hn::NegMulAdd(hn::Set(lanes, plane.z), hn::Load(lanes, rays.origin[2] + lane), xy);
}

// first: facet with the smallest lower bound of its distance; second: the smallest of the other bounds. 0/0 is no
// bound: where a minimum drops it, `next` is no larger than `best` and the lane takes the exact scan; where it stays,
// too.
void exit_bounds(const FloatPlane* planes, std::size_t count, const PlaneScanFrame& frame, const FloatRays& rays,
                 float* first, float* second) {
    const FloatLanes lanes;
    const FloatVector along_margin = hn::Set(lanes, frame.along_margin);
    const FloatVector ahead_margin = hn::Set(lanes, frame.exit_margin);
    const FloatVector none = hn::Set(lanes, scan_no_bound);
    const FloatVector zero = hn::Zero(lanes);
    const FloatVector one = hn::Set(lanes, 1.0F);
    for (std::size_t lane = 0; lane < RayBlock::size; lane += hn::Lanes(lanes)) {
        FloatVector index = zero;
        FloatVector best = none;
        FloatVector next = none;
        FloatVector facet = hn::Set(lanes, -1.0F);
        for (std::size_t i = 0; i < count; ++i) {
            const FloatVector along = along_of(planes[i], along_margin, rays, lane);
            const FloatVector ahead = ahead_of(planes[i], ahead_margin, rays, lane);
            const FloatVector low = hn::IfThenElse(hn::Lt(along, zero), none, hn::Div(ahead, along));
            facet = hn::IfThenElse(hn::Lt(low, best), index, facet);
            next = hn::Min(next, hn::Max(low, best));
            best = hn::Min(low, best);
            index = hn::Add(index, one);
        }
        hn::Store(facet, lanes, first + lane);
        hn::Store(next, lanes, second + lane);
    }
}

// in, out: facets with the largest upper bound of an entry and the smallest lower bound of an exit; other_in: the
// second largest bound of an entry, not below 0; exit: the smallest bound of an exit. A plane that is nearly parallel
// to the ray counts as an exit: if the ray is inside of it, it lies far behind or far ahead; if not, its bound is
// negative and the lane takes the exact scan. 0/0 may be dropped: the ray is inside of that plane and leaves it behind.
void enter_bounds(const FloatPlane* planes, std::size_t count, const PlaneScanFrame& frame, const FloatRays& rays,
                  float* in, float* out, float* other_in, float* exit) {
    const FloatLanes lanes;
    const FloatVector along_margin = hn::Set(lanes, frame.along_margin);
    const FloatVector ahead_margin = hn::Set(lanes, frame.enter_margin);
    const FloatVector none = hn::Set(lanes, scan_no_bound);
    const FloatVector zero = hn::Zero(lanes);
    const FloatVector one = hn::Set(lanes, 1.0F);
    for (std::size_t lane = 0; lane < RayBlock::size; lane += hn::Lanes(lanes)) {
        FloatVector index = zero;
        FloatVector near = zero;
        FloatVector near_next = zero;
        FloatVector near_facet = hn::Set(lanes, -1.0F);
        FloatVector far = none;
        FloatVector far_facet = near_facet;
        for (std::size_t i = 0; i < count; ++i) {
            const FloatVector along = along_of(planes[i], along_margin, rays, lane);
            const FloatVector ahead = ahead_of(planes[i], ahead_margin, rays, lane);
            const FloatVector quotient = hn::Div(ahead, along);
            const FloatVector entry = hn::IfThenElse(hn::Lt(along, zero), quotient, zero);
            const FloatVector leave = hn::IfThenElse(hn::Lt(along, zero), none, quotient);
            near_facet = hn::IfThenElse(hn::Gt(entry, near), index, near_facet);
            near_next = hn::Max(near_next, hn::Min(entry, near));
            near = hn::Max(near, entry);
            far_facet = hn::IfThenElse(hn::Lt(leave, far), index, far_facet);
            far = hn::Min(leave, far);
            index = hn::Add(index, one);
        }
        hn::Store(near_facet, lanes, in + lane);
        hn::Store(far_facet, lanes, out + lane);
        hn::Store(near_next, lanes, other_in + lane);
        hn::Store(far, lanes, exit + lane);
    }
}

// Distances in double to one facet for each ray, as the exact scan computes them: the same operations in the same
// order.
struct alignas(64) FacetDistances {
    double normal[3][RayBlock::size];
    double along[RayBlock::size];
    double distance[RayBlock::size];
};

HWY_INLINE void distances_to(const Plane* planes, const float* facets, const RayBlock& rays, FacetDistances& out) {
    alignas(64) double offset[RayBlock::size];
    for (std::size_t lane = 0; lane < RayBlock::size; ++lane) {
        const Plane& plane = planes[facets[lane] < 0.0F ? 0 : static_cast<std::size_t>(facets[lane])];
        out.normal[0][lane] = plane.normal.x;
        out.normal[1][lane] = plane.normal.y;
        out.normal[2][lane] = plane.normal.z;
        offset[lane] = plane.offset;
    }
    for (std::size_t lane = 0; lane < RayBlock::size; ++lane) {
        const double along =
            (out.normal[0][lane] * rays.direction[0][lane] + out.normal[1][lane] * rays.direction[1][lane]) +
            out.normal[2][lane] * rays.direction[2][lane];
        const double ahead =
            offset[lane] - ((out.normal[0][lane] * rays.origin[0][lane] + out.normal[1][lane] * rays.origin[1][lane]) +
                            out.normal[2][lane] * rays.origin[2][lane]);
        out.along[lane] = along;
        out.distance[lane] = ahead / along;
    }
}

// Whether the lane's answer is certain; the others take the exact scan.
void exit_scan(const Plane* planes, const FloatPlane* float_planes, std::size_t count, const PlaneScanFrame& frame,
               const RayBlock& rays, const int* skip, HitBlock& hits, bool* certain) {
    FloatRays seen;
    alignas(64) double distance2[RayBlock::size];
    for (std::size_t lane = 0; lane < RayBlock::size; ++lane) distance2[lane] = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        for (std::size_t lane = 0; lane < RayBlock::size; ++lane) {
            const double o = (rays.origin[axis][lane] - frame.center[axis]) * frame.per_radius;
            distance2[lane] += o * o;
            seen.origin[axis][lane] = static_cast<float>(o);
            seen.direction[axis][lane] = static_cast<float>(rays.direction[axis][lane]);
        }
    }
    alignas(64) float first[RayBlock::size];
    alignas(64) float second[RayBlock::size];
    exit_bounds(float_planes, count, frame, seen, first, second);
    FacetDistances nearest;
    distances_to(planes, first, rays, nearest);
    for (std::size_t lane = 0; lane < RayBlock::size; ++lane) {
        const double bound = static_cast<double>(second[lane]) * scan_slack;
        const int facet = static_cast<int>(first[lane]);
        certain[lane] = facet >= 0 && facet != skip[lane] && nearest.along[lane] > 0.0 && bound > 0.0 &&
                        nearest.distance[lane] * frame.per_radius < bound && distance2[lane] <= frame.exit_reach2;
        hits.distance[lane] = nearest.distance[lane];
        hits.facet[lane] = facet;
        for (int axis = 0; axis < 3; ++axis) hits.normal[axis][lane] = nearest.normal[axis][lane];
    }
}

void enter_scan(const Plane* planes, const FloatPlane* float_planes, std::size_t count, const PlaneScanFrame& frame,
                const RayBlock& rays, HitBlock& hits, bool* certain) {
    // The origins moved to within 1.5 radii of the centre, if that is ahead.
    FloatRays seen;
    alignas(64) double from[3][RayBlock::size];
    alignas(64) double distance2[RayBlock::size];
    alignas(64) double towards[RayBlock::size];
    alignas(64) double moved[RayBlock::size];
    for (std::size_t lane = 0; lane < RayBlock::size; ++lane) {
        towards[lane] = 0.0;
        distance2[lane] = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            from[axis][lane] = (rays.origin[axis][lane] - frame.center[axis]) * frame.per_radius;
            distance2[lane] += from[axis][lane] * from[axis][lane];
            towards[lane] -= from[axis][lane] * rays.direction[axis][lane];
        }
        moved[lane] = towards[lane] > 1.0 ? towards[lane] - 1.0 : 0.0;
    }
    bool passes[RayBlock::size];
    bool all_pass = true;
    for (std::size_t lane = 0; lane < RayBlock::size; ++lane) {
        // As HalfSpaceSolid::passes_by, of a ball that is 1e-4 larger, with room for |d| off by 1e-9.
        const double apart2 = towards[lane] > 0.0 ? distance2[lane] - towards[lane] * towards[lane] : distance2[lane];
        passes[lane] = apart2 > 1.0 + 4e-9 * distance2[lane];
        all_pass = all_pass && passes[lane];
        certain[lane] = true;
        hits.distance[lane] = 0.0;
        hits.facet[lane] = -1;
    }
    if (all_pass) return;
    alignas(64) double start2[RayBlock::size];
    for (std::size_t lane = 0; lane < RayBlock::size; ++lane) {
        start2[lane] = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double o = from[axis][lane] + rays.direction[axis][lane] * moved[lane];
            start2[lane] += o * o;
            seen.origin[axis][lane] = static_cast<float>(o);
            seen.direction[axis][lane] = static_cast<float>(rays.direction[axis][lane]);
        }
    }
    alignas(64) float in[RayBlock::size];
    alignas(64) float out[RayBlock::size];
    alignas(64) float other_in[RayBlock::size];
    alignas(64) float exit[RayBlock::size];
    enter_bounds(float_planes, count, frame, seen, in, out, other_in, exit);
    FacetDistances entry;
    FacetDistances leave;
    distances_to(planes, in, rays, entry);
    distances_to(planes, out, rays, leave);
    for (std::size_t lane = 0; lane < RayBlock::size; ++lane) {
        const double t = entry.distance[lane];
        const double ahead = t * frame.per_radius - moved[lane];
        const bool both = in[lane] >= 0.0F && out[lane] >= 0.0F && entry.along[lane] < 0.0 && leave.along[lane] > 0.0;
        const bool misses = passes[lane] || (both && t > leave.distance[lane]);
        const bool meets = !passes[lane] && both && t > 0.0 && start2[lane] <= enter_start_reach2 &&
                           distance2[lane] <= frame.enter_reach2 &&
                           ahead * scan_slack > static_cast<double>(other_in[lane]) + enter_slack &&
                           ahead < static_cast<double>(exit[lane]) * scan_slack - enter_slack;
        certain[lane] = misses || meets;
        hits.distance[lane] = meets ? t : 0.0;
        hits.facet[lane] = meets ? static_cast<int>(in[lane]) : -1;
        for (int axis = 0; axis < 3; ++axis) hits.normal[axis][lane] = entry.normal[axis][lane];
    }
}

}  // namespace pol::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pol {
HWY_EXPORT(exit_scan);
HWY_EXPORT(enter_scan);

namespace {

/// A sum of `roundings` float rounding errors of numbers up to 1, a quarter wider.
float float_margin(double roundings, double exact_scan) {
    return static_cast<float>(1.25 * (roundings * 0x1p-24 + exact_scan));
}

}  // namespace

PlaneScan::PlaneScan(const HalfSpaceSolid& solid) : solid_(solid) {
    // Vertices lie in the ball of this radius, ray origins by their slack beside it.
    frame_.radius = 1.0001 * (solid.radius() + solid.slack());
    frame_.center = solid.center();
    frame_.per_radius = 1.0 / frame_.radius;
    // offset - n.o in double: half an ulp of the offset, four of n.o, one of the difference, and as much for the plane
    // seen from the centre; with |offset| <= |center| + radius and |o| <= |center| + reach.
    const auto rounding = [&](double reach) {
        return 16.0 * 0x1p-53 * (std::sqrt(length2(frame_.center)) * frame_.per_radius + reach);
    };
    constexpr double exit_reach = 1.01;
    constexpr double enter_reach = 1e3;
    frame_.exit_reach2 = exit_reach * exit_reach;
    frame_.enter_reach2 = enter_reach * enter_reach;
    frame_.along_margin = float_margin(6.0, 0.0);
    frame_.exit_margin = float_margin(3.0 + 7.0 * exit_reach, rounding(exit_reach));
    frame_.enter_margin = float_margin(3.0 + 7.0 * std::sqrt(enter_start_reach2), rounding(enter_reach));
    for (int i = 0; i < solid.facet_count(); ++i) {
        const Plane& plane = solid.plane(i);
        const double offset = (plane.offset - dot(plane.normal, frame_.center)) * frame_.per_radius;
        planes_.push_back({static_cast<float>(plane.normal.x), static_cast<float>(plane.normal.y),
                           static_cast<float>(plane.normal.z), static_cast<float>(offset)});
    }
}

void PlaneScan::set_hit(const FacetHit& hit, int lane, HitBlock& hits) const {
    hits.distance[lane] = hit.distance;
    hits.facet[lane] = hit.facet;
    if (!hit) return;
    for (int axis = 0; axis < 3; ++axis) hits.normal[axis][lane] = solid_.plane(hit.facet).normal[axis];
}

int PlaneScan::exit(const RayBlock& rays, const int (&skip)[RayBlock::size], int count, HitBlock& hits) const {
    bool certain[RayBlock::size];
    HWY_DYNAMIC_DISPATCH(exit_scan)
    (solid_.mesh().facets.data(), planes_.data(), planes_.size(), frame_, rays, skip, hits, certain);
    int exact = 0;
    for (int lane = 0; lane < count; ++lane) {
        if (certain[lane] || skip[lane] == no_ray) continue;
        ++exact;
        set_hit(solid_.exit(origin_of(rays, lane), direction_of(rays, lane), skip[lane]), lane, hits);
    }
    return exact;
}

int PlaneScan::enter(const RayBlock& rays, int count, HitBlock& hits) const {
    bool certain[RayBlock::size];
    HWY_DYNAMIC_DISPATCH(enter_scan)
    (solid_.mesh().facets.data(), planes_.data(), planes_.size(), frame_, rays, hits, certain);
    int exact = 0;
    for (int lane = 0; lane < count; ++lane) {
        if (certain[lane]) continue;
        ++exact;
        set_hit(solid_.enter(origin_of(rays, lane), direction_of(rays, lane), -1), lane, hits);
    }
    return exact;
}

}  // namespace pol
#endif
