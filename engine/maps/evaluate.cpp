// SPDX-License-Identifier: Apache-2.0
// The formulas of the maps, and of their bars. shaders/evaluate.glsl has the same ones in single precision.
#include "maps/evaluate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contract.h"
#include "core/result.h"
#include "core/units.h"
#include "maps/error_bars.h"
#include "spectrum/illuminant.h"

namespace pol {
namespace {

constexpr MapPixel empty(PixelState state) {
    return {0.0, 0.0, state};
}

MapPixel number(double value) {
    return std::isfinite(value) ? MapPixel{value} : empty(PixelState::not_a_number);
}

/// What a map of the polarization state shows, if what carries the property is there.
struct Reading {
    double value = 0.0;
    double spread = 0.0;  // width of the bar, half of the quantity's range being 1
};

double spread_of(const Interval<double>& bar, double range) {
    return bar.width() / (range / 2.0);
}

Reading read(Quantity quantity, const Stokes<double>& s, const Measures<double>& m, const MeasureBounds<double>& bars) {
    switch (quantity) {
        case Quantity::dop:
            return {m.dop, spread_of(bars.dop, 1.0)};
        case Quantity::dolp:
            return {m.dolp, spread_of(bars.dolp, 1.0)};
        case Quantity::docp:
            return {m.docp, spread_of(bars.docp, 1.0)};
        case Quantity::ellipticity:
            return {m.ellipticity, spread_of(bars.ellipticity, 1.0)};
        case Quantity::handedness:
            // sin(2 chi) = S3 / p, from the angle that Measures has in its stable form.
            return {std::sin(2.0 * m.ellipticity_angle), spread_of(bars.ellipticity_angle, pi / 2.0)};
        case Quantity::azimuth:
            return {degrees(m.azimuth), bars.azimuth / (pi / 4.0)};
        case Quantity::s1:
            return {s.s1 / s.s0, bars.s1.width() / s.s0};
        case Quantity::s2:
            return {s.s2 / s.s0, bars.s2.width() / s.s0};
        case Quantity::s3:
            return {s.s3 / s.s0, bars.s3.width() / s.s0};
        case Quantity::dop_error:
            return {half_width(bars.dop, m.dop)};
        case Quantity::ellipticity_error:
            return {half_width(bars.ellipticity, m.ellipticity)};
        case Quantity::azimuth_error:
            return {degrees(bars.azimuth)};
        case Quantity::color:
        case Quantity::intensity:
        case Quantity::residual:
        case Quantity::unphysical:
        case Quantity::samples:
        case Quantity::poincare:
            break;
    }
    POL_EXPECTS(false);
    return {};
}

/// Bar of a Stokes component divided by S0: the part of share_bounds (polarization/bounds.h) that counts for a signed
/// one.
Interval<double> signed_share(double part, const Interval<double>& bar, const PixelLight& light) {
    const double least = light.stokes.s0 + light.missing - light.surplus;
    if (!(least > 0.0)) return {-1.0, 1.0};
    const double limit = std::max(1.0, std::abs(part) / light.stokes.s0);
    return {std::max(-limit, bar.low / least), std::min(limit, bar.high / least)};
}

/// What is no light shows itself here, too: on the GPU one number tells both.
MapPixel evaluate_samples(const PixelLight& light) {
    if (light.samples < 0.0) return empty(PixelState::not_measured);
    const double unphysical = unphysical_part(light);
    if (std::isnan(unphysical)) return empty(PixelState::not_a_number);
    return unphysical > 0.0 ? empty(PixelState::unphysical) : number(light.samples);
}

}  // namespace

double unphysical_part(const PixelLight& light) {
    const Stokes<double>& s = light.stokes;
    // Nearly all light, at a tenth of the cost: within these limits no square leaves the range of numbers.
    constexpr double least = 1e-140;
    constexpr double most = 1e140;
    if (s.s0 > least && s.s0 < most && s.s1 * s.s1 + s.s2 * s.s2 + s.s3 * s.s3 <= s.s0 * s.s0) return 0.0;
    const double polarized = polarized_part(s);
    if (!std::isfinite(s.s0) || !std::isfinite(polarized)) return std::numeric_limits<double>::quiet_NaN();
    if (s.s0 == 0.0 && polarized == 0.0) return 0.0;
    const double excess = polarized - s.s0;
    const double size = polarized + std::abs(s.s0);
    return excess > light.rounding * size + 2.0 * light.step ? excess / size : 0.0;
}

Result<double> white_of(const Band& band) {
    return band.wavelength_nm ? d65_at(*band.wavelength_nm) : Result<double>(1.0);
}

std::string_view unit_of(Quantity quantity, const Band& band) {
    const QuantityInfo& about = info(quantity);
    return about.is_over_d65 && !band.wavelength_nm ? std::string_view() : about.unit;
}

MapPixel evaluate_light(const PixelLight& light, Quantity quantity, double d65) {
    POL_EXPECTS(quantity != Quantity::color);
    if (!light.known.has(info(quantity).needs)) return empty(PixelState::not_measured);
    if (info(quantity).is_of_bounds() && !light.is_bounded) return empty(PixelState::not_measured);
    if (info(quantity).of_two) return empty(PixelState::undefined);
    const Stokes<double>& s = light.stokes;
    if (quantity == Quantity::intensity) return number(s.s0 / d65);
    if (quantity == Quantity::residual) return number(light.residual);
    if (quantity == Quantity::unphysical) return number(unphysical_part(light));
    if (quantity == Quantity::samples) return evaluate_samples(light);

    const bool is_number = std::isfinite(s.s0) && std::isfinite(polarized_part(s)) && std::isfinite(light.missing) &&
                           std::isfinite(light.surplus);
    if (!is_number) return empty(PixelState::not_a_number);
    const Measures<double> m = measure(s, pixel_noise);
    const auto bars = error_bars(light);
    if (!std::isfinite(m.dop) || !bars) return empty(PixelState::unphysical);
    // Crossed polarizers leave a rounding error of the light that they stop: 1e-33 of it is no light.
    if (bars->s0.high <= pixel_noise * light.scale) return empty(PixelState::no_light);
    const PixelState unknown = bars->s0.high < dark_share * light.peak ? PixelState::dark : PixelState::undetermined;
    if (!m.has_light) return empty(bars->s0.high > 0.0 ? unknown : PixelState::no_light);

    const QuantityInfo& about = info(quantity);
    const Reading reading = read(quantity, s, m, *bars);
    const bool is_linear = about.carrier == Carrier::linear_part;
    const bool is_there = about.carrier == Carrier::light || (is_linear ? m.has_azimuth : m.has_polarization);
    // Where the polarized part is known to be next to nothing, its direction is not unknown but without meaning.
    const double most = is_linear ? bars->dolp.high : bars->dop.high;
    const bool is_unpolarized = about.fades() && most < full_weight_polarization;
    const bool is_determined = reading.spread < 1.0;
    if (!is_determined && !is_unpolarized) return empty(unknown);
    if (!is_there || !is_determined) return empty(PixelState::undefined);
    const double polarization = is_linear ? m.dolp : m.dop;
    const double weight = about.fades() ? std::min(1.0, polarization / full_weight_polarization) : 1.0;
    return {reading.value, weight, PixelState::defined, 1.0 - reading.spread};
}

std::optional<Interval<double>> error_bar(const PixelLight& light, Quantity quantity, double d65) {
    POL_EXPECTS(quantity != Quantity::color);
    if (!light.known.has(info(quantity).needs)) return std::nullopt;
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
        case Quantity::samples:
        case Quantity::poincare:
            return std::nullopt;
    }
    return std::nullopt;
}

MapPixel evaluate_pixel(const StokesImage& image, Quantity quantity, std::size_t band, std::size_t pixel, double d65) {
    return evaluate_light(pixel_light(image, band, pixel), quantity, d65);
}

Result<Map> evaluate(const StokesImage& image, Quantity quantity, std::size_t band) {
    POL_EXPECTS(band < image.bands.size());
    double d65 = 1.0;
    if (info(quantity).is_over_d65) {
        POL_TRY(const auto known, white_of(image.bands[band]));
        d65 = known;
    }
    const double peak = image.peak.empty() ? peak_of(image, band) : image.peak[band];
    Map map{quantity, image.bands[band], false, image.width, image.height, {}};
    map.pixels.reserve(image.pixel_count());
    for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel) {
        PixelLight light = pixel_light(image, band, pixel);
        light.peak = peak;
        map.pixels.push_back(evaluate_light(light, quantity, d65));
    }
    return map;
}

}  // namespace pol
