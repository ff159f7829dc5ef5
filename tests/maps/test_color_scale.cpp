// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "maps/color_scale.h"

namespace pol {
namespace {

constexpr int steps = 1000;

double position(int i) {
    return static_cast<double>(i) / steps;
}

using Lab = std::array<double, 3>;

/// CIE 1976 L*a*b* under D65, independent of the Oklab that makes the scales.
Lab to_lab(const Rgb& color) {
    const Xyz xyz = to_xyz(color);
    const Xyz white = to_xyz({1.0, 1.0, 1.0});
    const auto f = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (t * 24389.0 / 27.0 + 16.0) / 116.0; };
    const double x = f(xyz[0] / white[0]);
    const double y = f(xyz[1] / white[1]);
    const double z = f(xyz[2] / white[2]);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

double difference(const Lab& a, const Lab& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// What is left of a color for an eye without the M cones: Vienot, Brettel & Mollon 1999, Table 2, linear RGB.
Rgb as_deuteranope(const Rgb& c) {
    return {0.29275 * c[0] + 0.70725 * c[1], 0.29275 * c[0] + 0.70725 * c[1], -0.02234 * c[0] + 0.02234 * c[1] + c[2]};
}

const std::vector<ColorScale> scientific{ColorScale::gray, ColorScale::sequential, ColorScale::diverging,
                                         ColorScale::cyclic};

TEST(ColorScale, StaysWithinWhatAScreenCanShow) {
    for (const ColorScale scale : scientific) {
        for (int i = 0; i <= steps; ++i) {
            for (const double channel : scale_color(scale, position(i))) {
                ASSERT_GE(channel, -1e-12) << static_cast<int>(scale) << " at " << position(i);
                ASSERT_LE(channel, 1.0 + 1e-12) << static_cast<int>(scale) << " at " << position(i);
            }
        }
    }
}

TEST(ColorScale, GetsLighterAllTheWayIfItIsSequential) {
    for (const ColorScale scale : {ColorScale::gray, ColorScale::sequential}) {
        for (int i = 1; i <= steps; ++i) {
            ASSERT_GT(lightness(scale_color(scale, position(i))), lightness(scale_color(scale, position(i - 1))));
        }
    }
    // Enough of the range of L* (0 to 100) that forty levels are two units apart.
    EXPECT_GT(lightness(scale_color(ColorScale::sequential, 1.0)) - lightness(scale_color(ColorScale::sequential, 0.0)),
              75.0);
}

TEST(ColorScale, GetsDarkerTowardsBothSignsIfItIsDivergingAndIsGrayAtZero) {
    for (int i = 1; i <= steps / 2; ++i) {
        const double near = position(i - 1) / 2.0;
        const double far = position(i) / 2.0;
        ASSERT_LT(lightness(scale_color(ColorScale::diverging, 0.5 + far)),
                  lightness(scale_color(ColorScale::diverging, 0.5 + near)));
        ASSERT_LT(lightness(scale_color(ColorScale::diverging, 0.5 - far)),
                  lightness(scale_color(ColorScale::diverging, 0.5 - near)));
    }
    // Neutral within the digits of the Oklab matrices (1e-7 of white, magnified 500 times in a*).
    const Lab zero = to_lab(scale_color(ColorScale::diverging, 0.5));
    EXPECT_NEAR(zero[1], 0.0, 0.05);
    EXPECT_NEAR(zero[2], 0.0, 0.05);
    EXPECT_EQ(encode(scale_color(ColorScale::wilkie_s1, 0.5)), (Rgb8{0, 0, 0}));
}

TEST(ColorScale, ClosesIfItIsCyclic) {
    for (const ColorScale scale : {ColorScale::cyclic, ColorScale::wilkie_orientation}) {
        const Rgb first = scale_color(scale, 0.0);
        const Rgb last = scale_color(scale, 1.0);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(first[c], last[c], 1e-14);
    }
}

TEST(ColorScale, TakesStepsThatLookAlikeAllAroundTheCycle) {
    double least = 1e9;
    double most = 0.0;
    constexpr int hues = 180;
    for (int i = 0; i < hues; ++i) {
        const Lab a = to_lab(scale_color(ColorScale::cyclic, static_cast<double>(i) / hues));
        const Lab b = to_lab(scale_color(ColorScale::cyclic, static_cast<double>(i + 1) / hues));
        least = std::min(least, difference(a, b));
        most = std::max(most, difference(a, b));
    }
    // Even in Oklab; CIELAB disagrees with it by up to a factor of about 2 in blue. An HSV hue circle scores above 8.
    EXPECT_LT(most / least, 3.0);
    EXPECT_GT(least, 0.2);
}

TEST(ColorScale, TellsAllAzimuthsApartForAnEyeWithoutGreen) {
    // Of any two azimuths 20 degrees or more apart (1/9 of the cycle) a deuteranope sees the difference: 2.3 is just
    // noticeable in CIELAB; four times that is easy.
    for (int i = 0; i < 90; ++i) {
        for (int j = 0; j < 90; ++j) {
            const double apart = std::abs(i - j) / 90.0;
            if (std::min(apart, 1.0 - apart) < 1.0 / 9.0) continue;
            const Lab a = to_lab(as_deuteranope(scale_color(ColorScale::cyclic, i / 90.0)));
            const Lab b = to_lab(as_deuteranope(scale_color(ColorScale::cyclic, j / 90.0)));
            ASSERT_GT(difference(a, b), 4.0 * 2.3) << i * 2 << " and " << j * 2 << " degrees";
        }
    }
}

TEST(ColorScale, HasTheColorsOfWilkieAndWeidlichOnRequest) {
    EXPECT_EQ(encode(scale_color(ColorScale::wilkie_degree, 1.0)), (Rgb8{255, 0, 0}));
    EXPECT_EQ(encode(scale_color(ColorScale::wilkie_type, 0.0)), (Rgb8{0, 255, 255}));
    EXPECT_EQ(encode(scale_color(ColorScale::wilkie_type, 1.0)), (Rgb8{255, 255, 0}));
    EXPECT_EQ(encode(scale_color(ColorScale::wilkie_chirality, 0.0)), (Rgb8{255, 255, 0}));
    EXPECT_EQ(encode(scale_color(ColorScale::wilkie_chirality, 1.0)), (Rgb8{0, 0, 255}));
    EXPECT_EQ(encode(scale_color(ColorScale::wilkie_s1, 1.0)), (Rgb8{0, 255, 0}));
    EXPECT_EQ(encode(scale_color(ColorScale::wilkie_s2, 0.0)), (Rgb8{0, 0, 255}));
    // Azimuth 0, the middle of -90 to 90, is s1 = 1; 45 degrees is s2 = 1.
    EXPECT_EQ(encode(scale_color(ColorScale::wilkie_orientation, 0.5)),
              encode(scale_color(ColorScale::wilkie_s1, 1.0)));
    EXPECT_EQ(encode(scale_color(ColorScale::wilkie_orientation, 0.75)),
              encode(scale_color(ColorScale::wilkie_s2, 1.0)));
    EXPECT_EQ(encode(scale_color(ColorScale::wilkie_orientation, 0.0)),
              encode(scale_color(ColorScale::wilkie_s1, 0.0)));
}

// IEC 61966-2-1: signal 128 stands for linear 0.21586.
TEST(Encode, FollowsTheSrgbCurve) {
    EXPECT_EQ(encode({0.0, 0.21586, 1.0}), (Rgb8{0, 128, 255}));
    EXPECT_EQ(encode({-1.0, 1e9, std::nan("")}), (Rgb8{0, 255, 0}));
}

}  // namespace
}  // namespace pol
