// SPDX-License-Identifier: Apache-2.0
// What a viewer asks of the film while workers fill it: newer tiles, single pixels, the preview, and how good it is.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <thread>
#include <vector>

#include "film/film.h"

namespace pol {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

FilmLayout layout_of(int width, int height, int tile_size, bool random_samples = true) {
    FilmLayout layout;
    layout.width = width;
    layout.height = height;
    layout.group_of_wavelength = {0};
    layout.tile_size = tile_size;
    layout.random_samples = random_samples;
    layout.wavelengths_nm = {580.0};
    layout.brightest = {2.0};
    return layout;
}

/// `even` and `odd` are sums over the even and the odd ones of `samples` samples.
TileBuffer uneven_pass(TileRect rect, Generation generation, std::uint32_t samples, const Stokes<double>& even,
                       const Stokes<double>& odd, double residual = 0.0, double tail = 0.0) {
    TileBuffer pass;
    pass.generation = generation;
    pass.rect = rect;
    pass.samples = samples;
    pass.stokes.assign(rect.pixel_count(), even + odd);
    pass.odd_minus_even.assign(rect.pixel_count(), odd - even);
    pass.residual.assign(rect.pixel_count(), residual);
    pass.tail.assign(rect.pixel_count(), tail);
    pass.failures.assign(rect.pixel_count(), 0);
    return pass;
}

TEST(FilmViewer, FetchesATileOnceForEachChange) {
    Film film;
    film.reset(layout_of(6, 4, 4), 3);
    EXPECT_EQ(film.generation(), 3U);
    ASSERT_EQ(film.tile_count(), 2);
    std::vector<Version> seen(2, 0);
    for (int tile = 0; tile < 2; ++tile) EXPECT_FALSE(film.tile_if_newer(tile, seen[static_cast<std::size_t>(tile)]));

    const Version before = film.version();
    ASSERT_TRUE(film.merge(uneven_pass({4, 0, 6, 4}, 3, 1, {4.0, 1.0, 2.0, 3.0}, {}, 0.25, 0.125)));
    EXPECT_GT(film.version(), before);
    EXPECT_FALSE(film.tile_if_newer(0, seen[0]));
    const auto tile = film.tile_if_newer(1, seen[1]);
    ASSERT_TRUE(tile);
    EXPECT_EQ(tile->generation, 3U);
    EXPECT_EQ(tile->rect, (TileRect{4, 0, 6, 4}));
    EXPECT_FALSE(tile->preview);
    EXPECT_EQ(tile->image.width, 2);
    EXPECT_EQ(tile->image.stokes, std::vector<Stokes<double>>(8, {4.0, 1.0, 2.0, 3.0}));
    EXPECT_EQ(tile->image.residual, std::vector<double>(8, 0.25));
    EXPECT_EQ(tile->image.tail, std::vector<double>(8, 0.125));
    EXPECT_EQ(tile->image.samples, std::vector<std::uint32_t>(8, 1));
    EXPECT_EQ(tile->image.brightest, std::vector<double>{2.0});

    const Version idle = film.version();
    EXPECT_FALSE(film.tile_if_newer(1, seen[1]));
    EXPECT_EQ(film.version(), idle);
    ASSERT_TRUE(film.merge(uneven_pass({4, 0, 6, 4}, 3, 1, {}, {2.0, 0.0, 0.0, 0.0})));
    ASSERT_TRUE(film.tile_if_newer(1, seen[1]));
    EXPECT_FALSE(film.tile_if_newer(2, seen[1]));
    EXPECT_FALSE(film.tile_if_newer(-1, seen[1]));
}

// A reader keeps its versions when the picture starts over: what comes then is newer than anything it saw.
TEST(FilmViewer, VersionsGoOnOverGenerations) {
    Film film;
    film.reset(layout_of(4, 4, 4), 1);
    for (int pass = 0; pass < 5; ++pass)
        ASSERT_TRUE(film.merge(uneven_pass({0, 0, 4, 4}, 1, 1, {1.0, 0.0, 0.0, 0.0}, {})));
    Version seen = 0;
    ASSERT_TRUE(film.tile_if_newer(0, seen));
    const Version before = film.version();
    film.reset(layout_of(4, 4, 4), 2);
    EXPECT_GT(film.version(), before);
    EXPECT_FALSE(film.tile_if_newer(0, seen));
    ASSERT_TRUE(film.merge(uneven_pass({0, 0, 4, 4}, 2, 1, {1.0, 0.0, 0.0, 0.0}, {})));
    const auto tile = film.tile_if_newer(0, seen);
    ASSERT_TRUE(tile);
    EXPECT_EQ(tile->generation, 2U);
}

TEST(FilmViewer, APixelSaysWhatThePictureSays) {
    Film film;
    film.reset(layout_of(6, 4, 4), 1);
    TileBuffer pass = uneven_pass({4, 0, 6, 4}, 1, 3, {5.0, 1.0, 0.0, -1.0}, {2.0, 1.0, 0.5, 0.0}, 0.25, 0.5);
    pass.stokes[5] = {7.0, 0.5, 0.25, 0.125};
    pass.failures[5] = 2;
    ASSERT_TRUE(film.merge(pass));
    const StokesImage image = film.snapshot();
    for (int y = 0; y < 4; ++y)
        for (int x = 4; x < 6; ++x) {
            const auto reading = film.pixel(x, y);
            ASSERT_TRUE(reading);
            const std::size_t p = image.pixel(x, y);
            EXPECT_EQ(reading->rect, (TileRect{x, y, x + 1, y + 1}));
            EXPECT_EQ(reading->image.at(0, 0), image.at(0, p));
            EXPECT_EQ(reading->image.residual[0], image.residual[p]);
            EXPECT_EQ(reading->image.tail[0], image.tail[p]);
            EXPECT_EQ(reading->image.samples[0], 3U);
            EXPECT_EQ(reading->image.failures[0], image.failures[p]);
            EXPECT_EQ(reading->image.sampling_error[0], image.sampling_error[p]);
        }
    EXPECT_EQ(film.pixel(5, 2)->image.failures[0], 2U);
    EXPECT_FALSE(film.pixel(0, 0)) << "no sample, no preview";
    EXPECT_FALSE(film.pixel(6, 0));
    EXPECT_FALSE(film.pixel(0, -1));
}

PreviewStrip strip_of(Generation generation, int stride, int row, const std::vector<double>& light) {
    PreviewStrip strip;
    strip.generation = generation;
    strip.stride = stride;
    strip.row = row;
    for (const double s0 : light) strip.stokes.push_back({s0, 0.0, 0.0, 0.0});
    strip.residual.assign(light.size(), 0.5);
    strip.tail.assign(light.size(), 0.0);
    return strip;
}

// 6 x 5 pixels, blocks of 4 x 4: two rows of two blocks, cut at the right and lower border; tiles of 3 x 3.
TEST(FilmViewer, ShowsThePreviewWhereThereAreNoSamplesAndNowhereElse) {
    Film film;
    film.reset(layout_of(6, 5, 3), 9);
    EXPECT_FALSE(film.show(strip_of(8, 4, 0, {1.0, 2.0})));
    ASSERT_TRUE(film.show(strip_of(9, 4, 0, {1.0, 2.0})));
    Version seen = 0;
    const auto first = film.tile_if_newer(1, seen);
    ASSERT_TRUE(first);
    EXPECT_TRUE(first->preview);
    EXPECT_EQ(first->rect, (TileRect{3, 0, 6, 3}));
    EXPECT_EQ(first->image.samples, std::vector<std::uint32_t>(9, 0));
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) {
            EXPECT_EQ(first->image.at(0, first->image.pixel(x, y)).s0, x == 0 ? 1.0 : 2.0);  // pixels 3 | 4 5
            EXPECT_EQ(first->image.residual[first->image.pixel(x, y)], 0.5);
        }
    Version lower = 0;
    EXPECT_FALSE(film.tile_if_newer(2, lower)) << "its lower line is not there yet";
    ASSERT_TRUE(film.show(strip_of(9, 4, 1, {3.0, 4.0})));
    const auto second = film.tile_if_newer(2, lower);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->image.at(0, second->image.pixel(0, 0)).s0, 1.0);  // line 3
    EXPECT_EQ(second->image.at(0, second->image.pixel(0, 1)).s0, 3.0);  // line 4
    EXPECT_EQ(film.pixel(5, 4)->image.at(0, 0).s0, 4.0);
    EXPECT_TRUE(film.pixel(5, 4)->preview);

    ASSERT_TRUE(film.merge(uneven_pass({3, 0, 6, 3}, 9, 1, {7.0, 0.0, 0.0, 0.0}, {})));
    ASSERT_TRUE(film.show(strip_of(9, 4, 0, {1.0, 2.0})));
    const auto traced = film.tile_if_newer(1, seen);
    ASSERT_TRUE(traced);
    EXPECT_FALSE(traced->preview);
    EXPECT_EQ(traced->image.at(0, 0).s0, 7.0);
    const StokesImage image = film.snapshot();
    EXPECT_EQ(image.at(0, image.pixel(0, 0)).s0, 0.0);
    EXPECT_EQ(image.residual[image.pixel(0, 0)], 1.0);
    EXPECT_EQ(image.at(0, image.pixel(4, 1)).s0, 7.0);
    EXPECT_EQ(film.status().mean_samples, 9.0 / 30.0) << "a preview is no sample";
}

// 8 x 4 pixels, two blocks of 4 x 4, then four of 2 x 2 in the upper line of blocks: the lower half keeps the coarse
// ones.
TEST(FilmViewer, AFinerLevelOfThePreviewReplacesTheCoarseOneWhereItIsThereAndNothingIsLeftAtTheEnd) {
    Film film;
    film.reset(layout_of(8, 4, 4), 3);
    ASSERT_TRUE(film.show(strip_of(3, 4, 0, {1.0, 2.0})));
    ASSERT_TRUE(film.show(strip_of(3, 2, 0, {5.0, 6.0, 7.0, 8.0})));
    for (int x = 0; x < 8; ++x) {
        EXPECT_EQ(film.pixel(x, 1)->image.at(0, 0).s0, 5.0 + x / 2) << x;
        EXPECT_EQ(film.pixel(x, 2)->image.at(0, 0).s0, x < 4 ? 1.0 : 2.0) << x;
        EXPECT_EQ(film.pixel(x, 3)->image.residual[0], 0.5) << x;
    }
    const double with_preview = film.bytes_per_pixel();
    ASSERT_TRUE(film.merge(uneven_pass({0, 0, 4, 4}, 3, 1, {7.0, 0.0, 0.0, 0.0}, {})));
    EXPECT_EQ(film.pixel(5, 0)->image.at(0, 0).s0, 7.0);
    EXPECT_TRUE(film.pixel(5, 0)->preview);
    ASSERT_TRUE(film.merge(uneven_pass({4, 0, 8, 4}, 3, 1, {7.0, 0.0, 0.0, 0.0}, {})));
    Film never;
    never.reset(layout_of(8, 4, 4), 3);
    ASSERT_TRUE(never.merge(uneven_pass({0, 0, 4, 4}, 3, 1, {7.0, 0.0, 0.0, 0.0}, {})));
    ASSERT_TRUE(never.merge(uneven_pass({4, 0, 8, 4}, 3, 1, {7.0, 0.0, 0.0, 0.0}, {})));
    EXPECT_EQ(film.bytes_per_pixel(), never.bytes_per_pixel());
    EXPECT_GT(with_preview, 0.0);
}

// Means of the even and odd samples: 3 and 5, so that the mean 4 is off by 1 (one degree of freedom).
TEST(FilmViewer, TwoHalvesTellTheSamplingError) {
    Film film;
    film.reset(layout_of(2, 1, 32), 1);
    ASSERT_TRUE(film.merge(uneven_pass({0, 0, 1, 1}, 1, 4, {6.0, 1.0, 0.0, 2.0}, {10.0, 0.0, 1.0, 2.0})));
    const StokesImage image = film.snapshot();
    EXPECT_EQ(image.sampling_error[0], (Stokes<double>{1.0, 0.25, 0.25, 0.0}));
    EXPECT_EQ(image.sampling_error[1], (Stokes<double>{infinite, infinite, infinite, infinite}));

    // Three samples of variance V: V/3 for the mean, V/2 + V for the difference of the halves.
    film.reset(layout_of(1, 1, 32), 2);
    ASSERT_TRUE(film.merge(uneven_pass({0, 0, 1, 1}, 2, 3, {6.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0})));
    EXPECT_NEAR(film.snapshot().sampling_error[0].s0, 3.0 * std::sqrt((1.0 / 3.0) / (3.0 / 2.0)), 1e-15);
}

// 20000 pixels of 6 normal samples each, of known spread: the squared errors that the halves tell have 20000 degrees of
// freedom, so that their mean is within 5 sqrt(2/20000) = 5 % of the variance of the mean.
TEST(FilmViewer, ThePooledEstimateIsWithoutBias) {
    constexpr int width = 200;
    constexpr int height = 100;
    constexpr double mean = 10.0;
    constexpr double spread = 0.3;
    std::mt19937_64 bits(7);
    std::normal_distribution<double> normal(mean, spread);
    Film film;
    film.reset(layout_of(width, height, width), 1);
    for (int sample = 0; sample < 6; ++sample) {
        TileBuffer pass = uneven_pass({0, 0, width, height}, 1, 1, {}, {});
        for (std::size_t p = 0; p < pass.stokes.size(); ++p) {
            pass.stokes[p].s0 = normal(bits);
            pass.odd_minus_even[p].s0 = sample % 2 == 1 ? pass.stokes[p].s0 : -pass.stokes[p].s0;
        }
        ASSERT_TRUE(film.merge(pass));
    }
    const auto estimate = film.status().error.sampling;
    ASSERT_TRUE(estimate);
    const double expected = spread / std::sqrt(6.0) / std::sqrt(mean * mean + spread * spread / 6.0);
    EXPECT_NEAR(*estimate / expected, 1.0, 0.025);
}

// One pixel of light 4 (linearly polarized: ||C|| = 4) and one of light 2 unpolarized (||C|| = sqrt 2); of the first
// 1/8, of the second 1/4 is missing, times brightest 2.
TEST(FilmViewer, ThePicturesErrorIsRelativeToItsLight) {
    for (const bool random_samples : {true, false}) {
        Film film;
        film.reset(layout_of(3, 1, 1, random_samples), 1);
        ASSERT_TRUE(film.merge(uneven_pass({0, 0, 1, 1}, 1, 2, {4.0, 4.0, 0.0, 0.0}, {4.0, 4.0, 0.0, 0.0}, 0.25)));
        ASSERT_TRUE(film.merge(uneven_pass({1, 0, 2, 1}, 1, 2, {1.0, 0.0, 0.0, 0.0}, {3.0, 0.0, 0.0, 0.0}, 0.5, 0.5)));
        const FilmStatus status = film.status();
        EXPECT_EQ(status.fewest_samples, 0U);
        EXPECT_EQ(status.mean_samples, 4.0 / 3.0);
        const double tail = random_samples ? 0.0 : 0.25;  // without random samples all that is known is its bound
        EXPECT_DOUBLE_EQ(status.error.residual_mean, (0.125 + 0.25 + tail) / 2.0);
        EXPECT_DOUBLE_EQ(status.error.residual_max, 0.25 + tail);
        const double light = 4.0 * 4.0 + 2.0 * 2.0 / 2.0;
        // Worst case: the tail tells of light of one polarization, the truth is as bright in the other one, and all
        // that was not traced comes on top of that.
        const double missing = 0.25 * 0.25 + std::pow(2.0 * tail, 2) + std::pow(0.5 + 2.0 * tail, 2);
        EXPECT_DOUBLE_EQ(status.error.truncation, std::sqrt(missing / light));
        // Half means 1 and 3: the mean is off by 1 in S0, ||dC|| = 1 / sqrt 2.
        if (random_samples)
            EXPECT_DOUBLE_EQ(status.error.sampling.value(), std::sqrt(0.5 / light));
        else
            EXPECT_FALSE(status.error.sampling) << "of a random path without random samples only the bound is known";
    }
}

TEST(FilmViewer, ABlackPictureFromWhichLightIsMissingHasNoRelativeError) {
    Film film;
    film.reset(layout_of(1, 1, 1), 1);
    ASSERT_TRUE(film.merge(uneven_pass({0, 0, 1, 1}, 1, 1, {}, {}, 0.0)));
    EXPECT_EQ(film.status().error.truncation, 0.0);
    EXPECT_FALSE(film.status().error.sampling);
    ASSERT_TRUE(film.merge(uneven_pass({0, 0, 1, 1}, 1, 1, {}, {}, 0.5)));
    EXPECT_EQ(film.status().error.truncation, infinite);
    EXPECT_FALSE(film.status().error.sampling) << "two black halves agree, and have seen nothing";
}

// With every plane in use: 200 B a pixel at one wavelength, 1.5 KiB at 21 with a tree each.
TEST(FilmViewer, EveryPlaneTogetherFitsIntoTheMemoryBudget) {
    for (const int wavelengths : {1, 21}) {
        FilmLayout layout = layout_of(64, 64, 32);
        layout.group_of_wavelength.clear();
        for (int w = 0; w < wavelengths; ++w) layout.group_of_wavelength.push_back(w);
        layout.group_count = wavelengths;
        layout.brightest.assign(static_cast<std::size_t>(wavelengths), 1.0);
        Film film;
        film.reset(layout, 1);
        for (const TileRect& rect : cut_tiles(64, 64, 32)) {
            TileBuffer pass = uneven_pass(rect, 1, 2, {}, {}, 0.5, 0.5);
            const std::size_t entries = rect.pixel_count() * static_cast<std::size_t>(wavelengths);
            pass.stokes.assign(entries, {1.0, 0.0, 0.0, 0.0});
            pass.odd_minus_even.assign(entries, {1.0, 0.0, 0.0, 0.0});
            pass.residual.assign(entries, 0.5);
            pass.tail.assign(entries, 0.5);
            pass.failures.assign(rect.pixel_count(), 1);
            ASSERT_TRUE(film.merge(pass));
        }
        EXPECT_LE(film.bytes_per_pixel(), wavelengths == 1 ? 200.0 : 1536.0);
        EXPECT_GE(film.bytes_per_pixel(), wavelengths == 1 ? 72.0 : 1352.0);
    }
}

// A window, an exporter and two jobs at once: everything that is read belongs to one generation and holds whole passes,
// n samples of light g for generation g.
TEST(FilmViewer, ReadersNeverMixGenerationsOrPasses) {
    Film film;
    film.reset(layout_of(8, 4, 4), 1);
    std::jthread writer([&film](const std::stop_token& stop) {
        for (Generation g = 1; !stop.stop_requested(); ++g) {
            film.reset(layout_of(8, 4, 4), g);
            const auto light = static_cast<double>(g);
            static_cast<void>(film.show(strip_of(g, 8, 0, {light})));
            for (int pass = 0; pass < 4; ++pass)
                for (const int x : {0, 4})
                    static_cast<void>(film.merge(uneven_pass({x, 0, x + 4, 4}, g, 1, {light, 0.0, 0.0, 0.0}, {})));
        }
    });
    std::jthread exporter([&film](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            const StokesImage image = film.snapshot();
            double light = 0.0;
            for (std::size_t p = 0; p < image.pixel_count(); ++p) {
                if (image.samples[p] == 0) continue;
                if (light == 0.0) light = std::round(image.at(0, p).s0);
                EXPECT_NEAR(image.at(0, p).s0, light, 1e-9 * light);
            }
        }
    });
    std::vector<Version> seen(2, 0);
    for (int look = 0; look < 2000; ++look) {
        const int index = look % 2;
        const auto tile = film.tile_if_newer(index, seen[static_cast<std::size_t>(index)]);
        const auto pixel = film.pixel(5, 3);
        for (const auto& found : {tile, pixel}) {
            if (!found) continue;
            const auto light = static_cast<double>(found->generation);
            for (const Stokes<double>& s : found->image.stokes) ASSERT_NEAR(s.s0, light, 1e-9 * light);
            ASSERT_EQ(found->preview, found->image.samples[0] == 0);
        }
        ASSERT_LE(film.status().fewest_samples, 4U);
    }
}

}  // namespace
}  // namespace pol
