// SPDX-License-Identifier: Apache-2.0
// From a spectrum, known at a list of wavelengths, to what the eye sees: CIE 1931 2-degree observer, XYZ, sRGB
// (IEC 61966-2-1).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace pol {

using Xyz = std::array<double, 3>;
using Rgb = std::array<double, 3>;  ///< linear sRGB unless said otherwise; not cut to the gamut

/// CIE 1931 color matching functions, linear between the 1 nm nodes; 0 outside 360 to 830 nm, where the observer is
/// blind.
Xyz color_matching(double wavelength_nm);

/// Linear sRGB primaries and white point D65 (x = 0.3127, y = 0.3290); white (1, 1, 1) has Y = 1.
Xyz to_xyz(const Rgb& linear);
Rgb to_linear_srgb(const Xyz& xyz);

/// The sRGB transfer curve and its inverse. Negative numbers take the straight part; nothing is cut.
double srgb_encode(double linear);
double srgb_decode(double encoded);
/// Linear value of every code from 0 to `most` of a PNG file, by its gAMA of `gamma`, or by the sRGB curve if that is 0
/// or as good as 1/2.2, which is how writers say "sRGB, roughly".
std::vector<double> decoding_table(std::size_t most, double gamma);

/// Trapezoid rule on an ascending list, in nm: the integral of f is the sum of weight * f. A single wavelength has
/// weight 1.
std::vector<double> trapezoid_weights(std::span<const double> wavelengths_nm);

/// Weights for which the linear sRGB color of a spectrum is the sum of weights[i] * value[i] over the list.
///
/// X, Y and Z are trapezoid sums, each scaled so that D65 (1 at 560 nm) on the same list is white, (1, 1, 1), however
/// coarse the list is. One wavelength therefore gives gray: the value relative to D65 there, as in the paper. A channel
/// that no wavelength of the list excites (Z beyond 650 nm) takes the weights of Y. A list without any visible
/// wavelength gives the mean value as gray. Requires: ascending, not empty.
std::vector<Rgb> color_weights(std::span<const double> wavelengths_nm);

/// Sum of weights[i] * values[i]. Requires: as many values as weights.
Rgb weighted_color(std::span<const double> values, std::span<const Rgb> weights);

}  // namespace pol
