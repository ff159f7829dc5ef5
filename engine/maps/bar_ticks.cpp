// SPDX-License-Identifier: Apache-2.0
#include "maps/bar_ticks.h"

#include <cmath>

#include "core/contract.h"

namespace pol {
namespace {

/// A step of 1, 2 or 5 times a power of ten that divides `span` into about five.
double round_step(double span) {
    const double rough = span / 5.0;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double mantissa = rough / power;
    return power * (mantissa < 1.5 ? 1.0 : mantissa < 3.5 ? 2.0 : mantissa < 7.5 ? 5.0 : 10.0);
}

}  // namespace

std::vector<double> bar_ticks(const MapRange& range, ScaleKind kind) {
    POL_EXPECTS(range.low < range.high);
    const double span = range.high - range.low;
    const double step = kind == ScaleKind::cyclic ? span / 4.0 : round_step(span);
    // Closer than this to an end, two numbers would touch.
    const double gap = 0.4 * step;
    std::vector<double> ticks{range.low};
    const double first = std::ceil(range.low / step);
    // Counted, since in a very narrow range a step may be less than the last bit of its ends.
    constexpr int most_ticks = 10;
    for (int i = 0; i < most_ticks; ++i) {
        const double tick = step * (first + i);
        if (tick - range.low > gap && range.high - tick > gap) ticks.push_back(tick);
    }
    ticks.push_back(range.high);
    return ticks;
}

std::string end_word(double tick, const MapRange& range, const ScaleWords& words) {
    if (tick == range.low && tick < 0.0 && !words.low.empty()) return " " + words.low;
    if (tick == range.high && tick > 0.0 && !words.high.empty()) return " " + words.high;
    return {};
}

}  // namespace pol
