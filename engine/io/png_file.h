// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/result.h"
#include "maps/colorize.h"

namespace pol {

/// Writes 8-bit sRGB as PNG; crash safe (io/output_file.h).
/// Error: kind output if the file cannot be written, kind usage if the picture has no pixels.
Result<Done> write_png(const RgbPicture& picture, const std::filesystem::path& path);

}  // namespace pol
