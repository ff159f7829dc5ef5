// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "film/stokes_image.h"
#include "io/pictures/number_format.h"

namespace pol {

/// Fills in StokesImage::stored. Whole numbers have no relative precision; they are taken for halves, and a remark says
/// so.
inline void note_precision(StokesImage& image, const NumberFormat& format) {
    const bool is_coarse = format.kind == NumberFormat::Kind::float16 || format.is_whole();
    image.stored.bits = is_coarse ? 16 : 32;
    if (format.is_whole()) image.origin.remarks.emplace_back("The numbers are whole: each may be wrong by a half.");
}

}  // namespace pol
