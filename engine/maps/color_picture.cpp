// SPDX-License-Identifier: Apache-2.0
#include "maps/color_picture.h"

#include <cstddef>

#include "core/contract.h"

namespace pol {

std::vector<Rgb> color_picture(const StokesImage& image) {
    POL_EXPECTS(!image.wavelengths_nm.empty());
    const std::vector<Rgb> weights = color_weights(image.wavelengths_nm);
    std::vector<Rgb> colors(image.pixel_count());
    std::vector<double> spectrum(weights.size());
    for (std::size_t pixel = 0; pixel < colors.size(); ++pixel) {
        for (std::size_t w = 0; w < weights.size(); ++w) spectrum[w] = image.at(w, pixel).s0;
        colors[pixel] = weighted_color(spectrum, weights);
    }
    return colors;
}

}  // namespace pol
