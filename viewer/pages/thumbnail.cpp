// SPDX-License-Identifier: Apache-2.0
#include "viewer/pages/thumbnail.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/contract.h"
#include "maps/color_picture.h"

namespace pol {

namespace {

/// Looked at in each direction of a part of the picture.
constexpr int looks = 4;

bool is_finite(const Rgb& color) {
    return std::isfinite(color[0]) && std::isfinite(color[1]) && std::isfinite(color[2]);
}

/// Mean color of the pixels x0 <= x < x1, y0 <= y < y1.
Rgb mean_color(const StokesImage& picture, const std::vector<Rgb>& weights, int x0, int y0, int x1, int y1) {
    const int step_x = std::max(1, (x1 - x0) / looks);
    const int step_y = std::max(1, (y1 - y0) / looks);
    Rgb sum{};
    double count = 0.0;
    for (int y = y0; y < y1; y += step_y) {
        for (int x = x0; x < x1; x += step_x) {
            Rgb color{};
            for (std::size_t b = 0; b < weights.size(); ++b)
                for (std::size_t c = 0; c < 3; ++c) color[c] += weights[b][c] * picture.at(b, picture.pixel(x, y)).s0;
            if (!is_finite(color)) continue;
            for (std::size_t c = 0; c < 3; ++c) sum[c] += color[c];
            count += 1.0;
        }
    }
    if (count == 0.0) return {};
    return {sum[0] / count, sum[1] / count, sum[2] / count};
}

double brightness(const Rgb& color) {
    return std::max({color[0], color[1], color[2]});
}

}  // namespace

Thumbnail thumbnail_of(const StokesImage& picture, int side) {
    POL_EXPECTS(picture.pixel_count() > 0 && !picture.bands.empty() && side > 0);
    const double larger = std::max(picture.width, picture.height);
    const auto scaled = [&](int size) {
        const int wanted = static_cast<int>(std::lround(size * std::min(1.0, side / larger)));
        return std::clamp(wanted, 1, size);
    };
    Thumbnail small{scaled(picture.width), scaled(picture.height), {}};
    const std::vector<Rgb> weights = band_colors(picture.bands);
    std::vector<Rgb> colors;
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            const auto cut = [](int index, int of, int parts) {
                return static_cast<int>(static_cast<std::int64_t>(index) * of / parts);
            };
            colors.push_back(mean_color(picture, weights, cut(x, picture.width, small.width),
                                        cut(y, picture.height, small.height), cut(x + 1, picture.width, small.width),
                                        cut(y + 1, picture.height, small.height)));
        }
    }
    std::vector<double> bright;
    for (const Rgb& color : colors) bright.push_back(brightness(color));
    const auto white = bright.begin() + static_cast<std::ptrdiff_t>((bright.size() - 1) * 99 / 100);
    std::nth_element(bright.begin(), white, bright.end());
    const double gain = *white > 0.0 ? 1.0 / *white : 1.0;
    for (const Rgb& color : colors) small.pixels.push_back(encode({gain * color[0], gain * color[1], gain * color[2]}));
    return small;
}

}  // namespace pol
