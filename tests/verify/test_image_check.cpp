// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <tuple>

#include "core/random.h"
#include "polarization/measures.h"
#include "verify/invariants/image_check.h"

namespace pol::verify {
namespace {

/// 16 x 16 pixels of the same light at one wavelength.
StokesImage uniform(const Stokes<double>& light) {
    StokesImage image;
    image.width = image.height = 16;
    image.bands = bands_at({580.0});
    image.stokes.assign(256, light);
    return image;
}

std::size_t count(const ImageReport& report, std::size_t defect) {
    return report.defects[defect].count;
}
constexpr std::size_t not_finite = 0;
constexpr std::size_t negative = 1;
constexpr std::size_t too_polarized = 2;

bool has_remark(const ImageReport& report, const std::string& part) {
    for (const std::string& remark : report.remarks)
        if (remark.find(part) != std::string::npos) return true;
    return false;
}

TEST(ImageCheck, FindsEveryDefectAndWhereItIsWorst) {
    StokesImage image = uniform({1.0, 0.3, -0.2, 0.1});
    image.stokes[image.pixel(3, 5)].s2 = std::numeric_limits<double>::quiet_NaN();
    image.stokes[image.pixel(4, 5)].s0 = std::numeric_limits<double>::infinity();
    image.stokes[image.pixel(1, 2)].s0 = -1e-3;
    image.stokes[image.pixel(2, 2)].s0 = -2e-3;
    image.stokes[image.pixel(7, 8)] = {1.0, 1.0, 0.0, 0.01};
    image.stokes[image.pixel(8, 8)] = {0.0, 0.0, 0.0, 1e-6};
    const ImageReport report = check_image(image);
    EXPECT_FALSE(report.physical());
    EXPECT_EQ(count(report, not_finite), 2U);
    EXPECT_EQ(count(report, negative), 2U);
    EXPECT_EQ(report.defects[negative].worst->x, 2);
    EXPECT_EQ(report.defects[negative].worst->value, -2e-3);
    EXPECT_EQ(count(report, too_polarized), 2U);
    EXPECT_EQ(report.defects[too_polarized].worst->x, 8);
    EXPECT_EQ(report.defects[not_finite].value_name, "S2");
    EXPECT_TRUE(std::isnan(report.defects[not_finite].worst->value));
    EXPECT_EQ(report.defects[negative].value_name, "S0");
    EXPECT_EQ(report.dop.lit, 251U);  // without the four above, and the dark one
    EXPECT_EQ(report.dop.dark, 1U);
}

// Fully polarized light in every direction, S0 as large as |s| and not rounded: the worst that rounding can do.
TEST(ImageCheck, AllowsWhatRoundingTo32BitsMakesOfFullyPolarizedLightAndNoMore) {
    StokesImage image = uniform({});
    std::uint64_t seed = 7;
    double worst = 0.0;
    for (int round = 0; round < 400; ++round) {
        for (Stokes<double>& s : image.stokes) {
            const auto dice = [&] { return 2.0 * static_cast<double>(mix_bits(++seed) >> 11) * 0x1p-53 - 1.0; };
            s = {0.0, dice(), dice(), dice()};
            s.s0 = polarized_part(s);
            for (double* part : {&s.s0, &s.s1, &s.s2, &s.s3}) *part = static_cast<double>(static_cast<float>(*part));
            worst = std::max(worst, polarized_part(s) / s.s0 - 1.0);
        }
        ASSERT_TRUE(check_image(image).physical());
    }
    EXPECT_GT(worst, 0.7 * float_excess);  // the budget is not generous
    image.stokes[5] = {1.0, 1.0 + 2.0 * float_excess, 0.0, 0.0};
    EXPECT_FALSE(check_image(image).physical());
}

TEST(ImageCheck, NamesThePixelOfTheWholePicture) {
    StokesImage image = uniform({1.0, 0.3, -0.2, 0.1});
    image.left = 60;
    image.top = 40;
    image.stokes[image.pixel(3, 2)].s0 = -1.0;
    const ImageReport report = check_image(image);
    EXPECT_EQ(report.defects[negative].worst->x, 63);
    EXPECT_EQ(report.defects[negative].worst->y, 42);
}

// Both ends of a number's rounding: |s| up and S0 down by u, which is (1 + u)/(1 - u) - 1 = 2 u + 2 u^2 + ...
TEST(ImageCheck, AllowsWhatRoundingToTheStoredBitsMakesAndSaysSo) {
    for (const auto& [bits, u, said] : {std::tuple{24, 0x1p-16, "PXR24"}, {16, 0x1p-11, "16-bit floats"}}) {
        StokesImage image = uniform({1.0 - u, 1.0 + u, 0.0, 0.0});
        image.stored.bits = bits;
        ImageReport report = check_image(image);
        EXPECT_TRUE(report.physical()) << bits;
        EXPECT_TRUE(has_remark(report, std::string("comes from ") + said)) << bits;
        image.stokes[7].s1 = 1.0 + 2.0 * u;
        report = check_image(image);
        EXPECT_EQ(count(report, too_polarized), 1U) << bits;
        EXPECT_EQ(report.defects[too_polarized].name,
                  "more polarized than " + std::to_string(bits) + "-bit rounding allows");
        EXPECT_TRUE(has_remark(report, std::string("comes from ") + said)) << bits;
    }
    // Numbers that are stored as 16 bits but right give no reason to speak.
    StokesImage image = uniform({1.0, 0.5, 0.0, 0.0});
    image.stored.bits = 16;
    EXPECT_FALSE(has_remark(check_image(image), "16-bit"));
    image.stokes[7].s1 = 1.1;
    image.stored.lossy = "B44";
    EXPECT_TRUE(has_remark(check_image(image), "may come from B44, a lossy compression"));
}

// Counts of a camera, rounded to the nearest: light of 1.4, fully polarized at 22.5 degrees, becomes 1, 1, 1.
TEST(ImageCheck, AllowsWholeNumbersToBeOffByAHalfHoweverSmallTheyAre) {
    for (const double unit : {1.0, 0x1p-16}) {
        StokesImage image = uniform({unit, unit, unit, 0.0});
        EXPECT_FALSE(check_image(image).physical());
        image.stored.spacing = unit;
        ImageReport report = check_image(image);
        EXPECT_TRUE(report.physical());
        EXPECT_TRUE(has_remark(report, "comes from whole numbers"));
        image.stokes[7].s1 = 4.0 * unit;
        report = check_image(image);
        EXPECT_EQ(count(report, too_polarized), 1U);
        EXPECT_EQ(report.defects[too_polarized].name, "more polarized than whole numbers allow");
    }
}

TEST(ImageCheck, AllowsTheSmallestFloats) {
    const double step = 0x1p-149;
    EXPECT_TRUE(check_image(uniform({step, step, step, 0.0})).physical());
    EXPECT_FALSE(check_image(uniform({0.0, 8.0 * step, 0.0, 0.0})).physical());
}

TEST(ImageCheck, GivesStatisticsOfTheDegreeOfPolarization) {
    StokesImage image = uniform({2.0, 1.0, 0.0, 0.0});
    for (std::size_t i = 0; i < 100; ++i) image.stokes[i] = {0.0, 0.0, 0.0, 0.0};
    image.stokes[200] = {1.0, 0.0, 0.0, -1.0};
    image.stokes[201] = {1.0, 0.0, 0.0, 0.0};
    const DopStatistics dop = check_image(image).dop;
    EXPECT_EQ(dop.lit, 156U);
    EXPECT_EQ(dop.dark, 100U);
    EXPECT_EQ(dop.least, 0.0);
    EXPECT_EQ(dop.most, 1.0);
    EXPECT_EQ(dop.median, 0.5);
    EXPECT_EQ(dop.percentile_1, 0.5);
    EXPECT_DOUBLE_EQ(dop.mean, (154.0 * 0.5 + 1.0) / 156.0);
}

TEST(ImageCheck, RemarksOnSuspiciousSigns) {
    EXPECT_TRUE(has_remark(check_image(uniform({1.0, 0.0, 0.0, 0.0})), "was polarization traced"));
    const ImageReport linear = check_image(uniform({1.0, 0.2, -0.3, 0.0}));
    EXPECT_TRUE(has_remark(linear, "S3 is exactly 0"));
    EXPECT_TRUE(has_remark(linear, "S2 is negative"));
    EXPECT_TRUE(has_remark(check_image(uniform({1.0, 0.2, 0.2, 0.1})), "S1 and S2 are the same"));
    EXPECT_TRUE(has_remark(check_image(uniform({1.0, 0.6, 0.0, 0.8})), "fully polarized"));
    EXPECT_TRUE(has_remark(check_image(uniform({0.0, 0.0, 0.0, 0.0})), "no pixel has any light"));
    EXPECT_TRUE(has_remark(check_image(uniform({1.0, 1.0 + 0x1p-11, 0.0, 0.0})), "16-bit"));
    StokesImage both = uniform({1.0, 0.2, -0.3, 0.1});
    for (std::size_t i = 0; i < 128; ++i) both.stokes[i] = {1.0, -0.2, 0.3, -0.1};
    EXPECT_TRUE(check_image(both).remarks.empty());
}

// A spectrum's R, G, B in linear sRGB: saturated green light has negative R. Luminance 0.7152 - 0.2126 * 0.2 > 0.
TEST(ImageCheck, JudgesRgbBandsByTheirLuminance) {
    StokesImage image = uniform({0.0, 0.0, 0.0, 0.0});
    image.bands = {named_band("R"), named_band("G"), named_band("B")};
    image.stokes.assign(3 * 256, {});
    for (std::size_t pixel = 0; pixel < 256; ++pixel) {
        image.stokes[pixel] = {-0.2, -0.1, 0.05, 0.0};
        image.stokes[256 + pixel] = {1.0, 0.5, 0.2, 0.1};
    }
    EXPECT_TRUE(check_image(image).physical());
    EXPECT_TRUE(has_remark(check_image(image), "luminance"));
    image.stokes[256 + 7] = {1.0, 1.2, 0.0, 0.0};
    const ImageReport report = check_image(image);
    EXPECT_EQ(count(report, too_polarized), 1U);
    EXPECT_EQ(report.defects[too_polarized].worst->x, 7);
    image.stokes[256 + 7].s0 = -1.0;
    EXPECT_EQ(count(check_image(image), negative), 1U);
}

TEST(ImageCheck, KnowsThatACameraOfLinearPolarizersHasNoS3) {
    StokesImage image = uniform({1.0, 0.3, 0.4, 0.0});
    image.bands[0].known = StokesComponents::linear();
    const ImageReport report = check_image(image);
    EXPECT_TRUE(report.physical());
    EXPECT_TRUE(report.dop.is_linear);
    EXPECT_DOUBLE_EQ(report.dop.median, 0.5);
    EXPECT_TRUE(has_remark(report, "S3 was not measured"));
    EXPECT_FALSE(has_remark(report, "S3 is exactly 0"));
    // Too much even if S3 were 0.
    image.stokes[9] = {1.0, 0.8, 0.8, 0.0};
    EXPECT_EQ(count(check_image(image), too_polarized), 1U);
}

TEST(ImageCheck, KnowsThatAPhotographHasNoPolarization) {
    StokesImage image = uniform({1.0, 0.0, 0.0, 0.0});
    image.bands[0].known = StokesComponents::s0();
    const ImageReport report = check_image(image);
    EXPECT_TRUE(report.physical());
    EXPECT_EQ(report.dop.lit, 256U);
    EXPECT_EQ(report.dop.measured, 0U);
    EXPECT_FALSE(has_remark(report, "was polarization traced"));
}

}  // namespace
}  // namespace pol::verify
