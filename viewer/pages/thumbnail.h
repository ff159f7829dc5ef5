// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "film/stokes_image.h"
#include "maps/color_scale.h"

namespace pol {

/// A picture at a size at which it is only to be recognized: its color, so exposed that all but the brightest hundredth
/// is below white. Row 0 is the top row.
struct Thumbnail {
    int width = 0;
    int height = 0;
    std::vector<Rgb8> pixels;
};

/// At most `side` pixels wide and high, at least one of each. A pixel is the mean of at most 16 spread over its part of
/// the picture, so that a large picture costs no more than a small one. Black where no number is finite. Requires: the
/// picture has a pixel and a band, side > 0.
Thumbnail thumbnail_of(const StokesImage& picture, int side);

}  // namespace pol
