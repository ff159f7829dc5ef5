// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/result.h"
#include "maps/colorize.h"

namespace pol {

/// The bytes of a PNG file with 8-bit sRGB. Empty if there is no memory to make it in, or the picture has no pixels.
std::vector<std::uint8_t> png_bytes(const RgbPicture& picture);

/// Writes 8-bit sRGB as PNG; crash safe (io/files/output_file.h).
/// Error: kind output if the file cannot be written, kind usage if the picture has no pixels.
Result<Done> write_png(const RgbPicture& picture, const std::filesystem::path& path);

}  // namespace pol
