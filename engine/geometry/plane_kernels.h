// SPDX-License-Identifier: Apache-2.0
// The inner loops of HalfSpaceSolid, compiled once per instruction set and chosen at run time.
#pragma once

#include <span>

#include "core/vec.h"
#include "geometry/hit.h"

namespace pol {

/// Eight planes side by side, as wide as the widest registers. Unused places hold normal 0 and offset 1: never met.
struct alignas(64) PlaneBlock {
    double normal_x[8], normal_y[8], normal_z[8], offset[8];
};

/// See HalfSpaceSolid::exit.
FacetHit exit_planes(std::span<const PlaneBlock> blocks, const DVec3& o, const DVec3& d, int skip);

/// See HalfSpaceSolid::enter, skip = -1.
FacetHit enter_planes(std::span<const PlaneBlock> blocks, const DVec3& o, const DVec3& d);

}  // namespace pol
