// SPDX-License-Identifier: Apache-2.0
// The unit of work, of merging and of upload: a rectangle of pixels.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "polarization/stokes.h"

namespace pol {

/// Number of a render job; what older jobs still deliver is refused.
using Generation = std::uint64_t;

/// Number of the last change of a tile; 0: nothing yet.
using Version = std::uint64_t;

/// Pixels x0 <= x < x1, y0 <= y < y1.
struct TileRect {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;
    [[nodiscard]] int width() const { return x1 - x0; }
    [[nodiscard]] int height() const { return y1 - y0; }
    [[nodiscard]] std::size_t pixel_count() const {
        return static_cast<std::size_t>(x1 - x0) * static_cast<std::size_t>(y1 - y0);
    }
    friend bool operator==(const TileRect&, const TileRect&) = default;
};

/// Whether they have a pixel in common.
inline bool meet(const TileRect& a, const TileRect& b) {
    return std::max(a.x0, b.x0) < std::min(a.x1, b.x1) && std::max(a.y0, b.y0) < std::min(a.y1, b.y1);
}

/// The tiles of a picture, row by row; those at the right and lower border may be smaller than `size`.
inline std::vector<TileRect> cut_tiles(int width, int height, int size) {
    std::vector<TileRect> tiles;
    for (int y = 0; y < height; y += size)
        for (int x = 0; x < width; x += size)
            tiles.push_back({x, y, std::min(x + size, width), std::min(y + size, height)});
    return tiles;
}

/// One finished pass over a tile or some of its pixels, owned by one worker. Index: which of these pixels * count +
/// wavelength or group.
struct TileBuffer {
    Generation generation = 0;
    TileRect rect{};
    /// In the rectangle, counted row by row; empty: all.
    std::vector<std::uint32_t> pixels;
    std::uint32_t samples = 0;  ///< that each of these pixels got in this pass
    /// Passes over other pixels of the rectangle follow at once: the error of the tile is measured after the last.
    bool more_follow = false;
    std::vector<Stokes<double>> stokes;
    /// Sum of the odd samples minus that of the even ones, counted from 0. Empty if the picture needs no estimate of
    /// its sampling error; then it is empty in every pass of the job.
    std::vector<Stokes<double>> odd_minus_even;
    std::vector<double> residual;
    std::vector<double> tail;
    std::vector<std::uint32_t> failures;

    [[nodiscard]] std::size_t pixel_count() const { return pixels.empty() ? rect.pixel_count() : pixels.size(); }
    /// In the rectangle, of the pixel with that index in the other vectors.
    [[nodiscard]] std::size_t pixel(std::size_t index) const { return pixels.empty() ? index : pixels[index]; }
};

/// A row of preview blocks: one sample stands for a block of `stride` x `stride` pixels. Index: column * count +
/// wavelength or group.
struct PreviewStrip {
    Generation generation = 0;
    int stride = 8;
    int row = 0;  ///< the strip covers the lines row * stride to (row + 1) * stride - 1
    std::vector<Stokes<double>> stokes;
    std::vector<double> residual;
    std::vector<double> tail;
};

}  // namespace pol
