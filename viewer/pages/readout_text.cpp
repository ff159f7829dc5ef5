// SPDX-License-Identifier: Apache-2.0
#include "viewer/pages/readout_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pol {

namespace {

/// Of a bar as far to both sides: two digits; of an interval: a thousandth of its width or finer.
constexpr int bar_digits = 2;
constexpr int interval_digits = 3;
/// What is added up to a multiple of a step is off by so much of it.
constexpr double slack = 1e-9;

int exponent_of(double value) {
    return static_cast<int>(std::floor(std::log10(std::abs(value))));
}

double power_of_ten(int exponent) {
    return std::pow(10.0, exponent);
}

/// `count` steps of 10^`step`, in as few letters as say it.
std::string steps_text(double count, int step) {
    const double value = step < 0 ? count / power_of_ten(-step) : count * power_of_ten(step);
    if (value == 0.0) return "0";
    const double size = std::abs(value);
    if (size < 1e-4 || size >= 1e7) return short_number(value, std::max(1, exponent_of(value) - step + 1));
    std::string text = fmt::format("{:.{}f}", value, std::max(0, -step));
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string with_unit(const std::string& number, std::string_view unit) {
    return unit.empty() || unit == "\u00b0" ? number + std::string(unit) : fmt::format("{} {}", number, unit);
}

/// The value to a multiple of 10^`step`, or to `digits` digits if those are fewer.
std::string rounded_text(double value, int step, int digits) {
    if (value == 0.0) return "0";
    const int used = std::max(step, exponent_of(value) - digits + 1);
    return steps_text(std::round(value / power_of_ten(used)), used);
}

std::string interval_text(const Interval<double>& bar, int step, std::string_view unit) {
    const double low = std::floor(bar.low / power_of_ten(step) + slack);
    const double high = std::ceil(bar.high / power_of_ten(step) - slack);
    const std::string_view each = unit == "\u00b0" ? unit : "";
    return with_unit(fmt::format("[{}{}, {}{}]", steps_text(low, step), each, steps_text(high, step), each),
                     each.empty() ? unit : "");
}

Interval<double> without_rounding(Interval<double> bar, double rounding) {
    if (std::abs(bar.low) <= rounding) bar.low = 0.0;
    if (std::abs(bar.high) <= rounding) bar.high = 0.0;
    return bar;
}

int interval_step(const Interval<double>& bar) {
    return exponent_of(bar.width()) - interval_digits + 1;
}

}  // namespace

std::string_view state_text(PixelState state) {
    switch (state) {
        case PixelState::defined:
            return "";
        case PixelState::no_light:
            return "no light";
        case PixelState::dark:
            return "dark";
        case PixelState::undefined:
            return "undefined";
        case PixelState::undetermined:
            return "not determined";
        case PixelState::not_a_number:
            return "not a number";
        case PixelState::unphysical:
            return "unphysical";
        case PixelState::not_measured:
            return "not measured";
    }
    return "";
}

std::string_view state_definition(PixelState state) {
    switch (state) {
        case PixelState::defined:
            return "";
        case PixelState::no_light:
            return "no light: S0, what was left out included, is nothing but rounding";
        case PixelState::dark:
            return "dark: S0, what was left out included, is below a thousandth of that of the brightest pixel, and "
                   "too "
                   "little of it was traced to tell more";
        case PixelState::undefined:
            return "undefined: light without the property, such as the azimuth of unpolarized or circular light";
        case PixelState::undetermined:
            return "not determined: so much light was not traced that the value may lie anywhere in half of its range";
        case PixelState::not_a_number:
            return "not a number: NaN or infinite, a defect of the renderer";
        case PixelState::unphysical:
            return "unphysical: S0 or the residual is negative, or there is polarized light without S0; a defect of "
                   "the "
                   "renderer";
        case PixelState::not_measured:
            return "not measured: the picture does not have all Stokes components that this needs, such as S3";
    }
    return "";
}

std::string missing_text(StokesComponents needed, StokesComponents known) {
    std::vector<std::string> missing;
    for (unsigned component = 0; component < 4; ++component)
        if (needed.has(component) && !known.has(component)) missing.push_back("S" + std::to_string(component));
    std::string text;
    for (std::size_t i = 0; i < missing.size(); ++i)
        text += (i == 0 ? "" : i + 1 == missing.size() ? " and " : ", ") + missing[i];
    return missing.empty() ? text : text + (missing.size() == 1 ? " was not measured" : " were not measured");
}

std::string band_text(const Band& band) {
    return band.wavelength_nm ? short_number(*band.wavelength_nm, 6) + " nm" : band.name;
}

std::string short_number(double value, int digits) {
    return fmt::format("{:.{}g}", value == 0.0 ? 0.0 : value, digits);
}

std::string short_number(double value, int digits, double size) {
    return short_number(std::abs(value) <= pixel_noise * std::abs(size) ? 0.0 : value, digits);
}

NumberText number_text(double value, const std::optional<Interval<double>>& bar, double rounding, int digits,
                       std::string_view unit) {
    const double shown = std::abs(value) <= rounding ? 0.0 : value;
    const double up = bar ? std::max(0.0, bar->high - value) : 0.0;
    const double down = bar ? std::max(0.0, value - bar->low) : 0.0;
    const double half = std::max(up, down);
    if (!(half > rounding) || !std::isfinite(half)) return {with_unit(short_number(shown, digits), unit), {}};

    const int step = exponent_of(half) - bar_digits + 1;
    const auto steps_up = [&](double part) { return std::ceil(part / power_of_ten(step) - slack); };
    if (steps_up(up) == steps_up(down))
        return {with_unit(rounded_text(shown, step, digits), unit),
                "\u00b1 " + with_unit(steps_text(steps_up(half), step), unit)};
    const Interval<double> ends = without_rounding(*bar, rounding);
    return {with_unit(rounded_text(shown, interval_step(ends), digits), unit),
            interval_text(ends, interval_step(ends), unit)};
}

std::string interval_text(const Interval<double>& bar, double rounding, std::string_view unit) {
    const Interval<double> ends = without_rounding(bar, rounding);
    return ends.width() > 0.0 ? interval_text(ends, interval_step(ends), unit) : std::string();
}

std::string readout_text(Quantity quantity, const QuantityReadout& readout) {
    const std::string_view unit = info(quantity).unit;
    NumberText text{std::string(state_text(readout.pixel.state)), {}};
    if (readout.pixel.state == PixelState::defined)
        text = number_text(readout.pixel.value, readout.bar, readout.rounding, 6, unit);
    else if (may_be_any(readout.pixel.state) && readout.bar)
        text.bar = interval_text(*readout.bar, readout.rounding, unit);
    return text.bar.empty() ? text.value : text.value + " " + text.bar;
}

std::string value_text(Quantity quantity, const QuantityReadout& readout, int digits) {
    if (readout.pixel.state != PixelState::defined) return std::string(state_text(readout.pixel.state));
    return number_text(readout.pixel.value, readout.bar, readout.rounding, digits, info(quantity).unit).value;
}

}  // namespace pol
