// SPDX-License-Identifier: Apache-2.0
// A map as a picture for people: title, color bar with numbers and unit, legend of the pixels without a value.
#pragma once

#include <string>

#include "core/result.h"
#include "maps/colorize.h"

namespace pol {

/// Draws `map` with everything needed to read it. A small picture is enlarged by a whole factor (nearest pixel), so
/// that its longer side has at least 384 pixels; pixels of the map are never blended. `caption` is the second line,
/// what the picture shows (the scene); it is shortened at its end if it does not fit. Error (kind output): the picture
/// is larger than cairo can draw on (about 32,000 pixels a side).
Result<RgbPicture> map_picture(const ColoredMap& map, const std::string& caption);

}  // namespace pol
