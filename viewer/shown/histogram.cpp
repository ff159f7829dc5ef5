// SPDX-License-Identifier: Apache-2.0
#include "viewer/shown/histogram.h"

#include <algorithm>
#include <cmath>

#include "core/contract.h"

namespace pol {

namespace {

/// The range with room for rounding to the 32-bit floats of a file: fully polarized light is not above 1.
MapRange with_rounding(const MapRange& range) {
    const double slack = 0x1p-22 * std::max(std::abs(range.low), std::abs(range.high));
    return {range.low - slack, range.high + slack};
}

}  // namespace

std::size_t Histogram::highest() const {
    return bins.empty() ? 0 : *std::max_element(bins.begin(), bins.end());
}

Histogram histogram_of(const ShownMap& map, const MapRange& range, std::size_t bins) {
    POL_EXPECTS(range.low < range.high && bins > 0);
    Histogram result{range, std::vector<std::size_t>(bins), 0, 0};
    const MapRange wide = with_rounding(range);
    const double per_value = static_cast<double>(bins) / (range.high - range.low);
    for (std::size_t pixel = 0; pixel < map.values().size(); ++pixel) {
        if (map.states()[pixel] != PixelState::defined) continue;
        const double value = map.values()[pixel];
        if (value < wide.low)
            ++result.below;
        else if (value > wide.high)
            ++result.above;
        else
            ++result.bins[std::min(bins - 1, static_cast<std::size_t>(std::max(0.0, (value - range.low) * per_value)))];
    }
    return result;
}

std::vector<bool> pixels_in(const ShownMap& map, const MapRange& range) {
    const MapRange wide = with_rounding(range);
    std::vector<bool> marked(map.values().size());
    for (std::size_t pixel = 0; pixel < marked.size(); ++pixel) {
        const double value = map.values()[pixel];
        marked[pixel] = map.states()[pixel] == PixelState::defined && value >= wide.low && value <= wide.high;
    }
    return marked;
}

std::vector<bool> pixels_of(const ShownMap& map, PixelState state) {
    std::vector<bool> marked(map.states().size());
    for (std::size_t pixel = 0; pixel < marked.size(); ++pixel) marked[pixel] = map.states()[pixel] == state;
    return marked;
}

}  // namespace pol
