// SPDX-License-Identifier: Apache-2.0
#include "maps/error_bars.h"

#include <algorithm>
#include <cmath>

#include "core/contract.h"
#include "core/units.h"
#include "polarization/measures.h"

namespace pol {

namespace {

bool is_amount(double light) {
    return std::isfinite(light) && light >= 0.0;
}

/// Bar of a Stokes component divided by S0: the part of share_bounds (polarization/bounds.h) that counts for a signed
/// one.
Interval<double> signed_share(double part, const Interval<double>& bar, const PixelLight& light) {
    const double least = light.stokes.s0 + light.missing - light.surplus;
    if (!(least > 0.0)) return {-1.0, 1.0};
    const double limit = std::max(1.0, std::abs(part) / light.stokes.s0);
    return {std::max(-limit, bar.low / least), std::min(limit, bar.high / least)};
}

}  // namespace

std::optional<MeasureBounds<double>> error_bars(const PixelLight& light) {
    if (!is_amount(light.missing) || !is_amount(light.surplus)) return std::nullopt;
    return measure_bounds(light.stokes, light.missing, light.surplus);
}

std::optional<MeasureBounds<double>> error_bars(const StokesImage& image, std::size_t wavelength, std::size_t pixel) {
    return error_bars(pixel_light(image, wavelength, pixel));
}

std::optional<Interval<double>> error_bar(const PixelLight& light, Quantity quantity, double d65) {
    POL_EXPECTS(quantity != Quantity::color);
    const auto bars = error_bars(light);
    if (!bars || !(light.stokes.s0 > 0.0)) return std::nullopt;
    const Stokes<double>& s = light.stokes;
    switch (quantity) {
        case Quantity::intensity:
            return Interval<double>{bars->s0.low / d65, bars->s0.high / d65};
        case Quantity::dop:
            return bars->dop;
        case Quantity::dolp:
            return bars->dolp;
        case Quantity::docp:
            return bars->docp;
        case Quantity::ellipticity:
            return bars->ellipticity;
        case Quantity::azimuth: {
            const double azimuth = degrees(measure(s).azimuth);
            return Interval<double>{azimuth - degrees(bars->azimuth), azimuth + degrees(bars->azimuth)};
        }
        case Quantity::handedness:
            return Interval<double>{std::sin(2.0 * bars->ellipticity_angle.low),
                                    std::sin(2.0 * bars->ellipticity_angle.high)};
        case Quantity::s1:
            return signed_share(s.s1, bars->s1, light);
        case Quantity::s2:
            return signed_share(s.s2, bars->s2, light);
        case Quantity::s3:
            return signed_share(s.s3, bars->s3, light);
        case Quantity::color:
        case Quantity::residual:
        case Quantity::dop_error:
        case Quantity::ellipticity_error:
        case Quantity::azimuth_error:
        case Quantity::unphysical:
            break;
    }
    return std::nullopt;
}

double half_width(const Interval<double>& bar, double estimate) {
    return std::max(bar.high - estimate, estimate - bar.low);
}

}  // namespace pol
