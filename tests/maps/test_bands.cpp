// SPDX-License-Identifier: Apache-2.0
// Bands without wavelengths, components that nobody measured, and numbers in other conventions. Tolerance: 1e-15 for
// one product of numbers of order 1.
#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "film/band.h"
#include "film/stokes_image.h"
#include "maps/color_picture.h"
#include "maps/evaluate.h"
#include "polarization/stokes_convention.h"

namespace pol {
namespace {

StokesImage camera_pixel(StokesComponents known) {
    StokesImage image;
    image.width = image.height = 1;
    image.bands = {named_band("mono", known)};
    image.stokes = {{1.0, 0.3, 0.4, 0.0}};
    return image;
}

PixelState state_of(const StokesImage& image, Quantity quantity) {
    return evaluate_pixel(image, quantity, 0, 0, 1.0).state;
}

TEST(Bands, WithoutS3TheLinearDegreeIsKnownAndTheDegreeIsNot) {
    const StokesImage image = camera_pixel(StokesComponents::linear());
    EXPECT_DOUBLE_EQ(evaluate_pixel(image, Quantity::dolp, 0, 0, 1.0).value, 0.5);
    EXPECT_EQ(state_of(image, Quantity::azimuth), PixelState::defined);
    EXPECT_EQ(state_of(image, Quantity::s1), PixelState::defined);
    for (const Quantity quantity : {Quantity::dop, Quantity::docp, Quantity::ellipticity, Quantity::handedness,
                                    Quantity::s3, Quantity::dop_error, Quantity::ellipticity_error})
        EXPECT_EQ(state_of(image, quantity), PixelState::not_measured) << info(quantity).name;
}

TEST(Bands, APhotographHasIntensityAlone) {
    const StokesImage image = camera_pixel(StokesComponents::s0());
    for (const QuantityInfo& about : quantities()) {
        if (about.quantity == Quantity::color) continue;
        const bool is_known = about.quantity == Quantity::intensity || about.quantity == Quantity::unphysical;
        EXPECT_EQ(state_of(image, about.quantity) != PixelState::not_measured, is_known) << about.name;
    }
}

TEST(Bands, AnElementLeavesKnownWhatNoUnknownComponentHasAPartIn) {
    // Polarizer along x: S0' = S1' = (S0 + S1)/2. Quarter wave, fast axis along x: S2' = -S3 in size, S3' = S2.
    MuellerMatrix<double> polarizer{};
    polarizer.m[0] = polarizer.m[1] = {0.5, 0.5, 0.0, 0.0};
    EXPECT_EQ(known_behind(polarizer, StokesComponents::linear()), StokesComponents::all());
    EXPECT_EQ(known_behind(polarizer, StokesComponents::s0()), StokesComponents().with(2).with(3));
    MuellerMatrix<double> quarter_wave{};
    quarter_wave.m = {{{1.0, 0.0, 0.0, 0.0}, {0.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 0.0, -1.0}, {0.0, 0.0, 1.0, 0.0}}};
    EXPECT_EQ(known_behind(quarter_wave, StokesComponents::linear()), StokesComponents::all().without(2));
    // 6e-17 is what rounding leaves of a 0.
    quarter_wave.m[1][3] = 6e-17;
    EXPECT_EQ(known_behind(quarter_wave, StokesComponents::linear()), StokesComponents::all().without(2));
}

TEST(Bands, PrimariesAreShownAsTheyAreAndOtherNamesAreGray) {
    EXPECT_EQ(band_colors({named_band("B"), named_band("G"), named_band("R")}),
              (std::vector<Rgb>{{0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}}));
    EXPECT_EQ(band_colors({named_band("mono")}), (std::vector<Rgb>{{1.0, 1.0, 1.0}}));
    EXPECT_EQ(band_colors({named_band("infrared"), named_band("red")}),
              (std::vector<Rgb>{{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}));
}

TEST(Bands, AnAmountWithoutAWavelengthIsNotDividedByD65) {
    EXPECT_EQ(white_of(named_band("G")).value(), 1.0);
    EXPECT_EQ(unit_of(Quantity::intensity, named_band("G")), "");
    EXPECT_NE(unit_of(Quantity::intensity, {550.0, {}}), "");
    EXPECT_FALSE(white_of({200.0, {}}));
}

TEST(Bands, AreFoundAgainByWavelengthOrByName) {
    const std::vector<Band> bands{{450.0, {}}, {580.0000001, {}}, named_band("580")};
    EXPECT_EQ(matching_band(bands, {580.0, {}}), 1U);
    EXPECT_EQ(matching_band(bands, named_band("580")), 2U);
    EXPECT_FALSE(matching_band(bands, {581.0, {}}));
    EXPECT_FALSE(matching_band(bands, named_band("G")));
    EXPECT_TRUE(wavelengths_of(bands).empty());
    EXPECT_EQ(bands[0].label(), "450 nm");
}

// Ecosystem's table of conventions: what a change of convention does to the signs of S1, S2, S3.
TEST(StokesConvention, SignsAreThoseOfTheTableOfConventions) {
    const Stokes<double> s{1.0, 0.1, 0.2, 0.3};
    const auto ours = [&](bool left, bool down, double zero) { return StokesConvention{left, down, zero}.to_ours(s); };
    EXPECT_EQ(ours(false, false, 0.0), s);
    EXPECT_EQ(ours(true, false, 0.0), (Stokes<double>{1.0, 0.1, 0.2, -0.3}));
    EXPECT_EQ(ours(false, true, 0.0), (Stokes<double>{1.0, 0.1, -0.2, -0.3}));
    EXPECT_EQ(ours(false, false, 90.0), (Stokes<double>{1.0, -0.1, -0.2, 0.3}));
    EXPECT_EQ(ours(true, false, 90.0), (Stokes<double>{1.0, -0.1, -0.2, -0.3}));
    EXPECT_EQ(ours(true, true, 0.0), (Stokes<double>{1.0, 0.1, -0.2, 0.3}));
    EXPECT_EQ(ours(false, false, 180.0), s);
    EXPECT_EQ(ours(false, false, -90.0), ours(false, false, 90.0));
}

TEST(StokesConvention, AnAzimuthCountedFromZeroLiesThatMuchFurtherForUs) {
    const Stokes<double> theirs{1.0, std::cos(2.0 * radians(10.0)), std::sin(2.0 * radians(10.0)), 0.0};
    const Stokes<double> ours = StokesConvention{false, false, 25.0}.to_ours(theirs);
    EXPECT_NEAR(ours.s1, std::cos(2.0 * radians(35.0)), 1e-15);
    EXPECT_NEAR(ours.s2, std::sin(2.0 * radians(35.0)), 1e-15);
}

TEST(StokesConvention, TheWayBackGivesTheSameBitsForSignsAndEighthsOfATurn) {
    const Stokes<double> s{1.0, 0.1, 0.2, 0.3};
    for (const bool left : {false, true})
        for (const bool down : {false, true})
            for (const double zero : {-135.0, -90.0, -45.0, 0.0, 45.0, 90.0, 180.0}) {
                const StokesConvention convention{left, down, zero};
                EXPECT_EQ(convention.from_ours(convention.to_ours(s)), s) << convention.text();
            }
}

TEST(StokesConvention, APictureReadInAnotherOneAndBackIsTheSame) {
    StokesImage image = camera_pixel(StokesComponents::all());
    image.stokes = {{1.0, 0.3, 0.4, 0.5}};
    read_in(image, {true, true, 90.0});
    EXPECT_EQ(image.stokes[0], (Stokes<double>{1.0, -0.3, 0.4, 0.5}));
    EXPECT_TRUE(image.origin.convention.left_handed);
    read_in(image, {});
    EXPECT_EQ(image.stokes[0], (Stokes<double>{1.0, 0.3, 0.4, 0.5}));
}

}  // namespace
}  // namespace pol
