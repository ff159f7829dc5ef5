// SPDX-License-Identifier: Apache-2.0
// The ellipse that is drawn is that of the Stokes vector: axis, shape and sense (CONVENTIONS.md sections 4 and 5).
#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "known_picture.h"
#include "viewer/shown/glyphs.h"

namespace pol {
namespace {

StokesImage flat_picture(const Stokes<double>& light, int width = 8, int height = 8) {
    StokesImage image;
    image.width = width;
    image.height = height;
    image.bands = bands_at({550.0});
    image.stokes.assign(image.pixel_count(), light);
    return image;
}

std::vector<Glyph> glyphs_in(const StokesImage& image, int cell, const Polarimeter& polarimeter = {}) {
    return glyphs_of(ShownPicture(image, polarimeter), 0, cell, {0, 0, image.width, image.height});
}

// The field of a right-handed state is (cos, -sin) in x and y up: on screen, where y runs down, it turns clockwise.
TEST(Glyphs, RightHandedLightTurnsClockwise) {
    const auto glyphs = glyphs_in(flat_picture({1.0, 0.0, 0.0, 1.0}), 8);
    ASSERT_EQ(glyphs.size(), 1u);
    EXPECT_NEAR(glyphs[0].ellipticity, 1.0, 1e-7);
    const DVec2 start = field_tip(glyphs[0], 0.0);
    const DVec2 later = field_tip(glyphs[0], 0.1);
    // Clockwise with y down: the cross product x dy - y dx is positive.
    EXPECT_GT(start.x * later.y - start.y * later.x, 0.0);
}

TEST(Glyphs, LeftHandedLightTurnsTheOtherWay) {
    const auto glyphs = glyphs_in(flat_picture({1.0, 0.0, 0.0, -1.0}), 8);
    ASSERT_EQ(glyphs.size(), 1u);
    const DVec2 start = field_tip(glyphs[0], 0.0);
    const DVec2 later = field_tip(glyphs[0], 0.1);
    EXPECT_LT(start.x * later.y - start.y * later.x, 0.0);
}

// Colors say the name, arrows the sense on the picture: from behind, clockwise is counter-clockwise.
TEST(Glyphs, AreColoredByTheNameThatTheShownConventionHas) {
    const auto glyphs = glyphs_in(flat_picture({1.0, 0.0, 0.0, 1.0}), 8);
    for (const PositiveS3 positive : {PositiveS3::right, PositiveS3::left}) {
        EXPECT_TRUE(is_right_handed(glyphs[0], {Viewpoint::receiver, positive, TimeSign::minus}));
        EXPECT_FALSE(is_right_handed(glyphs[0], {Viewpoint::source, positive, TimeSign::minus}));
    }
    EXPECT_NE(glyph_key({}).find("right-handed, turns clockwise"), std::string::npos);
    EXPECT_NE(glyph_key({Viewpoint::source, PositiveS3::right, TimeSign::minus}).find("counter-clockwise here"),
              std::string::npos);
}

TEST(Glyphs, TheAxisIsTheAzimuthAndTheAxesHaveTheEllipticity) {
    const double psi = radians(30.0);
    const double chi = radians(15.0);
    const auto glyphs = glyphs_in(flat_picture(polarized_light(2.0, 0.8, psi, chi)), 8);
    ASSERT_EQ(glyphs.size(), 1u);
    EXPECT_NEAR(glyphs[0].dop, 0.8, 1e-12);
    const DVec2 major = field_tip(glyphs[0], 0.0);
    EXPECT_NEAR(major.x, std::cos(psi), 1e-12);
    EXPECT_NEAR(major.y, -std::sin(psi), 1e-12) << "up on screen is negative y";
    EXPECT_NEAR(glm::length(field_tip(glyphs[0], 0.5 * pi)), std::tan(chi), 1e-12);
}

// Two halves of crossed linear light are unpolarized together: the mean is taken before anything is derived from it.
TEST(Glyphs, ShowTheMeanLightOfTheirCell) {
    StokesImage image = flat_picture({1.0, 1.0, 0.0, 0.0});
    for (int y = 0; y < 8; ++y) {
        for (int x = 4; x < 8; ++x) image.stokes[image.pixel(x, y)] = {1.0, -1.0, 0.0, 0.0};
    }
    EXPECT_TRUE(glyphs_in(image, 8).empty());
    const auto glyphs = glyphs_in(image, 4);
    ASSERT_EQ(glyphs.size(), 4u);
    EXPECT_NEAR(glyphs[0].azimuth, 0.0, 1e-12);
    EXPECT_NEAR(std::abs(glyphs[1].azimuth), 0.5 * pi, 1e-12);
}

// The mean of numbers of 11 bits is known no better than they are.
TEST(Glyphs, TheMeanLightOfACellIsRoundedAsItsPixelsAre) {
    StokesImage image = flat_picture({1.0, 0.5, 0.0, 0.0});
    image.stored.bits = 16;
    EXPECT_EQ(ShownPicture(image, {}).mean_light(0, {0, 0, 8, 8}).rounding, 0x1p-11);
}

TEST(Glyphs, AreHiddenWhereTheyMeanNothing) {
    EXPECT_TRUE(glyphs_in(flat_picture({0.0, 0.0, 0.0, 0.0}), 4).empty()) << "no light";
    EXPECT_TRUE(glyphs_in(flat_picture({1.0, 0.0, 0.0, 0.0}), 4).empty()) << "unpolarized";
    EXPECT_TRUE(glyphs_in(flat_picture({1.0, 0.005, 0.0, 0.0}), 4).empty()) << "next to unpolarized";
    EXPECT_TRUE(glyphs_in(flat_picture({NAN, 0.5, 0.0, 0.0}), 4).empty()) << "not a number";
    StokesImage uncertain = flat_picture({1.0, 0.3, 0.0, 0.0});
    uncertain.brightest = {1.0};
    uncertain.residual.assign(uncertain.pixel_count(), 0.4);
    EXPECT_TRUE(glyphs_in(uncertain, 4).empty()) << "more light missing than polarized";
}

TEST(Glyphs, StandBehindThePolarimeter) {
    Polarimeter polarimeter;
    polarimeter.elements.push_back({PolarimeterElementKind::polarizer, true, radians(45.0), 0.0});
    const auto glyphs = glyphs_in(flat_picture({1.0, 0.0, 0.0, 0.0}), 8, polarimeter);
    ASSERT_EQ(glyphs.size(), 1u);
    EXPECT_NEAR(degrees(glyphs[0].azimuth), 45.0, 1e-9);
}

TEST(Glyphs, KeepTheirDistanceOnScreenAtEveryZoom) {
    const GlyphSettings settings;
    for (const double scale : {0.05, 0.3, 1.0, 5.0}) {
        const double distance = glyph_cell(settings, scale) * scale;
        EXPECT_NEAR(distance, settings.spacing, 0.5 * scale + 1e-9) << scale;
    }
    EXPECT_EQ(glyph_cell(settings, 100.0), 1) << "never finer than the pixels";
}

TEST(Glyphs, AreAsLongAsTheirSettingsSay) {
    GlyphSettings settings;
    const Glyph glyph{{}, 0.5, 0.25, 0.0, 0.0, 1.0, 1.0};
    settings.length = GlyphLength::equal;
    const double longest = glyph_radius(glyph, settings);
    EXPECT_LT(longest, 0.5 * settings.spacing) << "neighbors do not touch";
    settings.length = GlyphLength::by_dop;
    EXPECT_NEAR(glyph_radius(glyph, settings), 0.25 * longest, 1e-12);
    settings.length = GlyphLength::by_intensity;
    EXPECT_NEAR(glyph_radius(glyph, settings), 0.5 * longest, 1e-12);
}

}  // namespace
}  // namespace pol
