// SPDX-License-Identifier: Apache-2.0
// Pictures that are no EXR: arrays of numpy (.npy, .npz), photographs of cameras (PNG), cubes of radio astronomy
// (FITS).
#pragma once

#include <span>

#include "core/result.h"
#include "film/stokes_image.h"
#include "io/pictures/picture_file.h"

namespace pol {

/// True if the file begins like one of these; with several files, if all do. False if one cannot be read.
bool is_array_file(const PictureSource& source);

/// Those that may be asked for by name.
std::span<const PictureLayout> array_layouts();

/// As read_picture_header. R, G and B of a tensor are listed, though they may turn out to be one band when they are
/// read.
Result<PictureHeader> read_array_header(const PictureSource& source);

/// As read_picture. Requires: is_array_file(source).
Result<StokesImage> read_array_picture(const PictureSource& source, const ReadProgress& progress = {});

}  // namespace pol
