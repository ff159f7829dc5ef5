// SPDX-License-Identifier: Apache-2.0
// The rigorous error bar of each pixel, from the light that was not traced (CUTTING.md 1.2).
#pragma once

#include <cstddef>
#include <optional>

#include "film/stokes_image.h"
#include "maps/pixel_light.h"
#include "maps/quantity.h"
#include "polarization/bounds.h"

namespace pol {

/// Bars of all measures of the light. Empty if the bar is not a number: missing or surplus is negative or not finite.
std::optional<MeasureBounds<double>> error_bars(const PixelLight& light);
std::optional<MeasureBounds<double>> error_bars(const StokesImage& image, std::size_t wavelength, std::size_t pixel);

/// The bar of one quantity, in its unit. Empty: the bar is not a number, there is no S0 to divide by, or the quantity
/// has no bar (residual and error bars are bounds themselves). The bar of the azimuth may reach beyond +-90 degrees: it
/// is one of directions. `d65` as in evaluate_light. Requires: quantity is not `color`.
std::optional<Interval<double>> error_bar(const PixelLight& light, Quantity quantity, double d65);

/// Largest distance of a point of `bar` from `estimate`.
double half_width(const Interval<double>& bar, double estimate);

}  // namespace pol
