// SPDX-License-Identifier: Apache-2.0
#include "viewer/pages/pixel_readout.h"

#include "maps/color_picture.h"
#include "maps/evaluate.h"
#include "viewer/shown/shown_picture.h"

namespace pol {

QuantityReadout PixelReadout::quantity(Quantity quantity, std::size_t band) const {
    const BandReadout& at = bands[band];
    if (info(quantity).is_over_d65 && !at.d65) return {{0.0, 0.0, PixelState::undefined}, std::nullopt};
    return read_light(at.light, quantity, at.d65.value_or(1.0));
}

PixelReadout read_pixel(const Session& session, PixelAddress address, const Convention& convention) {
    const StokesImage& picture = session.current()->picture();
    const ShownPicture shown(picture, session.polarimeter(), convention);
    const std::size_t pixel = picture.pixel(address.x, address.y);
    PixelReadout readout;
    readout.address = address;
    std::vector<double> spectrum;
    for (std::size_t w = 0; w < picture.bands.size(); ++w) {
        BandReadout at;
        at.band = picture.bands[w];
        at.light = shown.light(w, pixel);
        at.tail = picture.plane_value(picture.tail, w, pixel);
        if (!picture.brightest.empty()) at.brightest = picture.brightest[w];
        if (const auto d65 = white_of(at.band)) at.d65 = d65.value();
        readout.bands.push_back(at);
        spectrum.push_back(at.light.stokes.s0);
    }
    readout.color = weighted_color(spectrum, band_colors(picture.bands));
    readout.has_residual = !picture.residual.empty();
    if (!picture.samples.empty()) readout.samples = picture.samples[pixel];
    if (!picture.failures.empty()) readout.failures = picture.failures[pixel];
    return readout;
}

}  // namespace pol
