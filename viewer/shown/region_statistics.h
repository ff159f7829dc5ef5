// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "film/film.h"
#include "viewer/shown/shown_picture.h"

namespace pol {

/// The light of a rectangle in one band. Pixels count whose numbers are finite and which have a sample.
struct RegionStatistics {
    std::size_t count = 0;
    std::size_t left_out = 0;  ///< pixels that do not count
    PixelLight mean{};         ///< their mean light, with the mean of what is known of its error
    /// Standard deviation of each component from pixel to pixel (divided by count - 1); 0 of a single one.
    Stokes<double> deviation{};
};

/// Requires: the rectangle lies inside the picture and is not empty, band < bands.size().
RegionStatistics region_statistics(const ShownPicture& picture, std::size_t band, const TileRect& region);

/// One band of a part of a picture, as a picture of its own: numbers, residual, tail, `brightest` and place, not its
/// samples. Requires: as region_statistics.
StokesImage cut_out(const StokesImage& picture, std::size_t band, const TileRect& region);

}  // namespace pol
