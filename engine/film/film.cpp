// SPDX-License-Identifier: Apache-2.0
#include "film/film.h"

#include <algorithm>
#include <utility>

#include "core/contract.h"

namespace pol {

void FilmStatusSum::add(const TileStatus& tile) {
    fewest_samples_ = std::min(fewest_samples_, tile.fewest_samples);
    samples_ += tile.sample_count;
    error_ += tile.error;
}

FilmStatus FilmStatusSum::status(std::size_t pixels, bool random_samples) const {
    FilmStatus status;
    status.fewest_samples = fewest_samples_;
    status.mean_samples = samples_ / static_cast<double>(pixels);
    status.error = picture_error(error_, random_samples);
    return status;
}

Film::Film() : sums_(std::make_shared<FilmSums>()) {}

void Film::reset(FilmLayout layout, Generation generation) {
    POL_EXPECTS(layout.width > 0 && layout.height > 0 && layout.tile_size > 0);
    auto fresh = std::make_shared<FilmSums>();
    for (const TileRect& rect : cut_tiles(layout.width, layout.height, layout.tile_size)) {
        fresh->tiles.emplace_back();
        fresh->tiles.back().rect = rect;
    }
    fresh->tiles_without_samples = fresh->tiles.size();
    fresh->layout = std::move(layout);
    fresh->generation = generation;
    const std::scoped_lock lock(mutex_);
    ++newest_;
    sums_.swap(fresh);  // what is replaced is freed outside the lock
}

bool Film::merge(const TileBuffer& pass) {
    const std::scoped_lock lock(mutex_);
    if (pass.generation != sums_->generation) return false;
    const std::size_t index = sums_->tile_at(pass.rect.x0, pass.rect.y0);
    POL_EXPECTS(index == sums_->tile_at(pass.rect.x1 - 1, pass.rect.y1 - 1));
    TileSums& tile = sums_->tiles[index];
    const bool first = tile.samples.empty();
    sums_->add(tile, pass);
    if (first && --sums_->tiles_without_samples == 0) sums_->forget_preview();
    tile.version = ++newest_;
    return true;
}

bool Film::show(const PreviewStrip& strip) {
    const std::scoped_lock lock(mutex_);
    if (strip.generation != sums_->generation) return false;
    sums_->show(strip, ++newest_);
    return true;
}

Generation Film::generation() const {
    const std::scoped_lock lock(mutex_);
    return sums_->generation;
}

Version Film::version() const {
    const std::scoped_lock lock(mutex_);
    return newest_;
}

int Film::tile_count() const {
    const std::scoped_lock lock(mutex_);
    return static_cast<int>(sums_->tiles.size());
}

std::optional<TileSnapshot> Film::tile_if_newer(int index, Version& seen) const {
    const std::scoped_lock lock(mutex_);
    if (index < 0 || index >= static_cast<int>(sums_->tiles.size())) return std::nullopt;
    const TileSums& tile = sums_->tiles[static_cast<std::size_t>(index)];
    if (tile.version <= seen) return std::nullopt;
    seen = tile.version;
    return sums_->look(tile, tile.rect);
}

std::optional<TileSnapshot> Film::pixel(int x, int y) const {
    const std::scoped_lock lock(mutex_);
    if (x < 0 || y < 0 || x >= sums_->layout.width || y >= sums_->layout.height) return std::nullopt;
    return sums_->look(sums_->tiles[sums_->tile_at(x, y)], {x, y, x + 1, y + 1});
}

StokesImage Film::snapshot() const {
    std::unique_lock lock(mutex_);
    const std::shared_ptr<const FilmSums> sums = sums_;
    const FilmPlanes planes = sums->planes_present();
    lock.unlock();
    POL_EXPECTS(sums->layout.width > 0);
    StokesImage image = sums->empty_image(sums->layout.width, sums->layout.height, planes);
    for (const TileSums& tile : sums->tiles) {
        lock.lock();
        if (!tile.samples.empty()) sums->copy(tile, tile.rect, image, tile.rect.x0, tile.rect.y0);
        lock.unlock();
    }
    return image;
}

StokesImage Film::blank() const {
    const std::scoped_lock lock(mutex_);
    return sums_->empty_image(sums_->layout.width, sums_->layout.height, {});
}

FilmStatus Film::status() const {
    const std::scoped_lock lock(mutex_);
    FilmStatus status;
    if (!sums_->tiles.empty()) {
        FilmStatusSum sum;
        for (const TileSums& tile : sums_->tiles) sum.add(tile.status);
        const FilmLayout& layout = sums_->layout;
        status = sum.status(static_cast<std::size_t>(layout.width) * static_cast<std::size_t>(layout.height),
                            layout.random_samples);
    }
    status.generation = sums_->generation;
    return status;
}

std::shared_ptr<const Strata> Film::stratify(Generation generation) {
    std::unique_lock lock(mutex_);
    if (generation != sums_->generation) return nullptr;
    const std::shared_ptr<FilmSums> sums = sums_;
    lock.unlock();
    auto strata = std::make_shared<const Strata>(sums->stratify());
    lock.lock();
    sums->strata = strata;
    lock.unlock();
    for (TileSums& tile : sums->tiles) {
        lock.lock();
        sums->measure(tile);
        lock.unlock();
    }
    return strata;
}

std::array<double, most_strata> Film::stratum_errors(Generation generation) const {
    const std::scoped_lock lock(mutex_);
    std::array<double, most_strata> sums{};
    if (generation != sums_->generation) return sums;
    for (const TileSums& tile : sums_->tiles)
        for (std::size_t i = 0; i < most_strata; ++i) sums[i] += tile.stratum_error[i];
    return sums;
}

double Film::bytes_per_pixel() const {
    const std::scoped_lock lock(mutex_);
    const auto bytes = [](const auto& v) { return static_cast<double>(v.capacity() * sizeof(v[0])); };
    double sum = sums_->strata ? sums_->strata->bytes() : 0.0;
    sum += bytes(sums_->preview_stokes) + bytes(sums_->preview_residual) + bytes(sums_->preview_tail);
    double pixels = 0.0;
    for (const TileSums& tile : sums_->tiles) {
        sum += sizeof(TileSums) + bytes(tile.stokes) + bytes(tile.odd_minus_even) + bytes(tile.residual) +
               bytes(tile.tail) + bytes(tile.samples) + bytes(tile.failures);
        pixels += static_cast<double>(tile.rect.pixel_count());
    }
    return sum / pixels;
}

}  // namespace pol
