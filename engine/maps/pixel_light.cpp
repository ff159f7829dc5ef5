// SPDX-License-Identifier: Apache-2.0
#include "maps/pixel_light.h"

namespace pol {

PixelLight pixel_light(const StokesImage& image, std::size_t band, std::size_t pixel) {
    const double brightest = image.brightest.empty() ? 0.0 : image.brightest[band];
    PixelLight light;
    light.known = image.bands[band].known;
    light.stokes = image.at(band, pixel);
    light.surplus = image.plane_value(image.tail, band, pixel) * brightest;
    if (!image.samples.empty()) light.samples = image.samples[pixel];
    light.is_bounded = !image.residual.empty();
    light.residual = image.plane_value(image.residual, band, pixel);
    light.missing = light.residual * brightest + light.surplus;
    light.scale = brightest;
    if (!image.peak.empty()) light.peak = image.peak[band];
    light.rounding = image.stored.rounding();
    light.step = image.stored.step();
    return light;
}

}  // namespace pol
