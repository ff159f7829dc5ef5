// SPDX-License-Identifier: Apache-2.0
// Which pixels and bands of two pictures are held against each other, and whether they are the same.
#include "compare/pairing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "compare/agreement.h"
#include "spectrum/color.h"

namespace pol::compare::test {
namespace {

/// Pixel (x, y) of the whole picture has S0 = 1 + x + 100 y in every band, times 1 + band.
StokesImage picture(int width, int height, std::vector<Band> bands, int left = 0, int top = 0) {
    StokesImage image;
    image.width = width;
    image.height = height;
    image.left = left;
    image.top = top;
    image.bands = std::move(bands);
    for (std::size_t b = 0; b < image.bands.size(); ++b) {
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const double s0 = (1.0 + static_cast<double>(b)) * (1.0 + (x + left) + 100.0 * (y + top));
                image.stokes.push_back({s0, 0.25 * s0, -0.125 * s0, 0.0625 * s0});
            }
        }
    }
    return image;
}

StokesImage crop(int width, int height, int left, int top, int whole_width, int whole_height) {
    StokesImage image = picture(width, height, bands_at({580.0}), left, top);
    image.whole_width = whole_width;
    image.whole_height = whole_height;
    return image;
}

std::vector<Band> rgb() {
    return {named_band("R"), named_band("G"), named_band("B")};
}

TEST(SharedArea, OfACropAndItsWholeIsTheCrop) {
    const StokesImage whole = picture(8, 6, bands_at({580.0}));
    const StokesImage part = crop(3, 2, 4, 1, 8, 6);
    const auto shared = shared_area(whole, part);
    ASSERT_TRUE(shared.has_value());
    EXPECT_EQ(shared->in_a, (Area{4, 1, 3, 2}));
    EXPECT_EQ(shared->in_b, (Area{0, 0, 3, 2}));
    const auto pairing = pair_up(whole, part);
    ASSERT_TRUE(pairing) << to_string(pairing.error());
    const Agreement found = agreement(common_pictures(whole, part, pairing.value()));
    EXPECT_EQ(found.values, 24U);
    EXPECT_EQ(found.identical, 24U);
}

TEST(SharedArea, OfTwoCropsIsWhatBothHave) {
    const auto shared = shared_area(crop(4, 4, 0, 0, 8, 8), crop(4, 4, 3, 2, 8, 8));
    ASSERT_TRUE(shared.has_value());
    EXPECT_EQ(shared->in_a, (Area{3, 2, 1, 2}));
    EXPECT_EQ(shared->in_b, (Area{0, 0, 1, 2}));
}

TEST(SharedArea, IsEmptyForCropsThatDoNotMeetAndForOtherPictures) {
    EXPECT_FALSE(shared_area(crop(4, 4, 0, 0, 8, 8), crop(4, 4, 4, 0, 8, 8)).has_value());
    EXPECT_FALSE(shared_area(picture(4, 4, rgb()), picture(4, 5, rgb())).has_value());
}

TEST(Pairing, ASmallPictureIsHeldAgainstBoxesOfTheLargeOne) {
    const StokesImage large = picture(6, 4, bands_at({580.0}));
    StokesImage small = picture(3, 2, bands_at({580.0}));
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) small.stokes[small.pixel(x, y)].s0 = 1.0 + (2 * x + 0.5) + 100.0 * (2 * y + 0.5);
    for (Stokes<double>& s : small.stokes) s = {s.s0, 0.25 * s.s0, -0.125 * s.s0, 0.0625 * s.s0};
    const auto pairing = pair_up(large, small);
    ASSERT_TRUE(pairing);
    EXPECT_EQ(pairing.value().box_a, 2);
    EXPECT_EQ(agreement(common_pictures(large, small, pairing.value())).identical, 24U);
    const auto turned = pair_up(small, large);
    ASSERT_TRUE(turned);
    EXPECT_EQ(turned.value().box_b, 2);
    EXPECT_EQ(agreement(common_pictures(small, large, turned.value())).identical, 24U);
}

TEST(Pairing, SizesThatDoNotFitAreRefused) {
    const auto refused = pair_up(picture(6, 4, rgb()), picture(4, 3, rgb()));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::usage);
    EXPECT_NE(refused.error().what.find("6 x 4"), std::string::npos);
    EXPECT_FALSE(refused.error().hint.empty());
    // Twice as wide, three times as high: no boxes of square pixels.
    EXPECT_FALSE(pair_up(picture(6, 6, rgb()), picture(3, 2, rgb())));
    // A part of a picture is not the whole of a smaller one.
    EXPECT_FALSE(pair_up(crop(4, 4, 0, 0, 8, 8), picture(2, 2, bands_at({580.0}))));
}

TEST(Pairing, APictureThatLiesAcrossIsLeftToTheDoctor) {
    const auto across = pair_up(picture(6, 4, rgb()), picture(4, 6, rgb()));
    ASSERT_TRUE(across);
    EXPECT_TRUE(across.value().lies_across);
}

TEST(Pairing, BandsOfOneWavelengthOrOneNameAreCompared) {
    const StokesImage a = picture(2, 2, bands_at({440.0, 550.0, 660.0}));
    const StokesImage b = picture(2, 2, bands_at({550.0 + 1e-7, 600.0, 660.0}));
    const auto pairing = pair_up(a, b);
    ASSERT_TRUE(pairing);
    ASSERT_EQ(pairing.value().bands.size(), 2U);
    EXPECT_EQ(pairing.value().bands[0].label, "550 nm");
    EXPECT_EQ(pairing.value().bands[0].of_a, (std::vector<double>{0.0, 1.0, 0.0}));
    EXPECT_EQ(pairing.value().bands[0].of_b, (std::vector<double>{1.0, 0.0, 0.0}));
    EXPECT_EQ(pairing.value().bands[1].share, 0.5);
    const auto chosen = pair_up(a, b, "660");
    ASSERT_TRUE(chosen);
    ASSERT_EQ(chosen.value().bands.size(), 1U);
    EXPECT_EQ(chosen.value().bands[0].share, 1.0);
    const auto refused = pair_up(a, b, "440");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().field, "--band");
    EXPECT_NE(refused.error().hint.find("550 nm, 660 nm"), std::string::npos);
}

TEST(Pairing, ColorsAreComparedWithTheColorsOfWavelengths) {
    const StokesImage ours = picture(2, 2, bands_at({450.0, 550.0, 600.0}));
    StokesImage theirs = picture(2, 2, rgb());
    const std::vector<Rgb> colors = color_weights(std::vector<double>{450.0, 550.0, 600.0});
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t p = 0; p < 4; ++p) {
            Stokes<double> sum;
            for (std::size_t w = 0; w < 3; ++w) sum += colors[w][c] * ours.at(w, p);
            theirs.stokes[c * 4 + p] = sum;
        }
    }
    const auto pairing = pair_up(ours, theirs);
    ASSERT_TRUE(pairing);
    ASSERT_EQ(pairing.value().bands.size(), 3U);
    EXPECT_EQ(pairing.value().remarks.size(), 1U);
    const CommonPictures common = common_pictures(ours, theirs, pairing.value());
    EXPECT_TRUE(common.a.is_color);
    EXPECT_TRUE(common.b.is_plain);
    for (std::size_t i = 0; i < common.a.image.stokes.size(); ++i)
        EXPECT_NEAR(common.a.image.stokes[i].s0, common.b.image.stokes[i].s0, 1e-12);
    // The doctor weighs them by luminance (IEC 61966-2-1).
    EXPECT_NEAR(pairing.value().bands[0].share, 0.2126, 1e-4);
    EXPECT_NEAR(pairing.value().bands[1].share, 0.7152, 1e-4);
    EXPECT_NEAR(pairing.value().bands[2].share, 0.0722, 1e-4);
}

TEST(Pairing, ABandWithoutAWavelengthIsHeldAgainstTheMiddleOneAndThatIsSaid) {
    const StokesImage ours = picture(2, 2, bands_at({450.0, 575.0, 600.0}));
    const auto pairing = pair_up(ours, picture(2, 2, {named_band("mono")}));
    ASSERT_TRUE(pairing);
    ASSERT_EQ(pairing.value().bands.size(), 1U);
    EXPECT_EQ(pairing.value().bands[0].label, "575 nm");
    ASSERT_EQ(pairing.value().remarks.size(), 1U);
    EXPECT_NE(pairing.value().remarks[0].find("575 nm"), std::string::npos);
    const auto chosen = pair_up(ours, picture(2, 2, {named_band("mono")}), "450");
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen.value().bands[0].label, "450 nm");
    EXPECT_FALSE(pair_up(ours, picture(2, 2, {named_band("mono")}), "451"));
}

TEST(Pairing, SingleWavelengthsThatDifferAreNotCompared) {
    const auto refused = pair_up(picture(2, 2, bands_at({580.0})), picture(2, 2, bands_at({590.0})));
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().what.find("A has 580 nm; B has 590 nm"), std::string::npos);
}

TEST(Pairing, TheDoctorSeesThePixelsThatBothHave) {
    StokesImage whole = picture(40, 40, bands_at({580.0}));
    std::mt19937 random(5);
    for (Stokes<double>& s : whole.stokes) {
        const auto draw = [&random] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
        s = {2.0 + draw(), draw(), draw(), draw()};
    }
    StokesImage part = crop(20, 10, 15, 20, 40, 40);
    for (int y = 0; y < part.height; ++y) {
        for (int x = 0; x < part.width; ++x) {
            const Stokes<double>& s = whole.stokes[whole.pixel(x + 15, y + 20)];
            part.stokes[part.pixel(x, y)] = {s.s0, s.s1, -s.s2, -s.s3};
        }
    }
    const auto pairing = pair_up(whole, part);
    ASSERT_TRUE(pairing);
    const ConventionVerdict verdict = diagnose(whole, part, pairing.value());
    EXPECT_EQ(verdict.finding, Finding::explained);
    EXPECT_EQ(verdict.boxes, 200);
    EXPECT_EQ(adoptable(verdict, {}), (StokesConvention{false, true, 0.0}));
}

CommonPictures pair_of(const StokesImage& a, const StokesImage& b) {
    const auto pairing = pair_up(a, b);
    EXPECT_TRUE(pairing);
    return common_pictures(a, b, pairing.value());
}

/// A half-precision float of a normal number: 11 significant bits, rounded to nearest.
double half(double x) {
    int exponent = 0;
    const double fraction = std::frexp(x, &exponent);
    return std::ldexp(std::nearbyint(std::ldexp(fraction, 11)), exponent - 11);
}

TEST(Agreement, AFileOfHalvesIsTheSamePictureAndOneUnitMoreIsNot) {
    std::mt19937 random(9);
    StokesImage ours = picture(10, 10, bands_at({580.0}));
    StokesImage halves = ours;
    halves.stored.bits = 16;
    for (std::size_t p = 0; p < ours.stokes.size(); ++p) {
        const auto draw = [&random] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
        const Stokes<double> s{1.0 + draw(), draw(), draw(), draw()};
        const auto single = [](double x) { return static_cast<double>(static_cast<float>(x)); };
        ours.stokes[p] = {single(s.s0), single(s.s1), single(s.s2), single(s.s3)};
        halves.stokes[p] = {half(s.s0), half(s.s1), half(s.s2), half(s.s3)};
    }
    EXPECT_TRUE(agreement(pair_of(ours, halves)).is_same());
    EXPECT_LT(agreement(pair_of(ours, halves)).identical, 100U);
    StokesImage off = halves;
    Stokes<double>& one = off.stokes[off.pixel(7, 4)];
    one.s2 += 2.1 * 0x1p-11 * std::abs(one.s2);
    const Agreement found = agreement(pair_of(ours, off));
    EXPECT_FALSE(found.is_same());
    EXPECT_EQ(found.beyond_rounding, 1U);
    // The same numbers, but kept as floats: then they are not.
    halves.stored.bits = 32;
    EXPECT_FALSE(agreement(pair_of(ours, halves)).is_same());
}

TEST(Agreement, LightThatWasNotTracedIsAllowedFor) {
    StokesImage a = picture(4, 4, bands_at({580.0}));
    StokesImage b = a;
    b.stokes[5].s0 -= 0.5;
    EXPECT_FALSE(agreement(pair_of(a, b)).is_same());
    b.brightest = {10.0};
    b.residual.assign(16, 0.06);
    EXPECT_TRUE(agreement(pair_of(a, b)).is_same());
    b.residual[5] = 0.04;
    const Agreement found = agreement(pair_of(a, b));
    EXPECT_EQ(found.beyond_rounding, 1U);
    ASSERT_TRUE(found.worst.has_value());
    EXPECT_EQ(found.worst->x, 1);
    EXPECT_EQ(found.worst->y, 1);
    EXPECT_NEAR(found.worst->distance, 0.5 / std::sqrt(2.0), 1e-12);
}

TEST(Agreement, WhatIsNoNumberInOneOfThemIsADifference) {
    const StokesImage a = picture(4, 4, bands_at({580.0}));
    StokesImage b = a;
    b.stokes[3].s1 = std::numeric_limits<double>::quiet_NaN();
    const Agreement found = agreement(pair_of(a, b));
    EXPECT_EQ(found.not_finite, 1U);
    EXPECT_FALSE(found.is_same());
    EXPECT_TRUE(agreement(pair_of(b, b)).is_same());
}

TEST(Agreement, ComponentsThatOneOfThemDoesNotKnowAreNotCompared) {
    const StokesImage a = picture(4, 4, bands_at({580.0}));
    StokesImage b = a;
    b.bands[0].known = StokesComponents::linear();
    for (Stokes<double>& s : b.stokes) s.s3 = 0.0;
    const Agreement found = agreement(pair_of(a, b));
    EXPECT_EQ(found.values, 48U);
    EXPECT_TRUE(found.is_same());
}

/// A picture with noise of this standard deviation and the error bars that two halves of the samples give.
StokesImage noisy(const StokesImage& truth, double deviation, std::mt19937& random) {
    std::normal_distribution<double> noise(0.0, deviation);
    StokesImage image = truth;
    for (Stokes<double>& s : image.stokes) {
        s += {noise(random), noise(random), noise(random), noise(random)};
        image.sampling_error.push_back(
            {std::abs(noise(random)), std::abs(noise(random)), std::abs(noise(random)), std::abs(noise(random))});
    }
    return image;
}

TEST(Significance, OfTwoRendersOfOneSceneIsChance) {
    std::mt19937 random(21);
    const StokesImage truth = picture(40, 40, bands_at({580.0}));
    double beyond = 0.0, expected = 0.0;
    for (int repeat = 0; repeat < 10; ++repeat) {
        const Agreement found = agreement(pair_of(noisy(truth, 0.01, random), noisy(truth, 0.02, random)));
        ASSERT_TRUE(found.significance.has_value());
        EXPECT_TRUE(found.is_same());
        for (const auto& component : found.significance->components) {
            ASSERT_TRUE(component.has_value());
            // Two sums of 1600 squares: relative deviation of the root of their quotient sqrt(4 / 1600) / 2, doubled by
            // the unequal variances at most; five of them.
            EXPECT_NEAR(component->ratio, 1.0, 0.2);
            beyond += static_cast<double>(component->beyond);
            expected += component->beyond_by_chance;
        }
    }
    // 64000 values: what is beyond is no more than what is stated, and not far less.
    EXPECT_LT(beyond, expected + 5.0 * std::sqrt(expected));
    EXPECT_GT(beyond, 0.05 * expected);
}

TEST(Significance, AnotherSignOfAWeakComponentIsNoChance) {
    std::mt19937 random(22);
    StokesImage truth = picture(40, 40, bands_at({580.0}));
    for (Stokes<double>& s : truth.stokes) s = {1.0, 0.3, 0.2, 0.01};
    StokesImage other = truth;
    for (Stokes<double>& s : other.stokes) s.s3 = -s.s3;
    // The difference is as large as the noise of the other picture.
    const Agreement found = agreement(pair_of(noisy(truth, 0.005, random), noisy(other, 0.02, random)));
    EXPECT_FALSE(found.is_same());
    EXPECT_TRUE(found.significance->components[1]->is_chance());
    EXPECT_FALSE(found.significance->components[3]->is_chance());
}

TEST(Significance, ADifferenceWithoutAFiniteBarIsNoChance) {
    StokesImage a = picture(8, 8, bands_at({580.0}));
    const double infinite = std::numeric_limits<double>::infinity();
    a.sampling_error.assign(a.stokes.size(), {infinite, infinite, infinite, infinite});
    StokesImage b = a;
    EXPECT_TRUE(agreement(pair_of(a, b)).is_same());
    b.stokes[9].s0 += 1.0;
    EXPECT_FALSE(agreement(pair_of(a, b)).is_same());
}

TEST(Significance, StudentsDistributionIsThatOfTheTables) {
    // Two-sided 5 % points, three decimals: Abramowitz & Stegun, table 26.10. Half a unit of the last one, times twice
    // the density there, which is at most 0.057.
    constexpr double rounding = 0.0005 * 2.0 * 0.057;
    EXPECT_NEAR(beyond_t(12.706, 1), 0.05, rounding);
    EXPECT_NEAR(beyond_t(4.303, 2), 0.05, rounding);
    EXPECT_NEAR(beyond_t(3.182, 3), 0.05, rounding);
    EXPECT_NEAR(beyond_t(2.571, 5), 0.05, rounding);
    EXPECT_NEAR(beyond_t(2.228, 10), 0.05, rounding);
    EXPECT_NEAR(beyond_t(2.000, 60), 0.05, rounding);
}

TEST(Pairing, ALoneBandWithoutAWavelengthIsSubtractedFromWhatStandsInForIt) {
    const std::vector<Band> mono{named_band("mono")};
    const std::vector<Band> spectrum = bands_at({450.0, 570.0, 650.0});
    const std::vector<Band> colors{named_band("R"), named_band("G"), named_band("B")};
    EXPECT_EQ(comparable_band(spectrum, 2, mono), 0U);
    EXPECT_EQ(comparable_band(mono, 0, spectrum), 1U) << "the one nearest to 580 nm";
    EXPECT_EQ(comparable_band(mono, 0, {named_band("")}), 0U);
    EXPECT_EQ(comparable_band(spectrum, 1, bands_at({570.0})), 0U);
    EXPECT_FALSE(comparable_band(spectrum, 0, bands_at({570.0})));
    EXPECT_EQ(comparable_band(colors, 2, colors), 2U);
    EXPECT_FALSE(comparable_band(colors, 1, spectrum)) << "no wavelength is G";
}

}  // namespace
}  // namespace pol::compare::test
