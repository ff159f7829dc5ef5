// SPDX-License-Identifier: Apache-2.0
#include "film/film.h"

#include <algorithm>

#include "core/contract.h"

namespace pol {

void Film::reset(const FilmLayout& layout, Generation generation) {
    POL_EXPECTS(layout.width > 0 && layout.height > 0);
    const std::scoped_lock lock(mutex_);
    generation_ = generation;
    layout_ = layout;
    const auto pixels = static_cast<std::size_t>(layout.width) * static_cast<std::size_t>(layout.height);
    stokes_.assign(pixels * layout.group_of_wavelength.size(), {});
    residual_.assign(pixels * static_cast<std::size_t>(layout.group_count), 0.0);
    samples_.assign(pixels, 0);
    tail_ = {};
    failures_ = {};
}

namespace {

bool any_nonzero(const auto& values) {
    return std::any_of(values.begin(), values.end(), [](auto v) { return v != 0; });
}

}  // namespace

bool Film::merge(const TileBuffer& tile) {
    const bool has_tail = any_nonzero(tile.tail);
    const bool has_failures = any_nonzero(tile.failures);
    const std::scoped_lock lock(mutex_);
    if (tile.generation != generation_) return false;
    if (has_tail && tail_.empty()) tail_.assign(residual_.size(), 0.0);
    if (has_failures && failures_.empty()) failures_.assign(samples_.size(), 0);

    const std::size_t wavelengths = layout_.group_of_wavelength.size();
    const auto groups = static_cast<std::size_t>(layout_.group_count);
    std::size_t source = 0;
    for (int y = tile.rect.y0; y < tile.rect.y1; ++y) {
        for (int x = tile.rect.x0; x < tile.rect.x1; ++x, ++source) {
            const auto pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(layout_.width) + static_cast<std::size_t>(x);
            for (std::size_t w = 0; w < wavelengths; ++w)
                stokes_[pixel * wavelengths + w] += tile.stokes[source * wavelengths + w];
            for (std::size_t g = 0; g < groups; ++g)
                residual_[pixel * groups + g] += tile.residual[source * groups + g];
            if (has_tail)
                for (std::size_t g = 0; g < groups; ++g) tail_[pixel * groups + g] += tile.tail[source * groups + g];
            if (has_failures) failures_[pixel] += tile.failures[source];
            samples_[pixel] += tile.samples;
        }
    }
    return true;
}

StokesImage Film::snapshot() const {
    const std::scoped_lock lock(mutex_);
    StokesImage image;
    image.width = layout_.width;
    image.height = layout_.height;
    image.samples = samples_;
    image.failures = failures_;
    const std::size_t pixels = image.pixel_count();
    const std::size_t wavelengths = layout_.group_of_wavelength.size();
    const auto groups = static_cast<std::size_t>(layout_.group_count);
    image.stokes.resize(pixels * wavelengths);
    // Planes of a single group are shared by all wavelengths.
    const std::size_t planes = groups == 1 ? 1 : wavelengths;
    image.residual.resize(pixels * planes);
    if (!tail_.empty()) image.tail.resize(pixels * planes);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        // A pixel without samples is black and wholly untraced.
        const double share = samples_[pixel] > 0 ? 1.0 / samples_[pixel] : 0.0;
        for (std::size_t w = 0; w < wavelengths; ++w)
            image.stokes[w * pixels + pixel] = share * stokes_[pixel * wavelengths + w];
        for (std::size_t p = 0; p < planes; ++p) {
            const auto g = groups == 1 ? 0U : static_cast<std::size_t>(layout_.group_of_wavelength[p]);
            image.residual[p * pixels + pixel] = samples_[pixel] > 0 ? share * residual_[pixel * groups + g] : 1.0;
            if (!tail_.empty()) image.tail[p * pixels + pixel] = share * tail_[pixel * groups + g];
        }
    }
    return image;
}

double Film::bytes_per_pixel() const {
    const std::scoped_lock lock(mutex_);
    const auto bytes = [](const auto& v) { return static_cast<double>(v.capacity() * sizeof(v[0])); };
    return (bytes(stokes_) + bytes(residual_) + bytes(tail_) + bytes(samples_) + bytes(failures_)) /
           static_cast<double>(samples_.size());
}

}  // namespace pol
