// SPDX-License-Identifier: Apache-2.0
// The picture in single precision, as its textures hold it: the border at which the window leaves double. What single
// precision would lose is worked out before: light behind the polarimeter (crossed polarizers leave 0, not 1e-8), and
// how far a Stokes vector is from being light.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "film/film.h"
#include "spectrum/color.h"
#include "viewer/shown/shown_picture.h"

namespace pol {

using Float4 = std::array<float, 4>;

/// Rounds to nearest. What is larger than a float can be becomes infinite, and is shown as such; what is smaller than
/// 1e-38 loses digits.
inline float to_single(double value) {
    return static_cast<float>(value);
}
inline Float4 to_single(double a, double b, double c, double d) {
    return {to_single(a), to_single(b), to_single(c), to_single(d)};
}

/// One wavelength of a part of the picture, row by row.
struct LightFloats {
    std::vector<Float4> stokes;  ///< S0, S1, S2, S3
    /// Residual, S0 of the tail, samples of the pixel (0: not known) or, if its light is none, minus its
    /// unphysical_part; S0 that is no light, -1: no sample yet.
    std::vector<Float4> left_out;
};
LightFloats light_floats(const ShownPicture& shown, std::size_t wavelength, const TileRect& rect);

/// Color of a part of the picture, row by row: for red, green and blue what S0, S1, S2 and S3 give. Color is linear, so
/// the color behind any polarimeter is a scalar product with the first row of its Mueller matrix.
using ColorFloats = std::array<std::vector<Float4>, 3>;
/// `weights` as color_weights() has them for the picture.
ColorFloats color_floats(const StokesImage& picture, std::span<const Rgb> weights, const TileRect& rect);

}  // namespace pol
