// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "maps/colorize.h"
#include "maps/difference.h"

namespace pol {
namespace {

TEST(Difference, OfAzimuthsIsThatOfUndirectedLines) {
    EXPECT_DOUBLE_EQ(difference(Quantity::azimuth, {89.0}, {-89.0}).value, -2.0);
    EXPECT_DOUBLE_EQ(difference(Quantity::azimuth, {-60.0}, {75.0}).value, 45.0);
    EXPECT_DOUBLE_EQ(difference(Quantity::azimuth, {30.0}, {10.0}).value, 20.0);
    EXPECT_DOUBLE_EQ(difference(Quantity::s1, {0.9}, {-0.9}).value, 1.8);
}

TEST(Difference, OfEqualLightSummedInAnotherOrderIsZero) {
    constexpr double ulp = std::numeric_limits<double>::epsilon();
    EXPECT_EQ(difference(Quantity::intensity, {1e-9 * (1.0 + 4.0 * ulp)}, {1e-9}).value, 0.0);
    EXPECT_EQ(difference(Quantity::s2, {3.0 * ulp}, {-2.0 * ulp}).value, 0.0);
    EXPECT_DOUBLE_EQ(difference(Quantity::intensity, {3e-9}, {1e-9}).value, 2e-9);
    EXPECT_NEAR(difference(Quantity::dop, {0.5 + 1e-9}, {0.5}).value, 1e-9, 2.0 * ulp);
}

// Zero is in the middle whatever the quantity; the tone of a photograph is not for signed numbers.
TEST(Difference, IsColoredFromBlueToOrangeWithZeroInTheMiddle) {
    for (const Quantity quantity : {Quantity::intensity, Quantity::handedness, Quantity::dop}) {
        const Map map{quantity, {580.0, {}}, true, 3, 1, {{-0.5}, {0.0}, {0.25}}};
        MapOptions options;
        options.gamma = 2.0;
        options.offset = 0.3;
        const ColoredMap colored = colorize(map, options);
        EXPECT_EQ(colored.kind(), ScaleKind::diverging);
        EXPECT_EQ(colored.range.low, -0.5);
        EXPECT_EQ(colored.range.high, 0.5);
        EXPECT_EQ(colored.picture.pixels[0], encode(scale_color(ColorScale::diverging, 0.0)));
        EXPECT_EQ(colored.picture.pixels[1], encode(scale_color(ColorScale::diverging, 0.5)));
        EXPECT_EQ(colored.picture.pixels[2], encode(scale_color(ColorScale::diverging, 0.75)));
    }
}

// Lines 90 and -90 degrees apart are the same distance apart: one color. Over a part of the cycle that a user asks for
// the ends differ, and so do their colors.
TEST(Difference, OfAzimuthsIsColoredOnAClosedScaleOverTheWholeCycle) {
    const Map map{Quantity::azimuth, {580.0, {}}, true, 3, 1, {{-90.0}, {0.0}, {90.0}}};
    for (const MapStyle style : {MapStyle::scientific, MapStyle::paper, MapStyle::wilkie}) {
        MapOptions options;
        options.style = style;
        const ColoredMap closed = colorize(map, options);
        EXPECT_EQ(closed.kind(), ScaleKind::cyclic);
        EXPECT_EQ(closed.range.low, -90.0);
        EXPECT_EQ(closed.range.high, 90.0);
        EXPECT_EQ(closed.picture.pixels[0], closed.picture.pixels[2]);
        EXPECT_NE(closed.picture.pixels[0], closed.picture.pixels[1]);
        options.range = MapRange{-5.0, 5.0};
        const ColoredMap part = colorize(map, options);
        EXPECT_EQ(part.kind(), ScaleKind::diverging);
        EXPECT_EQ(part.picture.pixels[1], encode(scale_color(ColorScale::diverging, 0.5)));
        EXPECT_NE(part.picture.pixels[0], part.picture.pixels[2]);
    }
}

// The bar of a difference is as wide as both bars together: half the range is covered by 0.3 + 0.45 of it.
TEST(Difference, IsAsUncertainAsBothTogether) {
    const MapPixel a{0.5, 1.0, PixelState::defined, 0.7};
    const MapPixel b{0.25, 1.0, PixelState::defined, 0.55};
    EXPECT_NEAR(difference(Quantity::dop, a, b).certainty, 0.25, 1e-15);
    EXPECT_EQ(difference(Quantity::dop, a, {0.25, 1.0, PixelState::defined, 0.1}).certainty, 0.0);
}

TEST(Difference, IsDefinedWhereBothAreAndFadesWithTheWeaker) {
    using enum PixelState;
    const MapPixel a{0.7, 1.0, defined};
    const MapPixel b{0.4, 0.25, defined};
    EXPECT_EQ(difference(Quantity::ellipticity, a, b).state, defined);
    EXPECT_EQ(difference(Quantity::ellipticity, a, b).weight, 0.25);
    const auto with = [&](PixelState state) { return difference(Quantity::ellipticity, a, {0.0, 0.0, state}).state; };
    EXPECT_EQ(with(not_a_number), not_a_number);
    EXPECT_EQ(with(unphysical), unphysical);
    EXPECT_EQ(with(undetermined), undetermined);
    EXPECT_EQ(with(dark), dark);
    EXPECT_EQ(with(undefined), undefined);
    EXPECT_EQ(with(no_light), undefined);
    EXPECT_EQ(difference(Quantity::dop, {0.0, 0.0, no_light}, {0.0, 0.0, no_light}).state, no_light);
    EXPECT_EQ(difference(Quantity::dop, {0.0, 0.0, undetermined}, {0.0, 0.0, not_a_number}).state, not_a_number);
}

}  // namespace
}  // namespace pol
