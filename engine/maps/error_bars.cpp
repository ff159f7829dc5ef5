// SPDX-License-Identifier: Apache-2.0
#include "maps/error_bars.h"

#include <algorithm>
#include <cmath>

namespace pol {

namespace {

bool is_amount(double light) {
    return std::isfinite(light) && light >= 0.0;
}

}  // namespace

std::optional<MeasureBounds<double>> error_bars(const PixelLight& light) {
    if (!is_amount(light.missing) || !is_amount(light.surplus)) return std::nullopt;
    return measure_bounds(light.stokes, light.missing, light.surplus);
}

std::optional<MeasureBounds<double>> error_bars(const StokesImage& image, std::size_t band, std::size_t pixel) {
    return error_bars(pixel_light(image, band, pixel));
}

double half_width(const Interval<double>& bar, double estimate) {
    return std::max(bar.high - estimate, estimate - bar.low);
}

}  // namespace pol
