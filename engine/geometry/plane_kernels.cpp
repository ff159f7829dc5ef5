// SPDX-License-Identifier: Apache-2.0
#include "geometry/plane_kernels.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/plane_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace pol::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// One division per plane: the quotients are ordered totally, so the answer cannot depend on the register width (signs
// of cross products, being rounded, are not transitive), and the divider works beside the multipliers.
// MulAdd is not used on purpose: it would fuse on some targets only.

using Lanes = hn::CappedTag<double, 8>;
using Vector = hn::Vec<Lanes>;

constexpr double no_hit = std::numeric_limits<double>::infinity();

// Nearest lane; of equal ones the one with the lowest facet index.
FacetHit nearest_lane(Vector distance, Vector facet) {
    const Lanes lanes;
    const Vector nearest = hn::MinOfLanes(lanes, distance);
    const Vector none = hn::Set(lanes, no_hit);
    const double lowest = hn::GetLane(hn::MinOfLanes(lanes, hn::IfThenElse(hn::Eq(distance, nearest), facet, none)));
    const double t = hn::GetLane(nearest);
    return t < no_hit ? FacetHit{t, static_cast<int>(lowest)} : FacetHit{t, -1};
}

// normal.v of the planes in these lanes. (No struct holds a Vector: arm64's scalable ones are not allowed there.)
HWY_INLINE Vector along(const PlaneBlock& block, std::size_t lane, const DVec3& v) {
    const Lanes lanes;
    const Vector x = hn::Load(lanes, block.normal_x + lane);
    const Vector y = hn::Load(lanes, block.normal_y + lane);
    const Vector z = hn::Load(lanes, block.normal_z + lane);
    return hn::Add(hn::Add(hn::Mul(x, hn::Set(lanes, v.x)), hn::Mul(y, hn::Set(lanes, v.y))),
                   hn::Mul(z, hn::Set(lanes, v.z)));
}

// offset - normal.o: what is between o and the planes.
HWY_INLINE Vector ahead(const PlaneBlock& block, std::size_t lane, const DVec3& o) {
    return hn::Sub(hn::Load(Lanes(), block.offset + lane), along(block, lane, o));
}

FacetHit exit_kernel(const PlaneBlock* blocks, std::size_t count, const DVec3& o, const DVec3& d, int skip) {
    const Lanes lanes;
    const Vector zero = hn::Zero(lanes);
    const Vector skipped = hn::Set(lanes, static_cast<double>(skip));
    const Vector step = hn::Set(lanes, static_cast<double>(hn::Lanes(lanes)));
    Vector index = hn::Iota(lanes, 0.0);
    Vector best = hn::Set(lanes, no_hit);
    Vector facet = hn::Set(lanes, -1.0);
    for (std::size_t b = 0; b < count; ++b) {
        for (std::size_t lane = 0; lane < 8; lane += hn::Lanes(lanes)) {
            const Vector approach = along(blocks[b], lane, d);
            const Vector gap = ahead(blocks[b], lane, o);
            const Vector t = hn::Div(gap, approach);
            const auto leaves = hn::And(hn::Gt(approach, zero), hn::Ne(index, skipped));
            const auto nearer = hn::And(leaves, hn::Lt(t, best));
            best = hn::IfThenElse(nearer, t, best);
            facet = hn::IfThenElse(nearer, index, facet);
            index = hn::Add(index, step);
        }
    }
    return nearest_lane(best, facet);
}

FacetHit enter_kernel(const PlaneBlock* blocks, std::size_t count, const DVec3& o, const DVec3& d) {
    const Lanes lanes;
    const Vector zero = hn::Zero(lanes);
    const Vector step = hn::Set(lanes, static_cast<double>(hn::Lanes(lanes)));
    Vector index = hn::Iota(lanes, 0.0);
    Vector far = hn::Set(lanes, no_hit);
    Vector minus_near = hn::Set(lanes, no_hit);  // negated, so that nearest_lane finds the farthest entry
    Vector facet = hn::Set(lanes, -1.0);
    for (std::size_t b = 0; b < count; ++b) {
        for (std::size_t lane = 0; lane < 8; lane += hn::Lanes(lanes)) {
            const Vector approach = along(blocks[b], lane, d);
            const Vector gap = ahead(blocks[b], lane, o);
            const Vector t = hn::Div(gap, approach);
            const auto later = hn::And(hn::Lt(approach, zero), hn::Lt(hn::Neg(t), minus_near));
            minus_near = hn::IfThenElse(later, hn::Neg(t), minus_near);
            facet = hn::IfThenElse(later, index, facet);
            const auto sooner = hn::And(hn::Gt(approach, zero), hn::Lt(t, far));
            far = hn::IfThenElse(sooner, t, far);
            const auto beside = hn::And(hn::Eq(approach, zero), hn::Lt(gap, zero));
            far = hn::IfThenElse(beside, hn::Neg(hn::Set(lanes, no_hit)), far);
            index = hn::Add(index, step);
        }
    }
    FacetHit hit = nearest_lane(minus_near, facet);
    hit.distance = -hit.distance;
    const double leave = hn::GetLane(hn::MinOfLanes(lanes, far));
    const bool met = hit.distance <= leave && hit.distance + leave > 0.0;
    return met ? hit : FacetHit{};
}

}  // namespace pol::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pol {
HWY_EXPORT(exit_kernel);
HWY_EXPORT(enter_kernel);

FacetHit exit_planes(std::span<const PlaneBlock> blocks, const DVec3& o, const DVec3& d, int skip) {
    return HWY_DYNAMIC_DISPATCH(exit_kernel)(blocks.data(), blocks.size(), o, d, skip);
}

FacetHit enter_planes(std::span<const PlaneBlock> blocks, const DVec3& o, const DVec3& d) {
    return HWY_DYNAMIC_DISPATCH(enter_kernel)(blocks.data(), blocks.size(), o, d);
}

}  // namespace pol
#endif
