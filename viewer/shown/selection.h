// SPDX-License-Identifier: Apache-2.0
// What the user points at: one selection for every panel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "film/film.h"
#include "maps/colorize.h"

namespace pol {

struct PixelAddress {
    int x = 0;
    int y = 0;
    friend bool operator==(const PixelAddress&, const PixelAddress&) = default;
};

struct Selection {
    std::optional<PixelAddress> hovered;  ///< pixel under the cursor
    std::vector<PixelAddress> pins;       ///< pinned pixels, the current one included
    int current = -1;                     ///< index into pins; -1: none
    std::uint32_t sample = 0;             ///< of the pinned pixel that is explained; 0 is its centre
    std::optional<int> node;              ///< branch of the current pin's tree: index into RayTree::nodes
    std::vector<bool> marked;             ///< by pixel, brushed in a histogram or on the sphere; empty: none
    std::uint64_t marked_version = 0;     ///< grows whenever pixels are marked
    std::optional<MapRange> brushed;      ///< values whose pixels are marked; none: they were chosen otherwise
    std::optional<TileRect> region;       ///< rectangle drawn in the picture, inside it

    [[nodiscard]] std::optional<PixelAddress> pinned() const {
        if (current < 0 || current >= static_cast<int>(pins.size())) return std::nullopt;
        return pins[static_cast<std::size_t>(current)];
    }
};

}  // namespace pol
