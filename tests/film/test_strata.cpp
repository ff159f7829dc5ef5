// SPDX-License-Identifier: Apache-2.0
#include "film/strata.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>

#include "film/film.h"

namespace pol {
namespace {

constexpr int width = 40;
constexpr int height = 32;

/// Sums of the even and the odd ones of four samples.
struct Halves {
    Stokes<double> even;
    Stokes<double> odd;
};

/// A film of one pass with four samples in every pixel, `at` (x, y), in tiles of an uneven size.
void fill(Film& film, const std::function<Halves(int, int)>& at) {
    FilmLayout layout;
    layout.width = width;
    layout.height = height;
    layout.group_of_wavelength = {0};
    layout.tile_size = 13;
    layout.random_samples = true;
    film.reset(layout, 1);
    for (const TileRect& rect : cut_tiles(width, height, layout.tile_size)) {
        TileBuffer pass;
        pass.generation = 1;
        pass.rect = rect;
        pass.samples = 4;
        for (int y = rect.y0; y < rect.y1; ++y)
            for (int x = rect.x0; x < rect.x1; ++x) {
                const Halves halves = at(x, y);
                pass.stokes.push_back(halves.even + halves.odd);
                pass.odd_minus_even.push_back(halves.odd - halves.even);
            }
        pass.residual.assign(rect.pixel_count(), 0.0);
        pass.tail.assign(rect.pixel_count(), 0.0);
        pass.failures.assign(rect.pixel_count(), 0);
        ASSERT_TRUE(film.merge(pass));
    }
}

Strata sorted(const std::function<Halves(int, int)>& at) {
    Film film;
    fill(film, at);
    return *film.stratify(1);
}

Halves even_light(double s0) {
    return {{2.0 * s0, 0.0, 0.0, 0.0}, {2.0 * s0, 0.0, 0.0, 0.0}};
}

/// Dark on the left of column 20, bright on the right.
Halves step(int x, int /*y*/) {
    return even_light(x < 20 ? 0.1 : 1.0);
}

std::uint8_t stratum(const Strata& strata, int x, int y) {
    return strata.of_picture[static_cast<std::size_t>(y * width + x)];
}

TEST(Strata, PixelsBesideAnEdgeAreNoisierThanAllOthers) {
    const Strata strata = sorted(step);
    // 64 of 1280 pixels have an edge between two opposite neighbors; their strata hold 5 % = 64 pixels, exactly them.
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            EXPECT_EQ(stratum(strata, x, y) == strata.pixels.size() - 1, x == 19 || x == 20) << x << ", " << y;
}

TEST(Strata, PixelsAmongNoisyNeighborsAreNoisierThanAllOthers) {
    const auto noisy = [](int x, int y) { return x >= 10 && x < 20 && y >= 10 && y < 20; };
    const Strata strata = sorted([&](int x, int y) {
        return noisy(x, y) ? Halves{{1.0, 0.5, 0.0, 0.0}, {3.0, -0.5, 0.0, 0.0}} : even_light(1.0);
    });
    // The 64 noisiest of 1280: inside, all eight neighbors are noisy.
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            EXPECT_EQ(stratum(strata, x, y) == strata.pixels.size() - 1, noisy(x - 1, y - 1) && noisy(x + 1, y + 1));
}

// The luck of a pixel's own samples must not decide whether it gets more of them.
TEST(Strata, APixelsOwnSamplesDoNotChooseItsStratum) {
    const Strata before = sorted(step);
    for (const int x : {0, 5, 19, 20, 39})
        for (const int y : {0, 7, 31}) {
            const Strata after = sorted([&](int column, int row) {
                return column == x && row == y ? Halves{{0.0, 0.0, 0.0, 0.0}, {40.0, 40.0, 0.0, 0.0}}
                                               : step(column, row);
            });
            // It passes no pixel but its neighbors, which all become noisier than it: 8 at most.
            EXPECT_LE(stratum(after, x, y), stratum(before, x, y)) << x << ", " << y;
        }
}

TEST(Strata, EveryPixelIsInOneAndNoneIsTooSmallToTellItsError) {
    for (const auto& at : {std::function<Halves(int, int)>(step),
                           std::function<Halves(int, int)>([](int, int) { return even_light(0.0); })}) {
        const Strata strata = sorted(at);
        ASSERT_LE(strata.pixels.size(), most_strata);
        std::vector<std::size_t> counted(strata.pixels.size(), 0);
        for (const std::uint8_t i : strata.of_picture) ++counted[i];
        EXPECT_EQ(counted, strata.pixels);
        for (const std::size_t count : counted) EXPECT_GE(count, Strata::fewest_pixels);
    }
}

TEST(Strata, TheirErrorsAddUpToThatOfThePicture) {
    Film film;
    fill(film, [](int x, int y) { return Halves{{1.0 + 0.01 * x, 0.0, 0.0, 0.0}, {1.0, 0.02 * y, 0.0, 0.0}}; });
    const auto strata = film.stratify(1);
    const auto errors = film.stratum_errors(1);
    const StokesImage image = film.snapshot();
    std::array<double, most_strata> expected{};
    for (std::size_t p = 0; p < image.pixel_count(); ++p) {
        const Stokes<double>& h = image.sampling_error[p];
        expected[strata->of_picture[p]] += 0.5 * (h.s0 * h.s0 + h.s1 * h.s1 + h.s2 * h.s2 + h.s3 * h.s3);
    }
    for (std::size_t i = 0; i < most_strata; ++i) EXPECT_NEAR(errors[i], expected[i], 1e-12 * expected[i]) << i;
    const double light = std::transform_reduce(
        image.stokes.begin(), image.stokes.end(), 0.0, std::plus<>(),
        [](const Stokes<double>& s) { return 0.5 * (s.s0 * s.s0 + s.s1 * s.s1 + s.s2 * s.s2 + s.s3 * s.s3); });
    const double sum = std::accumulate(errors.begin(), errors.end(), 0.0);
    EXPECT_NEAR(film.status().error.sampling.value(), std::sqrt(sum / light), 1e-12);
    EXPECT_EQ(film.stratify(2), nullptr) << "of another job";
    EXPECT_EQ(film.stratum_errors(2), (std::array<double, most_strata>{}));
}

// A pass over some pixels of a tile adds to these alone; the error of the tile is that of its last whole round.
TEST(Strata, APassOverListedPixelsAddsToThemAlone) {
    Film film;
    fill(film, [](int, int) { return even_light(1.0); });
    const PictureError before = film.status().error;
    TileBuffer pass;
    pass.generation = 1;
    pass.rect = {13, 0, 26, 13};
    pass.pixels = {0, 14, 168};  // (13, 0), (14, 1), (25, 12)
    pass.samples = 4;
    pass.more_follow = true;
    pass.stokes.assign(3, {8.0, 0.0, 0.0, 0.0});
    pass.odd_minus_even.assign(3, {8.0, 0.0, 0.0, 0.0});
    pass.residual.assign(3, 4.0);
    pass.tail.assign(3, 0.0);
    pass.failures.assign(3, 0);
    ASSERT_TRUE(film.merge(pass));
    const StokesImage image = film.snapshot();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool listed = (x == 13 && y == 0) || (x == 14 && y == 1) || (x == 25 && y == 12);
            const std::size_t p = image.pixel(x, y);
            EXPECT_EQ(image.samples[p], listed ? 8U : 4U);
            EXPECT_EQ(image.at(0, p).s0, listed ? 1.5 : 1.0);
            EXPECT_EQ(image.residual[p], listed ? 0.5 : 0.0);
        }
    EXPECT_EQ(film.status().mean_samples, 4.0 + 12.0 / (width * height));
    EXPECT_EQ(film.status().error.sampling, before.sampling);
    EXPECT_EQ(film.status().error.residual_mean, 0.0);
    pass.more_follow = false;
    ASSERT_TRUE(film.merge(pass));
    EXPECT_GT(film.status().error.sampling.value(), 0.0);
    EXPECT_NEAR(film.status().error.residual_mean, 3.0 * (8.0 / 12.0) / (width * height), 1e-15);
    EXPECT_EQ(film.status().fewest_samples, 4U);
}

}  // namespace
}  // namespace pol
