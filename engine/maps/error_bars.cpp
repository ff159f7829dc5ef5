// SPDX-License-Identifier: Apache-2.0
#include "maps/error_bars.h"

#include <algorithm>
#include <cmath>

namespace pol {

std::optional<MeasureBounds<double>> error_bars(const StokesImage& image, std::size_t wavelength, std::size_t pixel) {
    const double brightest = image.brightest.empty() ? 0.0 : image.brightest[wavelength];
    const double surplus = image.plane_value(image.tail, wavelength, pixel) * brightest;
    const double missing = image.plane_value(image.residual, wavelength, pixel) * brightest + surplus;
    const auto is_amount = [](double light) { return std::isfinite(light) && light >= 0.0; };
    if (!is_amount(missing) || !is_amount(surplus)) return std::nullopt;
    return measure_bounds(image.at(wavelength, pixel), missing, surplus);
}

double half_width(const Interval<double>& bar, double estimate) {
    return std::max(bar.high - estimate, estimate - bar.low);
}

}  // namespace pol
