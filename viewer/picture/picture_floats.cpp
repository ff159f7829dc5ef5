// SPDX-License-Identifier: Apache-2.0
#include "viewer/picture/picture_floats.h"

#include <algorithm>

#include "core/contract.h"
#include "maps/evaluate.h"

namespace pol {

LightFloats light_floats(const ShownPicture& shown, std::size_t wavelength, const TileRect& rect) {
    const StokesImage& picture = shown.picture();
    LightFloats floats;
    floats.stokes.reserve(rect.pixel_count());
    floats.left_out.reserve(rect.pixel_count());
    for (int y = rect.y0; y < rect.y1; ++y) {
        const std::size_t row = picture.pixel(rect.x0, y);
        for (std::size_t pixel = row; pixel < row + static_cast<std::size_t>(rect.width()); ++pixel) {
            const PixelLight light = shown.light(wavelength, pixel);
            const Stokes<double>& s = light.stokes;
            const bool is_preview = !picture.residual.empty() && light.residual < 1.0;
            const bool is_known = picture.samples.empty() || picture.samples[pixel] > 0 || is_preview;
            floats.stokes.push_back(to_single(s.s0, s.s1, s.s2, s.s3));
            const double unphysical = unphysical_part(light);
            floats.left_out.push_back(to_single(light.residual, light.surplus,
                                                unphysical == 0.0 ? std::max(light.samples, 0.0) : -unphysical,
                                                is_known ? pixel_noise * light.scale : -1.0));
        }
    }
    return floats;
}

ColorFloats color_floats(const StokesImage& picture, std::span<const Rgb> weights, const TileRect& rect) {
    POL_EXPECTS(weights.size() == picture.bands.size());
    ColorFloats floats;
    for (auto& channel : floats) channel.reserve(rect.pixel_count());
    const auto width = static_cast<std::size_t>(rect.width());
    std::vector<std::array<Stokes<double>, 3>> sums(width);
    for (int y = rect.y0; y < rect.y1; ++y) {
        std::fill(sums.begin(), sums.end(), std::array<Stokes<double>, 3>{});
        const std::size_t row = picture.pixel(rect.x0, y);
        for (std::size_t w = 0; w < weights.size(); ++w) {
            const Stokes<double>* light = &picture.at(w, row);
            for (std::size_t x = 0; x < width; ++x) {
                for (std::size_t c = 0; c < 3; ++c) sums[x][c] += weights[w][c] * light[x];
            }
        }
        for (const auto& sum : sums) {
            for (std::size_t c = 0; c < 3; ++c)
                floats[c].push_back(to_single(sum[c].s0, sum[c].s1, sum[c].s2, sum[c].s3));
        }
    }
    return floats;
}

}  // namespace pol
