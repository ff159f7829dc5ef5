// SPDX-License-Identifier: Apache-2.0
// The rigorous error bar of each pixel, from the light that was not traced (CUTTING.md 1.2).
#pragma once

#include <cstddef>
#include <optional>

#include "film/stokes_image.h"
#include "maps/pixel_light.h"
#include "polarization/bounds.h"

namespace pol {

/// Bars of all measures of the light. Empty if the bar is not a number: missing or surplus is negative or not finite.
std::optional<MeasureBounds<double>> error_bars(const PixelLight& light);
std::optional<MeasureBounds<double>> error_bars(const StokesImage& image, std::size_t band, std::size_t pixel);

/// Largest distance of a point of `bar` from `estimate`.
double half_width(const Interval<double>& bar, double estimate);

}  // namespace pol
