// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "film/band.h"
#include "film/stokes_image.h"
#include "polarization/stokes.h"

namespace pol {

/// The light of one pixel at one wavelength with what is known about its error: all that a map is made from.
struct PixelLight {
    Stokes<double> stokes{};  ///< 0 where not known
    StokesComponents known = StokesComponents::all();
    double missing = 0.0;   ///< most S0 that may have been left out, (residual + tail) brightest
    double surplus = 0.0;   ///< most S0 that may be there too much, tail brightest
    double residual = 0.0;  ///< share of the throughput that was not traced
    double samples = -1.0;  ///< of the pixel; negative: the picture does not tell
    /// The picture tells what was not traced. One that does not, another program's, has no bounds: they are not 0.
    bool is_bounded = true;
    /// Light that the arithmetic had in hand: what is nothing but rounding beside it is no light. 0: not known.
    double scale = 0.0;
    double peak = 0.0;  ///< S0 that the picture's brightest pixel has for sure (peak_of); 0: not known
    double rounding = StoredNumbers{}.rounding();  ///< largest relative error of the numbers of `stokes`
    double step = StoredNumbers{}.step();          ///< and the distance of neighbours among the smallest
};

/// A picture without residual or without brightest has no light missing, as far as it says.
PixelLight pixel_light(const StokesImage& image, std::size_t band, std::size_t pixel);

}  // namespace pol
