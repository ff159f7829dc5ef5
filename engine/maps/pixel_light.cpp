// SPDX-License-Identifier: Apache-2.0
#include "maps/pixel_light.h"

namespace pol {

PixelLight pixel_light(const StokesImage& image, std::size_t wavelength, std::size_t pixel) {
    const double brightest = image.brightest.empty() ? 0.0 : image.brightest[wavelength];
    PixelLight light;
    light.stokes = image.at(wavelength, pixel);
    light.surplus = image.plane_value(image.tail, wavelength, pixel) * brightest;
    light.residual = image.plane_value(image.residual, wavelength, pixel);
    light.missing = light.residual * brightest + light.surplus;
    light.scale = brightest;
    light.rounding = image.stored.rounding();
    return light;
}

}  // namespace pol
