// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "spectrum/color.h"
#include "spectrum/illuminant.h"
#include "spectrum/rgb_spectrum.h"
#include "spectrum/wavelength_grid.h"

namespace pol {
namespace {

// A weighted sum of up to 471 terms of both signs, each at most a few times the result: 471 epsilon = 1e-13 in the
// worst case.
constexpr double sum_rounding = 2e-13;

std::vector<double> grid(const char* text) {
    return parse_wavelengths(text).value();
}

std::vector<double> d65_on(const std::vector<double>& list) {
    std::vector<double> values;
    for (const double nm : list) values.push_back(d65_at(nm).value());
    return values;
}

TEST(Illuminant, D65IsOneAt560AndMatchesTheTable) {
    EXPECT_EQ(d65_at(560.0).value(), 1.0);
    // CIE table: 49.9755 at 380 nm, 117.812 at 460 nm.
    EXPECT_NEAR(d65_at(380.0).value(), 0.499755, 1e-15);
    EXPECT_NEAR(d65_at(460.0).value(), 1.17812, 1e-15);
    // Halfway between the nodes 580 (95.788) and 585 (92.2368).
    EXPECT_NEAR(d65_at(582.5).value(), 0.940124, 1e-15);
}

// Y of CIE 1931 relative to D65: of the equal-energy spectrum, the sum of the observer over that of observer times D65.
TEST(Illuminant, LuminanceIsWhatTheEyeMakesOfASpectrum) {
    EXPECT_NEAR(luminance(D65Spectrum{2.5}), 2.5, 2.5 * sum_rounding);
    EXPECT_EQ(luminance(ConstantSpectrum{0.0}), 0.0);
    double observer = 0.0;
    double seen_d65 = 0.0;
    for (int nm = 380; nm <= 780; ++nm) {
        const double share = nm == 380 || nm == 780 ? 0.5 : 1.0;  // trapezoid rule
        observer += share * color_matching(nm)[1];
        seen_d65 += share * color_matching(nm)[1] * d65_at(nm).value();
    }
    EXPECT_NEAR(luminance(ConstantSpectrum{3.0}), 3.0 * observer / seen_d65, sum_rounding);
    // The ends of a table hold on: infrared is judged by its shortest wavelength.
    EXPECT_NEAR(luminance(TabulatedSpectrum{{900.0, 1000.0}, {3.0, 7.0}}), 3.0 * observer / seen_d65, sum_rounding);
}

// A lamp of one primary has the luminance of its color (to_xyz).
TEST(Illuminant, ThePrimariesShareTheLuminanceOfWhite) {
    for (std::size_t c = 0; c < 3; ++c) {
        TabulatedSpectrum primary;
        for (int nm = 380; nm <= 780; ++nm) {
            primary.wavelength_nm.push_back(nm);
            primary.value.push_back(rgb_basis_at(nm).value()[c]);
        }
        Rgb color{};
        color[c] = 1.0;
        // The basis is kept to 15 digits, and made so that color_weights() gives the color back to a few of them less.
        EXPECT_NEAR(luminance(primary), to_xyz(color)[1], 1e-9) << c;
    }
}

TEST(Illuminant, EndsWhereItsTableEnds) {
    EXPECT_TRUE(d65_at(300.0));
    EXPECT_TRUE(d65_at(830.0));
    EXPECT_FALSE(d65_at(299.9));
    EXPECT_FALSE(d65_at(830.1));
    EXPECT_FALSE(d65_at(std::nan("")));
    EXPECT_FALSE(evaluate(D65Spectrum{}, 1000.0));
}

TEST(Illuminant, SpectraAreEvaluatedByKind) {
    EXPECT_EQ(evaluate(ConstantSpectrum{2.5}, 1e9).value(), 2.5);
    EXPECT_EQ(evaluate(D65Spectrum{3.0}, 560.0).value(), 3.0);
    const TabulatedSpectrum table{{500.0, 600.0}, {1.0, 3.0}};
    EXPECT_EQ(evaluate(table, 550.0).value(), 2.0);
    EXPECT_EQ(evaluate(table, 600.0).value(), 3.0);
    EXPECT_FALSE(evaluate(table, 601.0));
    EXPECT_FALSE(evaluate(TabulatedSpectrum{}, 500.0));
}

// CIE 15: the D65 white point, from the observer at 1 nm; five digits are published.
TEST(Color, TheD65WhitePointIsTheOneOfTheCie) {
    Xyz sum{};
    for (const double nm : grid("360:830:1")) {
        const Xyz observer = color_matching(nm);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += observer[c] * d65_at(nm).value();
    }
    const double total = sum[0] + sum[1] + sum[2];
    EXPECT_NEAR(sum[0] / total, 0.31273, 5e-6);
    EXPECT_NEAR(sum[1] / total, 0.32902, 5e-6);
}

// IEC 61966-2-1 prints its matrix with four digits.
TEST(Color, TheSrgbMatrixIsTheOneOfTheStandard) {
    const Xyz red = to_xyz({1.0, 0.0, 0.0});
    const Xyz green = to_xyz({0.0, 1.0, 0.0});
    const Xyz blue = to_xyz({0.0, 0.0, 1.0});
    const double expected[3][3] = {{0.4124, 0.2126, 0.0193}, {0.3576, 0.7152, 0.1192}, {0.1805, 0.0722, 0.9505}};
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(red[c], expected[0][c], 5.1e-5);
        EXPECT_NEAR(green[c], expected[1][c], 5.1e-5);
        EXPECT_NEAR(blue[c], expected[2][c], 5.1e-5);
    }
    const Rgb back = to_linear_srgb(to_xyz({0.2, 0.5, 0.9}));
    EXPECT_NEAR(back[0], 0.2, 1e-14);  // condition number of the matrix is below 10
    EXPECT_NEAR(back[1], 0.5, 1e-14);
    EXPECT_NEAR(back[2], 0.9, 1e-14);
}

TEST(Color, D65IsWhiteOnEveryWavelengthList) {
    for (const char* text : {"380:780:20", "360:830:1", "450,550,650", "380:780:5", "500,505,700", "300:830:10",
                             "450,460", "580", "660,700", "800", "700:830:1"}) {
        SCOPED_TRACE(text);
        const std::vector<double> list = grid(text);
        const Rgb white = weighted_color(d65_on(list), color_weights(list));
        for (const double channel : white) EXPECT_NEAR(channel, 1.0, sum_rounding);
    }
}

TEST(Color, OneWavelengthIsGrayRelativeToD65There) {
    for (const double nm : {400.0, 480.0, 580.0, 700.0}) {
        const std::vector<Rgb> weights = color_weights(std::vector<double>{nm});
        const double d65 = d65_at(nm).value();
        // Rows of an inverse matrix times the white point: rounding times its condition number, below 10.
        for (const double channel : weighted_color(std::vector<double>{0.3}, weights))
            EXPECT_NEAR(channel, 0.3 / d65, 1e-14);
    }
}

TEST(Color, InvisibleLightIsGrayWithItsMeanValue) {
    for (const double channel :
         weighted_color(std::vector<double>{1.0, 3.0}, color_weights(std::vector<double>{1000.0, 1100.0}))) {
        EXPECT_NEAR(channel, 2.0, 1e-14);
    }
}

TEST(Color, InfraredBesideVisibleLightIsNotSeen) {
    const std::vector<double> list{450.0, 550.0, 650.0, 1000.0};
    EXPECT_EQ(color_weights(list)[3], (Rgb{0.0, 0.0, 0.0}));
}

TEST(Color, LongWavelengthsAreRedAndShortOnesAreBlue) {
    const std::vector<double> list = grid("380:780:20");
    const std::vector<Rgb> weights = color_weights(list);
    EXPECT_GT(weights[13][0], 0.0);  // 640 nm
    EXPECT_GT(weights[13][0], 10.0 * std::abs(weights[13][2]));
    EXPECT_GT(weights[4][2], 10.0 * std::abs(weights[4][1]));  // 460 nm
    EXPECT_GT(weights[8][1], 0.0);                             // 540 nm
    EXPECT_LT(weights[8][0], 0.0);                             // outside the gamut, and not cut
}

TEST(Color, TrapezoidWeightsIntegrateStraightLinesExactly) {
    const std::vector<double> list{400.0, 410.0, 440.0, 500.0};
    const std::vector<double> weights = trapezoid_weights(list);
    double integral = 0.0;
    for (std::size_t i = 0; i < list.size(); ++i) integral += weights[i] * (2.0 * list[i] - 7.0);
    EXPECT_NEAR(integral, 500.0 * 500.0 - 400.0 * 400.0 - 700.0, 1e-9);
    EXPECT_EQ(trapezoid_weights(std::vector<double>{580.0}), std::vector<double>{1.0});
}

// IEC 61966-2-1: 8-bit code 188 is 50 % linear within one code; the branch point is continuous to the digits of the
// standard.
TEST(Color, TheTransferCurveIsTheOneOfTheStandard) {
    EXPECT_EQ(std::lround(255.0 * srgb_encode(0.5)), 188);
    EXPECT_EQ(srgb_encode(0.0), 0.0);
    EXPECT_NEAR(srgb_encode(1.0), 1.0, 1e-15);
    EXPECT_NEAR(srgb_encode(0.0031308), srgb_encode(0.0031309), 2e-6);
    for (const double value : {-0.5, 0.0, 0.001, 0.0031, 0.0032, 0.2, 0.9, 1.0, 4.0}) {
        // Off the branch point the two curves are inverse up to pow's rounding, multiplied by their slope (at most 2.4
        // * 4).
        EXPECT_NEAR(srgb_decode(srgb_encode(value)), value, 1e-14) << value;
    }
}

Rgb through_spectrum(const Rgb& color, const std::vector<double>& list) {
    std::vector<double> values;
    for (const double nm : list) {
        const auto basis = rgb_basis_at(nm).value();
        values.push_back(color[0] * basis[0] + color[1] * basis[1] + color[2] * basis[2]);
    }
    return weighted_color(values, color_weights(list));
}

TEST(RgbSpectrum, WhiteEmitsD65) {
    // Three table columns of 15 digits that sum to 1: 3 * 5e-16 and the rounding of two sums and three products.
    for (const double nm : grid("300:830:1")) {
        const auto basis = rgb_basis_at(nm).value();
        EXPECT_NEAR(basis[0] + basis[1] + basis[2], d65_at(nm).value(), 4e-15);
    }
}

TEST(RgbSpectrum, NeverEmitsLessThanNothing) {
    for (const double nm : grid("300:830:0.5")) {
        const auto basis = rgb_basis_at(nm).value();
        for (const double value : basis) EXPECT_GE(value, 0.0);
    }
}

TEST(RgbSpectrum, GivesTheColorBackOnTheFineListAndOnThatOfThePaper) {
    for (const char* text : {"380:780:1", "380:780:20"}) {
        SCOPED_TRACE(text);
        for (const Rgb& color : {Rgb{1.0, 0.0, 0.0}, Rgb{0.0, 1.0, 0.0}, Rgb{0.0, 0.0, 1.0}, Rgb{0.2, 0.7, 0.4}}) {
            const Rgb back = through_spectrum(color, grid(text));
            // The solver stops at residuals of 1e-15 in XYZ and the table has 15 digits; XYZ to sRGB multiplies by at
            // most 5.
            for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(back[c], color[c], 5e-13);
        }
    }
}

// On lists that the basis was not fitted to, the trapezoid rule errs by up to h^2/12 |f''| relative to f: with h = 10
// nm and lobes of about 40 nm width (f'' = f/40^2) 0.5 %; twice that, since two channels may add their errors.
TEST(RgbSpectrum, ComesCloseOnOtherLists) {
    for (const char* text : {"380:780:5", "380:780:10", "360:830:1"}) {
        SCOPED_TRACE(text);
        for (const Rgb& color : {Rgb{1.0, 0.0, 0.0}, Rgb{0.0, 1.0, 0.0}, Rgb{0.0, 0.0, 1.0}}) {
            const Rgb back = through_spectrum(color, grid(text));
            for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(back[c], color[c], 0.01);
        }
    }
}

TEST(RgbSpectrum, IsSmoothBetweenTheNodesOfItsTable) {
    // Step of the share (basis / D65) from one nm to the next: a slope over 60 nm or more from 0 to 1.
    for (double nm = 380.0; nm < 780.0; nm += 1.0) {
        const auto here = rgb_basis_at(nm).value();
        const auto next = rgb_basis_at(nm + 1.0).value();
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_LT(std::abs(next[c] / d65_at(nm + 1.0).value() - here[c] / d65_at(nm).value()), 1.0 / 30.0);
        }
    }
}

TEST(RgbSpectrum, EndsWhereD65Ends) {
    EXPECT_FALSE(rgb_basis_at(299.0));
    EXPECT_FALSE(rgb_basis_at(831.0));
    EXPECT_TRUE(rgb_basis_at(830.0));
}

}  // namespace
}  // namespace pol
