// SPDX-License-Identifier: Apache-2.0
#include "film/film_sums.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "core/contract.h"
#include "polarization/coherence_matrix.h"

namespace pol {

namespace {

bool any_nonzero(const auto& values) {
    return std::any_of(values.begin(), values.end(), [](auto v) { return v != 0; });
}

double square(double x) {
    return x * x;
}

/// h of ErrorSums, component by component. Requires: samples >= 2.
Stokes<double> half_difference(const Stokes<double>& sum, const Stokes<float>& odd_minus_even, std::uint32_t samples) {
    const Stokes<double> difference{odd_minus_even.s0, odd_minus_even.s1, odd_minus_even.s2, odd_minus_even.s3};
    const double whole = samples;
    if (samples % 2 == 0) return (1.0 / whole) * difference;
    const std::uint32_t odd_samples = samples / 2;
    const double odd = odd_samples;
    const double even = whole - odd;
    // Means of the halves: (sum + difference) / 2 odd, (sum - difference) / 2 even.
    const double scale = 0.5 * std::sqrt(odd * even) / whole;
    return (scale / odd) * (sum + difference) - (scale / even) * (sum - difference);
}

}  // namespace

FilmPlanes FilmSums::planes_present() const {
    FilmPlanes present;
    for (const TileSums& tile : tiles) {
        present.tail = present.tail || !tile.tail.empty();
        present.failures = present.failures || !tile.failures.empty();
        present.halves = present.halves || !tile.odd_minus_even.empty();
    }
    return present;
}

void FilmSums::add_planes(StokesImage& image, const FilmPlanes& present) const {
    const auto fill = [](auto& plane, std::size_t size, auto value) {
        if (plane.empty()) plane.assign(size, value);
    };
    constexpr double unknown = std::numeric_limits<double>::infinity();
    const std::size_t pixels = image.pixel_count();
    if (present.tail) fill(image.tail, pixels * planes(), 0.0);
    if (present.failures) fill(image.failures, pixels, 0U);
    if (present.halves)
        fill(image.sampling_error, pixels * wavelengths(), Stokes<double>{unknown, unknown, unknown, unknown});
}

StokesImage FilmSums::empty_image(int width, int height, const FilmPlanes& present) const {
    StokesImage image;
    image.width = width;
    image.height = height;
    image.bands = bands_at(layout.wavelengths_nm);
    image.brightest = layout.brightest;
    if (!layout.title.empty()) image.attributes["title"] = layout.title;
    const std::size_t pixels = image.pixel_count();
    image.stokes.resize(pixels * wavelengths());
    image.residual.assign(pixels * planes(), 1.0);
    image.samples.resize(pixels);
    add_planes(image, present);
    return image;
}

void FilmSums::add(TileSums& tile, const TileBuffer& pass) const {
    const std::size_t pixels = tile.rect.pixel_count();
    const bool has_tail = any_nonzero(pass.tail);
    const bool has_failures = any_nonzero(pass.failures);
    const bool has_halves = !pass.odd_minus_even.empty();
    if (tile.samples.empty()) {
        tile.samples.assign(pixels, 0);
        tile.stokes.assign(pixels * wavelengths(), {});
        tile.residual.assign(pixels * groups(), 0.0);
    }
    if (has_halves && tile.odd_minus_even.empty()) tile.odd_minus_even.assign(pixels * wavelengths(), {});
    if (has_tail && tile.tail.empty()) tile.tail.assign(pixels * groups(), 0.0);
    if (has_failures && tile.failures.empty()) tile.failures.assign(pixels, 0);

    const auto add_to = [](auto& sums, std::size_t to, const auto& parts, std::size_t from, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) sums[to * count + i] += parts[from * count + i];
    };
    const auto row = static_cast<std::size_t>(pass.rect.width());
    const auto tile_row = static_cast<std::size_t>(tile.rect.width());
    const auto corner = static_cast<std::size_t>(pass.rect.y0 - tile.rect.y0) * tile_row +
                        static_cast<std::size_t>(pass.rect.x0 - tile.rect.x0);
    for (std::size_t from = 0; from < pass.pixel_count(); ++from) {
        const std::size_t pixel = pass.pixel(from);
        const std::size_t to = corner + pixel / row * tile_row + pixel % row;
        add_to(tile.stokes, to, pass.stokes, from, wavelengths());
        add_to(tile.residual, to, pass.residual, from, groups());
        if (has_tail) add_to(tile.tail, to, pass.tail, from, groups());
        if (has_failures) tile.failures[to] += pass.failures[from];
        tile.samples[to] += pass.samples;
        if (!has_halves) continue;
        for (std::size_t w = 0; w < wavelengths(); ++w) {
            const Stokes<double>& d = pass.odd_minus_even[from * wavelengths() + w];
            tile.odd_minus_even[to * wavelengths() + w] += Stokes<float>{
                static_cast<float>(d.s0), static_cast<float>(d.s1), static_cast<float>(d.s2), static_cast<float>(d.s3)};
        }
    }
    tile.status.sample_count += static_cast<double>(pass.samples) * static_cast<double>(pass.pixel_count());
    if (!pass.more_follow) measure(tile);
}

double FilmSums::half_error(const TileSums& tile, std::size_t pixel) const {
    double sum = 0.0;
    for (std::size_t at = pixel * wavelengths(); at < (pixel + 1) * wavelengths(); ++at)
        sum += frobenius_square(half_difference(tile.stokes[at], tile.odd_minus_even[at], tile.samples[pixel]));
    return sum;
}

void FilmSums::measure(TileSums& tile) const {
    // Wavelengths of a group have the same residual.
    std::vector<double> members(groups(), 0.0);
    std::vector<double> brightest_square(groups(), 0.0);
    for (std::size_t w = 0; w < wavelengths(); ++w) {
        const auto group = static_cast<std::size_t>(layout.group_of_wavelength[w]);
        members[group] += 1.0;
        brightest_square[group] += square(brightest(w));
    }
    ErrorSums sums;
    tile.stratum_error = {};
    sums.has_tail = !tile.tail.empty();
    const bool count_tail = !layout.random_samples && sums.has_tail;
    for (std::size_t pixel = 0; pixel < tile.samples.size(); ++pixel) {
        const std::uint32_t samples = tile.samples[pixel];
        if (samples == 0) continue;
        const double share = 1.0 / samples;
        for (std::size_t g = 0; g < groups(); ++g) {
            const std::size_t at = pixel * groups() + g;
            const double residual = share * tile.residual[at];
            const double tail = count_tail ? share * tile.tail[at] : 0.0;
            sums.residual += members[g] * (residual + tail);
            sums.residual_max = std::max(sums.residual_max, residual + tail);
            sums.missing += brightest_square[g] * square(truncation_bound(residual, tail));
        }
        double light = 0.0;
        for (std::size_t w = 0; w < wavelengths(); ++w)
            light += frobenius_square(tile.stokes[pixel * wavelengths() + w]);
        sums.light += square(share) * light;
        sums.count += static_cast<double>(wavelengths());
        if (samples < 2 || tile.odd_minus_even.empty()) {
            sums.has_single = true;
            continue;
        }
        const double error = half_error(tile, pixel);
        sums.half_error += error;
        sums.half_error_square += square(error);
        if (strata) tile.stratum_error[strata->of_pixel(tile.rect, pixel)] += error;
    }
    tile.status.error = sums;
    tile.status.fewest_samples = *std::min_element(tile.samples.begin(), tile.samples.end());
}

void FilmSums::copy(const TileSums& tile, const TileRect& part, StokesImage& image, int left, int top) const {
    const std::size_t pixels = image.pixel_count();
    add_planes(image, {!tile.tail.empty(), !tile.failures.empty(), !tile.odd_minus_even.empty()});

    // Plane by plane: the tile fits into the cache, the picture does not.
    const auto for_each_pixel = [&](const auto& visit) {
        for (int y = part.y0; y < part.y1; ++y) {
            auto from = static_cast<std::size_t>((y - tile.rect.y0) * tile.rect.width() + part.x0 - tile.rect.x0);
            std::size_t to = image.pixel(left, top + y - part.y0);
            for (int x = part.x0; x < part.x1; ++x, ++from, ++to)
                if (tile.samples[from] > 0) visit(from, to, 1.0 / tile.samples[from]);
        }
    };
    for_each_pixel([&](std::size_t from, std::size_t to, double) {
        image.samples[to] = tile.samples[from];
        if (!tile.failures.empty()) image.failures[to] = tile.failures[from];
    });
    for (std::size_t p = 0; p < planes(); ++p) {
        const std::size_t group = group_of_plane(p);
        for_each_pixel([&](std::size_t from, std::size_t to, double share) {
            image.residual[p * pixels + to] = share * tile.residual[from * groups() + group];
            if (!tile.tail.empty()) image.tail[p * pixels + to] = share * tile.tail[from * groups() + group];
        });
    }
    for (std::size_t w = 0; w < wavelengths(); ++w) {
        for_each_pixel([&](std::size_t from, std::size_t to, double share) {
            const Stokes<double>& sum = tile.stokes[from * wavelengths() + w];
            image.stokes[w * pixels + to] = share * sum;
            if (tile.odd_minus_even.empty() || tile.samples[from] < 2) return;
            const Stokes<double> h =
                half_difference(sum, tile.odd_minus_even[from * wavelengths() + w], tile.samples[from]);
            image.sampling_error[w * pixels + to] = {std::abs(h.s0), std::abs(h.s1), std::abs(h.s2), std::abs(h.s3)};
        });
    }
}

bool FilmSums::has_preview(const TileSums& tile) const {
    if (preview_stride == 0) return false;
    const auto first = static_cast<std::size_t>(tile.rect.y0 / preview_stride);
    const auto last = static_cast<std::size_t>((tile.rect.y1 - 1) / preview_stride);
    for (std::size_t row = first; row <= last; ++row)
        if (!preview_rows[row]) return false;
    return true;
}

void FilmSums::copy_preview(const TileRect& part, StokesImage& image) const {
    const std::size_t pixels = image.pixel_count();
    if (!preview_tail.empty()) image.tail.assign(pixels * planes(), 0.0);
    for (int y = part.y0; y < part.y1; ++y) {
        for (int x = part.x0; x < part.x1; ++x) {
            const auto from = static_cast<std::size_t>(y / preview_stride * preview_columns() + x / preview_stride);
            const std::size_t to = image.pixel(x - part.x0, y - part.y0);
            for (std::size_t w = 0; w < wavelengths(); ++w)
                image.stokes[w * pixels + to] = preview_stokes[from * wavelengths() + w];
            for (std::size_t p = 0; p < planes(); ++p) {
                image.residual[p * pixels + to] = preview_residual[from * groups() + group_of_plane(p)];
                if (!preview_tail.empty())
                    image.tail[p * pixels + to] = preview_tail[from * groups() + group_of_plane(p)];
            }
        }
    }
}

std::optional<TileSnapshot> FilmSums::look(const TileSums& tile, const TileRect& part) const {
    TileSnapshot snapshot;
    snapshot.generation = generation;
    snapshot.rect = part;
    snapshot.image = empty_image(part.width(), part.height(), {});
    snapshot.preview = tile.samples.empty();
    snapshot.status = tile.status;
    if (!snapshot.preview)
        copy(tile, part, snapshot.image, 0, 0);
    else if (has_preview(tile))
        copy_preview(part, snapshot.image);
    else
        return std::nullopt;
    return snapshot;
}

void FilmSums::divide_preview(int stride) {
    const int old_stride = std::exchange(preview_stride, stride);
    const int old_columns = old_stride > 0 ? (layout.width + old_stride - 1) / old_stride : 0;
    const auto old_rows = std::exchange(preview_rows, {});
    const auto old_stokes = std::exchange(preview_stokes, {});
    const auto old_residual = std::exchange(preview_residual, {});
    const auto old_tail = std::exchange(preview_tail, {});
    const auto columns = static_cast<std::size_t>(preview_columns());
    const auto rows = static_cast<std::size_t>((layout.height + stride - 1) / stride);
    preview_rows.assign(rows, false);
    preview_stokes.assign(rows * columns * wavelengths(), {});
    preview_residual.assign(rows * columns * groups(), 1.0);
    if (!old_tail.empty()) preview_tail.assign(preview_residual.size(), 0.0);
    if (old_stride == 0) return;
    const auto take = [](const auto& from, std::size_t old_block, auto& to, std::size_t block, std::size_t count) {
        if (from.empty()) return;
        std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(old_block * count), count,
                    to.begin() + static_cast<std::ptrdiff_t>(block * count));
    };
    for (std::size_t row = 0; row < rows; ++row) {
        const auto old_row = row * static_cast<std::size_t>(stride) / static_cast<std::size_t>(old_stride);
        preview_rows[row] = old_rows[old_row];
        for (std::size_t column = 0; column < columns; ++column) {
            const auto old_column = column * static_cast<std::size_t>(stride) / static_cast<std::size_t>(old_stride);
            const std::size_t old_block = old_row * static_cast<std::size_t>(old_columns) + old_column;
            const std::size_t block = row * columns + column;
            take(old_stokes, old_block, preview_stokes, block, wavelengths());
            take(old_residual, old_block, preview_residual, block, groups());
            take(old_tail, old_block, preview_tail, block, groups());
        }
    }
}

void FilmSums::forget_preview() {
    const auto release = [](auto& values) { std::remove_reference_t<decltype(values)>().swap(values); };
    preview_stride = 0;
    release(preview_rows);
    release(preview_stokes);
    release(preview_residual);
    release(preview_tail);
}

void FilmSums::show(const PreviewStrip& strip, Version version) {
    POL_EXPECTS(strip.stride > 0 && strip.row >= 0 && strip.row * strip.stride < layout.height);
    if (preview_stride != strip.stride) divide_preview(strip.stride);
    const auto row = static_cast<std::size_t>(strip.row);
    const auto put = [row](const auto& part, auto& whole) {
        std::copy(part.begin(), part.end(), whole.begin() + static_cast<std::ptrdiff_t>(row * part.size()));
    };
    put(strip.stokes, preview_stokes);
    put(strip.residual, preview_residual);
    if (any_nonzero(strip.tail)) {
        if (preview_tail.empty()) preview_tail.assign(preview_residual.size(), 0.0);
        put(strip.tail, preview_tail);
    }
    preview_rows[row] = true;
    const int last_line = std::min((strip.row + 1) * strip.stride, layout.height) - 1;
    const std::size_t last = tile_at(layout.width - 1, last_line);
    for (std::size_t index = tile_at(0, strip.row * strip.stride); index <= last; ++index)
        if (tiles[index].samples.empty() && has_preview(tiles[index])) tiles[index].version = version;
}

}  // namespace pol
