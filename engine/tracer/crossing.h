// SPDX-License-Identifier: Apache-2.0
// The next thing that a ray meets, given the region it is in.
#pragma once

#include "core/vec.h"
#include "plan/plan.h"

namespace pol {

/// A ray meets a body. `body` is -1 if it meets nothing.
struct Crossing {
    double distance = 0.0;
    int body = -1;
    int facet = -1;
    int triangle = -1;  ///< of a mesh
    DVec3 normal{};     ///< outward unit normal of the body there
    DVec2 uv{};         ///< place on an open surface, 0..1 along its x and y
};

/// Nearest candidate of `region` along the ray. Thread safety: const, any thread.
Crossing next_crossing(const Plan& plan, const Region& region, const DVec3& origin, const DVec3& direction,
                       const Left& left);

/// Whether a ray in an open region (Region::is_open) surely enters no solid. Far cheaper than next_crossing(), which
/// then finds a surface that ends the ray, or nothing.
bool misses_solids(const Plan& plan, const Region& region, const DVec3& origin, const DVec3& direction,
                   const Left& left);

/// What lies behind a solid's boundary at `point`: the region on the other side and the facet that a ray arriving there
/// has just left (that of a touching solid, if one is entered through a common face). region -1: numerical failure.
struct FarSide {
    int region = -1;
    Left left{};
    bool black = false;  ///< the face was declared to swallow all light
};
FarSide far_side(const Plan& plan, int region, const Crossing& crossing, const DVec3& point);

}  // namespace pol
