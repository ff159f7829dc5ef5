// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "film/film.h"

namespace pol {
namespace {

/// A pass over `rect` whose sums are `light`, `residual` and `tail` for every pixel, wavelength and group.
TileBuffer pass_over(TileRect rect, Generation generation, std::uint32_t samples, const Stokes<double>& light,
                     double residual, double tail, std::size_t wavelengths = 1, std::size_t groups = 1) {
    TileBuffer buffer;
    buffer.generation = generation;
    buffer.rect = rect;
    buffer.samples = samples;
    buffer.stokes.assign(rect.pixel_count() * wavelengths, light);
    buffer.residual.assign(rect.pixel_count() * groups, residual);
    buffer.tail.assign(rect.pixel_count() * groups, tail);
    buffer.failures.assign(rect.pixel_count(), 0);
    return buffer;
}

TEST(Film, PixelsWithoutSamplesAreBlackAndWhollyUntraced) {
    Film film;
    film.reset({4, 2, {0}, 1}, 1);
    ASSERT_TRUE(film.merge(pass_over({2, 0, 4, 2}, 1, 2, {3.0, 1.0, 0.0, -1.0}, 0.5, 0.0)));
    const StokesImage image = film.snapshot();
    const Stokes<double> black{};
    const Stokes<double> mean{1.5, 0.5, 0.0, -0.5};
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x) {
            const std::size_t p = image.pixel(x, y);
            EXPECT_EQ(image.at(0, p), x < 2 ? black : mean);
            EXPECT_EQ(image.residual[p], x < 2 ? 1.0 : 0.25);
            EXPECT_EQ(image.samples[p], x < 2 ? 0U : 2U);
        }
}

TEST(Film, RefusesWhatAnOlderOrUnknownJobDelivers) {
    Film film;
    film.reset({2, 2, {0}, 1}, 7);
    EXPECT_FALSE(film.merge(pass_over({0, 0, 2, 2}, 6, 1, {9.0, 0.0, 0.0, 0.0}, 0.0, 0.0)));
    EXPECT_FALSE(film.merge(pass_over({0, 0, 2, 2}, 8, 1, {9.0, 0.0, 0.0, 0.0}, 0.0, 0.0)));
    EXPECT_EQ(film.snapshot().samples, std::vector<std::uint32_t>(4, 0));
    EXPECT_TRUE(film.merge(pass_over({0, 0, 2, 2}, 7, 1, {1.0, 0.0, 0.0, 0.0}, 0.0, 0.0)));
    film.reset({2, 2, {0}, 1}, 8);
    EXPECT_FALSE(film.merge(pass_over({0, 0, 2, 2}, 7, 1, {9.0, 0.0, 0.0, 0.0}, 0.0, 0.0)));
    EXPECT_EQ(film.snapshot().residual, std::vector<double>(4, 1.0));
}

TEST(Film, SumsPassesInTheOrderOfDelivery) {
    Film film;
    film.reset({1, 1, {0}, 1}, 1);
    const double parts[] = {1.0, 0x1p-53, 0x1p-53};  // (1 + u) + u = 1, 1 + (u + u) = 1 + 2u
    for (const double part : parts)
        ASSERT_TRUE(film.merge(pass_over({0, 0, 1, 1}, 1, 1, {part, 0.0, 0.0, 0.0}, 0.0, 0.0)));
    EXPECT_EQ(film.snapshot().at(0, 0).s0, 1.0 * (1.0 / 3.0));
}

// Two groups for three wavelengths: the picture has one plane of residual per wavelength; one group shares a plane.
TEST(Film, SpreadsResidualsOfGroupsOverTheirWavelengths) {
    Film film;
    film.reset({1, 1, {0, 1, 0}, 2}, 1);
    TileBuffer buffer = pass_over({0, 0, 1, 1}, 1, 1, {1.0, 0.0, 0.0, 0.0}, 0.0, 0.0, 3, 2);
    buffer.residual = {0.25, 0.5};
    buffer.tail = {0.0, 0.125};
    buffer.stokes = {{1.0, 0, 0, 0}, {2.0, 0, 0, 0}, {3.0, 0, 0, 0}};
    ASSERT_TRUE(film.merge(buffer));
    const StokesImage image = film.snapshot();
    EXPECT_EQ(image.residual, (std::vector<double>{0.25, 0.5, 0.25}));
    EXPECT_EQ(image.tail, (std::vector<double>{0.0, 0.125, 0.0}));
    for (std::size_t w = 0; w < 3; ++w) EXPECT_EQ(image.at(w, 0).s0, static_cast<double>(w + 1));
}

TEST(Film, KeepsNoPlanesForTailsAndFailuresThatNeverCame) {
    Film film;
    film.reset({8, 8, {0}, 1}, 1);
    ASSERT_TRUE(film.merge(pass_over({0, 0, 8, 8}, 1, 1, {1.0, 0.0, 0.0, 0.0}, 0.1, 0.0)));
    EXPECT_TRUE(film.snapshot().tail.empty());
    EXPECT_TRUE(film.snapshot().failures.empty());
    EXPECT_LE(film.bytes_per_pixel(), 200.0);  // the limit at one wavelength
    TileBuffer failing = pass_over({0, 0, 1, 1}, 1, 1, {0.0, 0.0, 0.0, 0.0}, 1.0, 0.5);
    failing.failures[0] = 1;
    ASSERT_TRUE(film.merge(failing));
    const StokesImage image = film.snapshot();
    EXPECT_EQ(image.failures[0], 1U);
    EXPECT_EQ(image.failures[1], 0U);
    EXPECT_EQ(image.tail[0], 0.25);
    EXPECT_EQ(image.tail[1], 0.0);
    EXPECT_LE(film.bytes_per_pixel(), 200.0);
}

// A reader may look at any time: every pixel then holds whole passes, here n samples of light n.
TEST(Film, ASnapshotNeverShowsHalfAPass) {
    Film film;
    film.reset({8, 4, {0}, 1}, 1);
    std::jthread writer([&film](const std::stop_token& stop) {
        while (!stop.stop_requested())
            for (const int x : {0, 4})
                static_cast<void>(film.merge(pass_over({x, 0, x + 4, 4}, 1, 1, {1.0, 0.5, 0.0, 0.0}, 0.25, 0.0)));
    });
    for (int look = 0; look < 400; ++look) {
        const StokesImage image = film.snapshot();
        for (const int tile : {0, 4}) {
            const std::uint32_t samples = image.samples[static_cast<std::size_t>(tile)];
            for (int y = 0; y < 4; ++y)
                for (int x = tile; x < tile + 4; ++x) {
                    const std::size_t p = image.pixel(x, y);
                    ASSERT_EQ(image.samples[p], samples);
                    // n times 1/n is 1 to one rounding
                    ASSERT_NEAR(image.at(0, p).s0, samples > 0 ? 1.0 : 0.0, 2.3e-16);
                    ASSERT_NEAR(image.residual[p], samples > 0 ? 0.25 : 1.0, 6e-17);
                }
        }
    }
}

}  // namespace
}  // namespace pol
