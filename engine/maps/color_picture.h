// SPDX-License-Identifier: Apache-2.0
// The picture as it looks: S0 through the CIE 1931 observer.
#pragma once

#include <vector>

#include "film/stokes_image.h"
#include "spectrum/color.h"

namespace pol {

/// Linear sRGB of S0 = 1 in each band: by the CIE observer and D65 for wavelengths (color_weights); bands R, G and B
/// are those primaries; other names tell of no color: gray, the mean of the bands.
std::vector<Rgb> band_colors(const std::vector<Band>& bands);

/// Linear sRGB of each pixel, not cut to the gamut. One wavelength gives gray: S0 relative to D65 there, as in Debelov
/// & Kozlov, Figs. 10, 14 and 18. A pixel with NaN or infinite light has NaN or infinite color. Error (kind usage): the
/// only wavelength is one where D65 is not known.
std::vector<Rgb> color_picture(const StokesImage& image);

}  // namespace pol
