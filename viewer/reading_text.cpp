// SPDX-License-Identifier: Apache-2.0
#include "viewer/reading_text.h"

#include <fmt/format.h>

namespace pol {

std::string_view state_text(PixelState state) {
    switch (state) {
        case PixelState::defined:
            return "";
        case PixelState::no_light:
            return "no light";
        case PixelState::undefined:
            return "undefined";
        case PixelState::undetermined:
            return "not determined";
        case PixelState::not_a_number:
            return "not a number";
    }
    return "";
}

std::string short_number(double value, int digits) {
    return fmt::format("{:.{}g}", value == 0.0 ? 0.0 : value, digits);
}

std::string reading_text(Quantity quantity, const QuantityReading& reading) {
    if (reading.pixel.state != PixelState::defined) return std::string(state_text(reading.pixel.state));
    const std::string_view unit = info(quantity).unit;
    const std::string after = unit.empty() || unit == "\u00b0" ? std::string(unit) : fmt::format(" {}", unit);
    const std::string value = short_number(reading.pixel.value, 6);
    const auto bar = reading.half_width();
    if (!bar || *bar == 0.0) return value + after;
    return fmt::format("{}{} \u00b1 {}{}", value, after, short_number(*bar, 2), after);
}

}  // namespace pol
