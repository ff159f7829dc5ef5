// SPDX-License-Identifier: Apache-2.0
// The accumulator: per pixel and wavelength the summed Stokes vector, and what is known about its error.
#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include "film/stokes_image.h"
#include "polarization/stokes.h"

namespace pol {

/// Number of a render job; what older jobs still deliver is refused.
using Generation = std::uint64_t;

struct FilmLayout {
    int width = 0;
    int height = 0;
    /// Wavelength group that each wavelength belongs to; residual and tail are kept per group.
    std::vector<int> group_of_wavelength;
    int group_count = 1;
};

/// Pixels x0 <= x < x1, y0 <= y < y1.
struct TileRect {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;
    [[nodiscard]] int width() const { return x1 - x0; }
    [[nodiscard]] std::size_t pixel_count() const {
        return static_cast<std::size_t>(x1 - x0) * static_cast<std::size_t>(y1 - y0);
    }
};

/// One finished pass over a tile, owned by one worker. Index: pixel in the tile (row by row) * count + wavelength or
/// group.
struct TileBuffer {
    Generation generation = 0;
    TileRect rect{};
    std::uint32_t samples = 0;  ///< that every pixel of the tile got in this pass
    std::vector<Stokes<double>> stokes;
    std::vector<double> residual;
    std::vector<double> tail;
    std::vector<std::uint32_t> failures;
};

/// Sums over samples in the camera frame.
///
/// The sum of a pixel is formed pass by pass, in the order in which merge() is called for its tile: callers deliver the
/// passes of a tile in order, and the picture does not depend on threads or tile sizes.
/// Thread safety: any member from any thread.
class Film {
public:
    /// Empties the film for a new job.
    void reset(const FilmLayout& layout, Generation generation);

    /// Adds one finished pass of a tile. Returns false, and drops it, if it belongs to an older generation.
    bool merge(const TileBuffer& tile);

    /// Means of what is there now; wavelengths, brightest and attributes are left to the caller.
    [[nodiscard]] StokesImage snapshot() const;

    /// Bytes held per pixel.
    [[nodiscard]] double bytes_per_pixel() const;

private:
    mutable std::mutex mutex_;  // guards all members below
    Generation generation_ = 0;
    FilmLayout layout_{};
    std::vector<Stokes<double>> stokes_;
    std::vector<double> residual_;
    std::vector<double> tail_;  // empty until a tail is delivered
    std::vector<std::uint32_t> samples_;
    std::vector<std::uint32_t> failures_;  // empty until a failure is delivered
};

}  // namespace pol
