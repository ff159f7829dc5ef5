// SPDX-License-Identifier: Apache-2.0
#include "viewer/pages/pixel_reading.h"

#include "spectrum/illuminant.h"
#include "viewer/shown/shown_picture.h"

namespace pol {

QuantityReading PixelReading::quantity(Quantity quantity, std::size_t wavelength) const {
    const WavelengthReading& at = wavelengths[wavelength];
    if (info(quantity).is_over_d65 && !at.d65) return {{0.0, 0.0, PixelState::undefined}, std::nullopt};
    return read_light(at.light, quantity, at.d65.value_or(1.0));
}

PixelReading read_pixel(const Session& session, PixelAddress address, const Convention& convention) {
    const StokesImage& picture = session.current()->picture();
    const ShownPicture shown(picture, session.polarimeter(), convention);
    const std::size_t pixel = picture.pixel(address.x, address.y);
    PixelReading reading;
    reading.address = address;
    std::vector<double> spectrum;
    for (std::size_t w = 0; w < picture.wavelengths_nm.size(); ++w) {
        WavelengthReading at;
        at.wavelength_nm = picture.wavelengths_nm[w];
        at.light = shown.light(w, pixel);
        at.tail = picture.plane_value(picture.tail, w, pixel);
        if (!picture.brightest.empty()) at.brightest = picture.brightest[w];
        if (const auto d65 = d65_at(at.wavelength_nm)) at.d65 = d65.value();
        reading.wavelengths.push_back(at);
        spectrum.push_back(at.light.stokes.s0);
    }
    reading.color = weighted_color(spectrum, color_weights(picture.wavelengths_nm));
    if (!picture.samples.empty()) reading.samples = picture.samples[pixel];
    if (!picture.failures.empty()) reading.failures = picture.failures[pixel];
    return reading;
}

}  // namespace pol
