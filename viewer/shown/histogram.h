// SPDX-License-Identifier: Apache-2.0
// How often each value of the shown map occurs, and which pixels have it.
#pragma once

#include <cstddef>
#include <vector>

#include "maps/colorize.h"
#include "viewer/shown/shown_map.h"

namespace pol {

struct Histogram {
    MapRange range{};
    std::vector<std::size_t> bins;  ///< equal parts of the range; a value at its upper end counts in the last one
    std::size_t below = 0;
    std::size_t above = 0;
    /// Largest count of a bin; 0: no pixel has a value in the range.
    [[nodiscard]] std::size_t highest() const;
};

/// Counts the defined values of the rows that are known. Requires: range.low < range.high, bins > 0.
Histogram histogram_of(const ShownMap& map, const MapRange& range, std::size_t bins);

/// Pixels with a defined value in [range.low, range.high], give or take the rounding of 32-bit floats.
std::vector<bool> pixels_in(const ShownMap& map, const MapRange& range);

/// Pixels of one state.
std::vector<bool> pixels_of(const ShownMap& map, PixelState state);

}  // namespace pol
