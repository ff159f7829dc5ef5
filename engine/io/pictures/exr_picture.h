// SPDX-License-Identifier: Apache-2.0
// The EXR side of picture_file.h: one file, or one for each Stokes component.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "io/pictures/exr_layout.h"
#include "io/pictures/picture_file.h"

namespace pol {

/// True if the file begins as EXR files do.
bool is_exr_file(const std::filesystem::path& path);
/// Those that are EXR files, by the first that there is of them.
bool is_exr_picture(const PictureSource& source);

/// As read_picture and read_picture_header.
Result<StokesImage> read_exr_picture(const PictureSource& source, const ReadProgress& progress);
Result<PictureHeader> read_exr_picture_header(const PictureSource& source);

std::span<const PictureLayout> exr_layouts();

namespace exr {

/// What a file says before its layout is looked for.
struct Label {
    std::vector<std::string> channels;  ///< of all parts, ascending
    std::string renderer;               ///< wave_tracer writes one
    std::string convention;             ///< polariscope convert writes one
};
Result<Label> read_label(const std::filesystem::path& path);

Result<PictureHeader> read_header(const std::filesystem::path& path, const Wish& wish);
Result<StokesImage> read_one(const std::filesystem::path& path, const Wish& wish, const ReadProgress& progress);

}  // namespace exr
}  // namespace pol
