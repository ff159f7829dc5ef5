// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/result.h"
#include "scene/light.h"

namespace pol {

/// Reads a PNG (any color type, 1 to 16 bits, interlaced or not) of at most 64 Mi pixels as linear sRGB.
///
/// Samples are taken as sRGB unless the file says otherwise (gAMA without sRGB); color profiles are not applied.
/// Transparent parts emit nothing: color is multiplied by alpha. Errors (kind input) name the file: missing, not a PNG,
/// damaged, too large.
Result<RgbImage> load_texture(const std::filesystem::path& path);

}  // namespace pol
