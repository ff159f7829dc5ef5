// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstddef>
#include <utility>

#include "io/live/live_sender.h"
#include "io/pictures/exr_channel.h"
#include "spectrum/color.h"

namespace pol {
namespace {

/// What each band adds to R, G and B; empty if the picture has no color.
std::vector<Rgb> weights_of(const std::vector<Band>& bands) {
    if (const auto places = rgb_bands(bands)) {
        std::vector<Rgb> weights(bands.size());
        for (std::size_t c = 0; c < places->size(); ++c) weights[(*places)[c]][c] = 1.0;
        return weights;
    }
    const std::vector<double> wavelengths = wavelengths_of(bands);
    return wavelengths.empty() ? std::vector<Rgb>{} : color_weights(wavelengths);
}

std::string suffix_of(const std::vector<Band>& bands, const Band& band) {
    if (band.wavelength_nm) return "." + wavelength_suffix(*band.wavelength_nm);
    return bands.size() == 1 ? std::string() : "." + band.name;
}

}  // namespace

std::vector<std::string> live_channels(const std::vector<Band>& bands) {
    std::vector<std::string> names;
    if (!weights_of(bands).empty()) names = {"R", "G", "B"};
    for (unsigned s = 0; s < stokes_components.size(); ++s)
        for (const Band& band : bands)
            if (band.known.has(s)) names.push_back("S" + std::to_string(s) + suffix_of(bands, band));
    return names;
}

std::vector<float> live_planes(const StokesImage& image) {
    const std::size_t pixels = image.pixel_count();
    std::vector<float> planes;
    planes.reserve(live_channels(image.bands).size() * pixels);
    if (const auto weights = weights_of(image.bands); !weights.empty()) {
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t p = 0; p < pixels; ++p) {
                double sum = 0.0;
                // A band without a part in a color must not make it NaN.
                for (std::size_t b = 0; b < image.bands.size(); ++b)
                    if (weights[b][c] != 0.0) sum += weights[b][c] * image.at(b, p).s0;
                planes.push_back(static_cast<float>(sum));
            }
        }
    }
    for (unsigned s = 0; s < stokes_components.size(); ++s)
        for (std::size_t b = 0; b < image.bands.size(); ++b)
            for (std::size_t p = 0; p < pixels && image.bands[b].known.has(s); ++p)
                planes.push_back(static_cast<float>(image.at(b, p).*stokes_components[s]));
    return planes;
}

LiveSource source_of(const StokesImage& picture, std::string name) {
    constexpr int tile_size = 128;
    LiveSource source{std::move(name), picture.width, picture.height, picture.bands, {}, {}};
    const auto tiles = cut_tiles(picture.width, picture.height, tile_size);
    source.tile_count = [count = static_cast<int>(tiles.size())] { return count; };
    source.tile_if_newer = [&picture, tiles](int tile, Version& seen) -> std::optional<TileSnapshot> {
        if (seen > 0) return std::nullopt;
        seen = 1;
        TileSnapshot snapshot;
        snapshot.rect = tiles[static_cast<std::size_t>(tile)];
        StokesImage& part = snapshot.image;
        part.width = snapshot.rect.width();
        part.height = snapshot.rect.height();
        part.bands = picture.bands;
        part.stokes.reserve(picture.bands.size() * part.pixel_count());
        for (std::size_t b = 0; b < picture.bands.size(); ++b)
            for (int y = snapshot.rect.y0; y < snapshot.rect.y1; ++y)
                for (int x = snapshot.rect.x0; x < snapshot.rect.x1; ++x)
                    part.stokes.push_back(picture.at(b, picture.pixel(x, y)));
        return snapshot;
    };
    return source;
}

}  // namespace pol
