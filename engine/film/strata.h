// SPDX-License-Identifier: Apache-2.0
// Which pixels are alike in how much error samples take away: so that they can be spent where they are worth most, and
// the estimate of the error stays honest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "film/tile.h"

namespace pol {

inline constexpr std::size_t most_strata = 11;

/// The pixels of a picture, sorted by how large their sampling error is likely to be: stratum 0 is the quietest.
///
/// A pixel is judged by its eight neighbors alone, never by its own samples. Whoever gives samples to pixels that look
/// noisy leaves the others with those that look quiet by luck, and the estimate of what is left (ErrorSums) comes out
/// too small, down to a third. The samples of different pixels are independent (sample_position), so the neighbors of a
/// pixel know nothing of the luck of its own halves: whatever is decided by them, its ||h||^2 keeps the mean that it
/// had. The sums over a stratum then tell what more samples are worth there (this is Neyman's allocation: J. Neyman,
/// "On the two different aspects of the representative method", J. R. Stat. Soc. 97, 1934); that they are sums over
/// many pixels keeps luck out of them, too, as good as: hence fewest_pixels.
///
/// The likely error is W + F/16. W: mean of ||h||^2 over the neighbors, noise of random tails and textures. F: largest
/// ||m_i - m_j||_F^2 of two neighbors opposite each other, an edge between them: a pixel that an edge of the step D
/// divides into a and 1 - a has the variance a (1 - a) D^2 / N, which is D^2/16 at most for the four samples after
/// which pixels are sorted. At the border of the picture pairs that it cuts do not count.
struct Strata {
    /// A stratum has at least so many, but for pictures that have fewer than twice as many.
    static constexpr std::size_t fewest_pixels = 64;

    int width = 0;                         ///< of the picture
    std::vector<std::uint8_t> of_picture;  ///< by pixel, row by row
    std::vector<std::size_t> pixels;       ///< how many, by stratum

    /// `pixel`: counted row by row in the rectangle.
    [[nodiscard]] std::uint8_t of_pixel(const TileRect& rect, std::size_t pixel) const {
        const auto row = static_cast<std::size_t>(rect.width());
        const std::size_t y = static_cast<std::size_t>(rect.y0) + pixel / row;
        const std::size_t x = static_cast<std::size_t>(rect.x0) + pixel % row;
        return of_picture[y * static_cast<std::size_t>(width) + x];
    }
    [[nodiscard]] double bytes() const { return static_cast<double>(of_picture.capacity()); }
};

}  // namespace pol
