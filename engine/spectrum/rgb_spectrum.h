// SPDX-License-Identifier: Apache-2.0
// A smooth emission spectrum under D65 for any linear sRGB color, after Mallett and Yuksel, "Spectral Primary
// Decomposition for Rendering with sRGB Reflectance" (EGSR 2019). The basis is our own:
// assets/observer/make_rgb_basis.py.
#pragma once

#include <array>

#include "core/result.h"

namespace pol {

/// Spectra of the three primaries at a vacuum wavelength, already times D65 (1 at 560 nm): the color (r, g, b) emits
/// r basis[0] + g basis[1] + b basis[2]. White emits D65. On the wavelength lists 380:780:1 and 380:780:20,
/// color_weights() gives the color back.
///
/// Linear between 5 nm nodes; below 380 and above 780 nm the shares of the end nodes hold on.
/// Error (kind input) outside D65, 300 to 830 nm.
Result<std::array<double, 3>> rgb_basis_at(double wavelength_nm);

}  // namespace pol
