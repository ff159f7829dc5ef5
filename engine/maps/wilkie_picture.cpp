// SPDX-License-Identifier: Apache-2.0
#include "maps/wilkie_picture.h"

#include <algorithm>
#include <cmath>

#include "core/hypot.h"
#include "maps/evaluate.h"

namespace pol {
namespace {

Rgb color_of(WilkiePicture picture, const Stokes<double>& s) {
    const double linear = hypot(s.s1, s.s2);
    const double polarized = hypot(linear, s.s3);
    if (!(s.s0 > 0.0) || polarized == 0.0) return {};
    const double degree = polarized / s.s0;
    const double l = linear / polarized;
    const double c = std::abs(s.s3) / polarized;
    const auto positive = [&](double part) { return std::max(0.0, part / s.s0); };
    switch (picture) {
        case WilkiePicture::degree:
            return {degree, 0.0, 0.0};
        case WilkiePicture::type:
            return {c * degree, (l + c) * degree, l * degree};
        case WilkiePicture::orientation:
            return {l * (positive(-s.s1) + positive(s.s2)), l * (positive(s.s1) + positive(s.s2)), l * positive(-s.s2)};
        case WilkiePicture::chirality:
            return {c * positive(-s.s3), c * positive(-s.s3), c * positive(s.s3)};
    }
    return {};
}

}  // namespace

Result<RgbPicture> wilkie_picture(const StokesImage& image, std::optional<std::size_t> band,
                                  const WilkiePictureInfo& which) {
    const std::size_t first = band.value_or(0);
    const std::size_t last = band ? first + 1 : image.bands.size();
    for (std::size_t b = first; b < last; ++b)
        if (!image.bands[b].known.has(which.needs))
            return Error{ErrorKind::input,
                         "band " + image.bands[b].label() + " does not have all Stokes components",
                         {},
                         std::string(which.name),
                         "the picture needs S0 to S3; maps dolp and azimuth need S0 to S2"};
    RgbPicture picture{image.width, image.height, {}};
    picture.pixels.reserve(image.pixel_count());
    for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel) {
        PixelLight light;
        light.rounding = image.stored.rounding();
        light.step = static_cast<double>(last - first) * image.stored.step();
        for (std::size_t b = first; b < last; ++b) light.stokes += image.at(b, pixel);
        const PixelState state = evaluate_light(light, Quantity::dop, 1.0).state;
        const bool is_defect = state == PixelState::not_a_number || state == PixelState::unphysical;
        picture.pixels.push_back(is_defect ? state_color(state, 0, 0) : encode(color_of(which.picture, light.stokes)));
    }
    return picture;
}

}  // namespace pol
