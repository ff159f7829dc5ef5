// SPDX-License-Identifier: Apache-2.0
// Sixteen rays at once against the planes of a HalfSpaceSolid: float lanes find the facet, double decides.
#pragma once

#include <vector>

#include "core/vec.h"
#include "geometry/half_space_solid.h"

namespace pol {

/// Rays side by side, as the widest float registers hold them. Directions are unit to 1e-9.
struct alignas(64) RayBlock {
    static constexpr int size = 16;
    double origin[3][size];
    double direction[3][size];
};

inline void set_ray(RayBlock& rays, int lane, const DVec3& origin, const DVec3& direction) {
    for (int axis = 0; axis < 3; ++axis) {
        rays.origin[axis][lane] = origin[axis];
        rays.direction[axis][lane] = direction[axis];
    }
}
inline DVec3 origin_of(const RayBlock& rays, int lane) {
    return {rays.origin[0][lane], rays.origin[1][lane], rays.origin[2][lane]};
}
inline DVec3 direction_of(const RayBlock& rays, int lane) {
    return {rays.direction[0][lane], rays.direction[1][lane], rays.direction[2][lane]};
}

/// What they meet; the normal is of the facet met, of no meaning where there is none.
struct alignas(64) HitBlock {
    double distance[RayBlock::size];
    double normal[3][RayBlock::size];
    int facet[RayBlock::size];  ///< -1: nothing
};

/// One plane in the frame of the solid's ball, whose radius is 1 there.
struct FloatPlane {
    float x, y, z, offset;
};

/// What a scan knows of its solid.
///
/// With u = 2^-24, in the ball's frame, for |o| <= reach, |d| = |n| = 1 and |offset| <= 1:
///     along = fl(n.d + along_margin) >= n.d: inputs 2u, products and sums 3u, times sum |n_i d_i| <= 1, and u for the
///             margin: 6u;
///     ahead = fl(offset - ahead_margin - n.o) <= offset - n.o: u of the offset, 5u |o| of n.o, and twice u (1 + |o|)
///             for the differences: 3u + 7u reach.
/// Fused operations round less. The margins are wider than that, by what the exact scan itself may err in double, too.
struct PlaneScanFrame {
    DVec3 center{};
    double per_radius = 0.0;
    double radius = 0.0;
    float along_margin = 0.0F;
    float exit_margin = 0.0F;
    float enter_margin = 0.0F;
    double exit_reach2 = 0.0;
    double enter_reach2 = 0.0;  ///< of origins before they are moved to the ball
};

// Float quotients and the comparison round by less than four parts in 2^24.
constexpr double scan_slack = 1.0 - 0x1p-21;
// Of distances from up to 1e3 radii away, in radii: 1e3 * 2^-53 a few times over.
constexpr double enter_slack = 1e-11;
// An origin that was moved to the ball lies within sqrt(2) radii of the centre if its ray meets the ball.
constexpr double enter_start_reach2 = 2.1;

/// Same answers as HalfSpaceSolid::exit and enter, to the bit, for a block of rays and with any instruction set.
///
/// Float lanes keep the smallest two of certified bounds of all distances. The distance to the first facet is then
/// computed in double as the exact scan does; if it lies before the second bound, every other plane lies farther. What
/// is too close to call takes the exact scan: rays through edges, along faces, from far away.
/// Thread safety: const members from any thread.
class PlaneScan {
public:
    /// The solid must outlive the scan.
    explicit PlaneScan(const HalfSpaceSolid& solid);

    /// As `skip`: this lane holds no ray, and what is found for it means nothing.
    static constexpr int no_ray = -2;

    /// The first `count` rays, from inside or from the boundary; `skip` as in HalfSpaceSolid::exit, or no_ray. Returns
    /// how many took the exact scan.
    int exit(const RayBlock& rays, const int (&skip)[RayBlock::size], int count, HitBlock& hits) const;

    /// The first `count` rays, from outside, none of which has just left the solid.
    int enter(const RayBlock& rays, int count, HitBlock& hits) const;

private:
    void set_hit(const FacetHit& hit, int lane, HitBlock& hits) const;

    const HalfSpaceSolid& solid_;
    PlaneScanFrame frame_{};
    std::vector<FloatPlane> planes_;
};

}  // namespace pol
