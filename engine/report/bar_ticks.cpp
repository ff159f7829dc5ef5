// SPDX-License-Identifier: Apache-2.0
#include "report/bar_ticks.h"

#include <cmath>

#include "core/contract.h"
#include "report/round_step.h"

namespace pol {
std::vector<double> bar_ticks(const MapRange& range, ScaleKind kind) {
    POL_EXPECTS(range.low < range.high);
    const double span = range.high - range.low;
    const double step = kind == ScaleKind::cyclic ? span / 4.0 : round_step(span / 5.0);
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
