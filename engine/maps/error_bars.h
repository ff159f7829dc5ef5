// SPDX-License-Identifier: Apache-2.0
// The rigorous error bar of each pixel, from the light that was not traced (performance.md 3.3).
#pragma once

#include <cstddef>
#include <optional>

#include "film/stokes_image.h"
#include "polarization/bounds.h"

namespace pol {

/// Bars of all measures at a pixel: missing light up to (residual + tail) brightest, surplus light up to tail
/// brightest. A picture without residual or without brightest has no light missing as far as it says: bars of width 0.
/// Empty if the bar is not a number: residual, tail or brightest is negative or not finite there.
std::optional<MeasureBounds<double>> error_bars(const StokesImage& image, std::size_t wavelength, std::size_t pixel);

/// Largest distance of a point of `bar` from `estimate`.
double half_width(const Interval<double>& bar, double estimate);

}  // namespace pol
