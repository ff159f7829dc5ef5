// SPDX-License-Identifier: Apache-2.0
// Flat polygons of any outline, cut into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/result.h"
#include "core/vec.h"

namespace pol {

/// Cuts the inside of a polygon into triangles of its corners (indices into `corners`, which wind as the polygon does).
/// Every corner is used, also those in the middle of a side; a corner at the place of the one before it is left out.
/// Errors, whose text continues "the face": more than 10,000 corners, all in one line, not flat (corners off
/// the plane by more than a thousandth of the width that six digits of the coordinates do not explain), sides that
/// cross or touch, as they do where a cut leads to a hole. Time: square of the number of corners.
Result<std::vector<std::array<std::uint32_t, 3>>> cut_polygon(std::span<const DVec3> corners);

}  // namespace pol
