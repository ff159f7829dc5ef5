// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "support/render_scene.h"
#include "tracer/sample_task.h"

namespace pol {
namespace {

/// Samples number `first`, first + 2, ... of a pixel: the half that `first` belongs to.
std::vector<DVec2> half_of(std::uint64_t seed, std::uint32_t pixel, std::uint32_t first, std::size_t count) {
    std::vector<DVec2> points;
    for (std::uint32_t sample = first; points.size() < count; sample += 2)
        points.push_back(sample_position(SampleMode::area, seed, pixel, sample));
    return points;
}

TEST(SamplePosition, EveryHalfHasOneSampleInEveryBoxOfTheNet) {
    constexpr int log2_count = 8;
    constexpr std::uint32_t count = 1U << log2_count;
    for (std::uint32_t pixel = 0; pixel < 20; ++pixel) {
        for (const std::uint32_t first : {1U, 2U, 1U + 2 * count, 2U + 6 * count}) {
            const std::vector<DVec2> points = half_of(pixel % 3, pixel, first, count);
            for (int m = 0; m <= log2_count; ++m) {
                std::set<std::pair<int, int>> boxes;
                for (const DVec2& p : points) {
                    ASSERT_GT(p.x, 0.0);
                    ASSERT_LT(p.x, 1.0);
                    boxes.emplace(static_cast<int>(std::ldexp(p.x, m)),
                                  static_cast<int>(std::ldexp(p.y, log2_count - m)));
                }
                EXPECT_EQ(boxes.size(), count) << "pixel " << pixel << ", from sample " << first << ", columns 2^" << m;
            }
        }
    }
}

// Of n independent uniform numbers the mean of a function of variance v has the standard deviation sqrt(v/n).
TEST(SamplePosition, OverThePixelsEachSampleIsUniformAndTheHalvesAreIndependent) {
    constexpr int pixels = 40000;
    for (const std::uint32_t sample : {1U, 2U, 3U, 6U, 63U, 1000U}) {
        double x = 0.0, y = 0.0, xy = 0.0, halves = 0.0, neighbors = 0.0;
        DVec2 before(0.0);
        for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
            const DVec2 p = sample_position(SampleMode::area, 5, pixel, sample) - 0.5;
            const DVec2 other = sample_position(SampleMode::area, 5, pixel, sample + 1) - 0.5;
            x += p.x;
            y += p.y;
            xy += p.x * p.y;
            halves += p.x * other.x;
            neighbors += p.x * before.x;
            before = p;
        }
        const double of_one = std::sqrt(pixels / 12.0);
        const double of_product = std::sqrt(pixels) / 12.0;
        EXPECT_LT(std::abs(x), 4.0 * of_one) << sample;
        EXPECT_LT(std::abs(y), 4.0 * of_one) << sample;
        EXPECT_LT(std::abs(xy), 4.0 * of_product) << sample;
        EXPECT_LT(std::abs(halves), 4.0 * of_product) << sample;
        EXPECT_LT(std::abs(neighbors), 4.0 * of_product) << sample;
    }
}

// Owen's scrambling moves each of n samples by itself within its stratum of width 1/n: the mean of x has the variance
// 1/(12 n^3). A shift that all have in common would leave 1/(12 n^2), 64 times as much. Of m pixels its estimate
// scatters by sqrt(2/m). The hash that stands for random bits moves neighbors apart from each other, which leaves less.
TEST(SamplePosition, TheMeanOfAHalfScattersNoMoreThanJitterOfItsOwnInEveryStratumDoes) {
    constexpr std::uint32_t count = 64;
    constexpr std::uint32_t pixels = 4000;
    double x2 = 0.0, y2 = 0.0;
    for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
        DVec2 sum(0.0);
        for (const DVec2& p : half_of(9, pixel, 1, count)) sum += p - 0.5;
        x2 += std::pow(sum.x / count, 2);
        y2 += std::pow(sum.y / count, 2);
    }
    const double expected = pixels / (12.0 * std::pow(count, 3));
    EXPECT_LT(x2 / expected, 1.0 + 4.0 * std::sqrt(2.0 / pixels));
    EXPECT_LT(y2 / expected, 1.0 + 4.0 * std::sqrt(2.0 / pixels));
}

TEST(SamplePosition, SampleZeroIsTheCentreAndNoOtherIs) {
    EXPECT_EQ(sample_position(SampleMode::area, 1, 7, 0), DVec2(0.5));
    EXPECT_EQ(sample_position(SampleMode::point, 1, 7, 5), DVec2(0.5));
    for (std::uint32_t sample = 1; sample < 100000; ++sample) {
        const DVec2 p = sample_position(SampleMode::area, 1, 7, sample);
        ASSERT_NE(p.x, 0.5);
        ASSERT_NE(p.y, 0.5);
    }
}

/// A prism of `medium`, seen at these wavelengths.
std::shared_ptr<const Plan> prism_of(const std::string& medium, const std::string& wavelengths,
                                     const std::string& unit = "mm") {
    return test::plan_of(test::scene_of("unit: " + unit + R"(
camera: {position: [1, -3, 2], target: [0, 0, 0], fov: 20}
background: 1
render: {size: [8, 8], mode: area, spp: 64, wavelengths: )" +
                                        wavelengths + "}\nmedia: {matter: " + medium + R"(}
objects: [{name: prism, shape: {box: {size: 1}}, medium: matter}]
)"));
}

DVec3 direction(const Plan& plan, std::uint32_t sample, int wavelength) {
    const int group = plan.group_of_wavelength[static_cast<std::size_t>(wavelength)];
    return sample_task(plan, 3, 4, sample, group).ray.direction;
}

// The errors of X, Y and Z are sums over wavelengths: with common places they would add up, with their own they
// average.
TEST(SamplePosition, WhereLightDispersesEveryWavelengthHasPlacesOfItsOwnAndKeepsThemInAnyList) {
    const auto both = prism_of("n-bk7", "[500, 600]");
    const auto alone = prism_of("n-bk7", "600");
    EXPECT_EQ(direction(*both, 0, 0), direction(*both, 0, 1)) << "the centre is common";
    for (std::uint32_t sample = 1; sample < 64; ++sample) {
        EXPECT_NE(direction(*both, sample, 0), direction(*both, sample, 1));
        EXPECT_EQ(direction(*both, sample, 1), direction(*alone, sample, 0));
    }
}

TEST(SamplePosition, WhereItDoesNotOneTreeServesAllWavelengthsAndAnAbsorbingTwinOfAnotherSizeKeepsItsPlaces) {
    const auto clear = prism_of("1.5", "[500, 600]");
    EXPECT_EQ(clear->groups.size(), 1U);
    const auto dark = prism_of("{index: 1.5, absorption: {table: [[400, 1], [700, 3]]}}", "[500, 600]");
    const auto larger = prism_of("{index: 1.5, absorption: {table: [[400, 1], [700, 3]]}}", "[500, 600]", "cm");
    EXPECT_EQ(dark->groups.size(), 2U);
    for (std::uint32_t sample = 1; sample < 64; ++sample) {
        EXPECT_EQ(direction(*clear, sample, 0), direction(*clear, sample, 1));
        for (const int wavelength : {0, 1})
            EXPECT_EQ(direction(*dark, sample, wavelength), direction(*larger, sample, wavelength));
    }
}

// The product of two independent numbers, uniform from -1/2 to 1/2, has the standard deviation 1/12.
TEST(SamplePosition, ThePlacesOfTwoWavelengthsKnowNothingOfEachOther) {
    double product = 0.0;
    constexpr int pixels = 40000;
    for (std::uint32_t pixel = 0; pixel < pixels; ++pixel)
        product += (sample_position(SampleMode::area, 5, pixel, 1, 11).x - 0.5) *
                   (sample_position(SampleMode::area, 5, pixel, 1, 13).x - 0.5);
    EXPECT_LT(std::abs(product), 4.0 * std::sqrt(pixels) / 12.0);
}

}  // namespace
}  // namespace pol
