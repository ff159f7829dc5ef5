// SPDX-License-Identifier: Apache-2.0
// Colors worked out by hand from the formulas of polvis (of Mitsuba 3.9), which states them for
// Wilkie & Weidlich 2010: linear RGB, then the sRGB curve.
#include <gtest/gtest.h>

#include "maps/wilkie_picture.h"

namespace pol {
namespace {

StokesImage lone_pixel(const Stokes<double>& s) {
    StokesImage image;
    image.width = image.height = 1;
    image.bands = {named_band("mono")};
    image.stokes = {s};
    return image;
}

Rgb8 color(const StokesImage& image, WilkiePicture which) {
    const auto picture = wilkie_picture(image, std::nullopt, wilkie_pictures[static_cast<std::size_t>(which)]);
    return picture ? picture.value().pixels[0] : Rgb8{1, 2, 3};
}

TEST(WilkiePicture, TheDegreeIsRed) {
    EXPECT_EQ(color(lone_pixel({2.0, 1.0, 0.0, 0.0}), WilkiePicture::degree), encode({0.5, 0.0, 0.0}));
}

TEST(WilkiePicture, LinearLightIsCyanAndCircularLightYellow) {
    EXPECT_EQ(color(lone_pixel({1.0, -1.0, 0.0, 0.0}), WilkiePicture::type), (Rgb8{0, 255, 255}));
    EXPECT_EQ(color(lone_pixel({1.0, 0.0, 0.0, -1.0}), WilkiePicture::type), (Rgb8{255, 255, 0}));
    // l = 0.6, c = 0.8, degree 0.5: (0.4, 0.7, 0.3).
    EXPECT_EQ(color(lone_pixel({1.0, 0.3, 0.0, 0.4}), WilkiePicture::type), encode({0.4, 0.7, 0.3}));
}

TEST(WilkiePicture, HorizontalLightIsGreenVerticalRedDiagonalsYellowAndBlue) {
    EXPECT_EQ(color(lone_pixel({1.0, 1.0, 0.0, 0.0}), WilkiePicture::orientation), (Rgb8{0, 255, 0}));
    EXPECT_EQ(color(lone_pixel({1.0, -1.0, 0.0, 0.0}), WilkiePicture::orientation), (Rgb8{255, 0, 0}));
    EXPECT_EQ(color(lone_pixel({1.0, 0.0, 1.0, 0.0}), WilkiePicture::orientation), (Rgb8{255, 255, 0}));
    EXPECT_EQ(color(lone_pixel({1.0, 0.0, -1.0, 0.0}), WilkiePicture::orientation), (Rgb8{0, 0, 255}));
    EXPECT_EQ(color(lone_pixel({1.0, 0.3, 0.0, 0.4}), WilkiePicture::orientation), encode({0.0, 0.6 * 0.3, 0.0}));
}

TEST(WilkiePicture, RightCircularLightIsBlueAndLeftYellow) {
    EXPECT_EQ(color(lone_pixel({1.0, 0.0, 0.0, 1.0}), WilkiePicture::chirality), (Rgb8{0, 0, 255}));
    EXPECT_EQ(color(lone_pixel({1.0, 0.0, 0.0, -1.0}), WilkiePicture::chirality), (Rgb8{255, 255, 0}));
    EXPECT_EQ(color(lone_pixel({1.0, 0.3, 0.0, 0.4}), WilkiePicture::chirality), encode({0.0, 0.0, 0.8 * 0.4}));
}

TEST(WilkiePicture, IsOfTheMeanOfTheBandsUnlessOneIsAskedFor) {
    StokesImage image = lone_pixel({1.0, 1.0, 0.0, 0.0});
    image.bands = {named_band("R"), named_band("G")};
    image.stokes = {{1.0, 1.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}};
    EXPECT_EQ(color(image, WilkiePicture::degree), encode({0.5, 0.0, 0.0}));
    EXPECT_EQ(wilkie_picture(image, 1, wilkie_pictures[0]).value().pixels[0], (Rgb8{0, 0, 0}));
}

TEST(WilkiePicture, LightThatIsNoneIsMagentaAndAMissingS3IsRefusedByTheBandsName) {
    EXPECT_EQ(color(lone_pixel({-1.0, 1.0, 0.0, 0.0}), WilkiePicture::degree),
              state_color(PixelState::unphysical, 0, 0));
    EXPECT_EQ(color(lone_pixel({0.0, 0.0, 0.0, 0.0}), WilkiePicture::degree), (Rgb8{0, 0, 0}));
    StokesImage camera = lone_pixel({1.0, 0.5, 0.0, 0.0});
    camera.bands = {named_band("mono", StokesComponents::linear())};
    for (const WilkiePictureInfo& each : wilkie_pictures) {
        const auto refused = wilkie_picture(camera, std::nullopt, each);
        ASSERT_FALSE(refused);
        EXPECT_NE(refused.error().what.find("mono"), std::string::npos);
    }
}

}  // namespace
}  // namespace pol
