// SPDX-License-Identifier: Apache-2.0
#include "film/strata.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/contract.h"
#include "film/film_sums.h"
#include "polarization/coherence_matrix.h"

namespace pol {

namespace {

/// Pixels in the noisiest strata together, as shares of the picture: fine steps where much is to be had.
constexpr std::array<double, most_strata - 1> noisiest_shares{0.01, 0.02, 0.03, 0.05, 0.08,
                                                              0.12, 0.17, 0.25, 0.35, 0.5};

/// How many pixels each stratum gets, quietest first.
std::vector<std::size_t> stratum_sizes(std::size_t pixels) {
    std::vector<std::size_t> sizes;
    std::size_t sorted = 0;
    for (const double share : noisiest_shares) {
        const auto end = static_cast<std::size_t>(share * static_cast<double>(pixels));
        if (end < sorted + Strata::fewest_pixels || pixels - end < Strata::fewest_pixels) continue;
        sizes.push_back(end - sorted);
        sorted = end;
    }
    sizes.push_back(pixels - sorted);
    std::reverse(sizes.begin(), sizes.end());
    return sizes;
}

}  // namespace

Strata FilmSums::stratify() const {
    const auto width = static_cast<std::size_t>(layout.width);
    const auto height = static_cast<std::size_t>(layout.height);
    std::vector<const Stokes<double>*> light(width * height);
    std::vector<double> noise(width * height);
    const std::uint32_t samples = tiles.front().samples.front();
    for (const TileSums& tile : tiles) {
        for (std::size_t pixel = 0; pixel < tile.samples.size(); ++pixel) {
            POL_EXPECTS(tile.samples[pixel] == samples && samples >= 2);
            const auto row = static_cast<std::size_t>(tile.rect.width());
            const std::size_t at = (static_cast<std::size_t>(tile.rect.y0) + pixel / row) * width +
                                   static_cast<std::size_t>(tile.rect.x0) + pixel % row;
            light[at] = &tile.stokes[pixel * wavelengths()];
            noise[at] = half_error(tile, pixel);
        }
    }

    const double share = 1.0 / samples;
    const auto step = [&](std::size_t one, std::size_t other) {
        double sum = 0.0;
        for (std::size_t w = 0; w < wavelengths(); ++w)
            sum += frobenius_square(share * (light[one][w] - light[other][w]));
        return sum;
    };
    std::vector<double> likely(width * height);
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t left = x > 0 ? 1 : 0;
            const std::size_t right = x + 1 < width ? 1 : 0;
            const std::size_t up = y > 0 ? 1 : 0;
            const std::size_t down = y + 1 < height ? 1 : 0;
            const std::size_t here = y * width + x;
            double around = 0.0;
            for (std::size_t row = y - up; row <= y + down; ++row)
                for (std::size_t column = x - left; column <= x + right; ++column)
                    if (row != y || column != x) around += noise[row * width + column];
            const auto neighbors = static_cast<double>((up + down + 1) * (left + right + 1) - 1);
            double edge = 0.0;
            if (left + right == 2) edge = std::max(edge, step(here - 1, here + 1));
            if (up + down == 2) edge = std::max(edge, step(here - width, here + width));
            if (left + right + up + down == 4)
                edge = std::max(
                    {edge, step(here - width - 1, here + width + 1), step(here - width + 1, here + width - 1)});
            likely[here] = around / std::max(neighbors, 1.0) + edge / 16.0;
            if (std::isnan(likely[here])) likely[here] = std::numeric_limits<double>::infinity();
        }
    }

    Strata sorted;
    sorted.width = layout.width;
    sorted.pixels = stratum_sizes(likely.size());
    std::vector<std::uint32_t> order(likely.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return likely[a] != likely[b] ? likely[a] < likely[b] : a < b; });
    sorted.of_picture.resize(likely.size());
    std::size_t next = 0;
    for (std::size_t stratum = 0; stratum < sorted.pixels.size(); ++stratum)
        for (std::size_t i = 0; i < sorted.pixels[stratum]; ++i)
            sorted.of_picture[order[next++]] = static_cast<std::uint8_t>(stratum);
    return sorted;
}

}  // namespace pol
