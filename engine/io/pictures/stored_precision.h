// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "film/stokes_image.h"
#include "io/pictures/number_format.h"

namespace pol {

/// Fills in StokesImage::stored; a remark says where numbers are whole.
inline void note_precision(StokesImage& image, const NumberFormat& format) {
    image.stored.bits = format.kind == NumberFormat::Kind::float16 ? 16 : 32;
    image.stored.spacing = format.is_whole() ? 1.0 : 0.0;
    if (format.is_whole()) image.origin.remarks.emplace_back("The numbers are whole: each may be wrong by a half.");
}

}  // namespace pol
