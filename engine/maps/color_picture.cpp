// SPDX-License-Identifier: Apache-2.0
#include "maps/color_picture.h"

#include <cstddef>

#include "core/contract.h"

namespace pol {

std::vector<Rgb> band_colors(const std::vector<Band>& bands) {
    POL_EXPECTS(!bands.empty());
    const std::vector<double> wavelengths = wavelengths_of(bands);
    if (!wavelengths.empty()) return color_weights(wavelengths);
    if (const auto primaries = rgb_bands(bands)) {
        std::vector<Rgb> colors(bands.size(), Rgb{});
        for (std::size_t c = 0; c < 3; ++c) colors[(*primaries)[c]][c] = 1.0;
        return colors;
    }
    const double share = 1.0 / static_cast<double>(bands.size());
    return std::vector<Rgb>(bands.size(), Rgb{share, share, share});
}

std::vector<Rgb> color_picture(const StokesImage& image) {
    const std::vector<Rgb> weights = band_colors(image.bands);
    std::vector<Rgb> colors(image.pixel_count());
    std::vector<double> spectrum(weights.size());
    for (std::size_t pixel = 0; pixel < colors.size(); ++pixel) {
        for (std::size_t w = 0; w < weights.size(); ++w) spectrum[w] = image.at(w, pixel).s0;
        colors[pixel] = weighted_color(spectrum, weights);
    }
    return colors;
}

}  // namespace pol
