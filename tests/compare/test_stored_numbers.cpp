// SPDX-License-Identifier: Apache-2.0
// What a file does to numbers beside their convention: an offset, and light that is cut off.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "compare/convention_doctor.h"
#include "compare/scenery.h"

namespace pol::compare::test {
namespace {

/// As a picture of 8 bits without signs keeps it.
Stokes<double> in_8_bits(const Stokes<double>& s, double unit) {
    const auto kept = [](double v) { return std::round(255.0 * std::clamp(v, 0.0, 1.0)) / 255.0; };
    return {kept(s.s0), kept(0.5 + 0.5 * s.s1 / unit), kept(0.5 + 0.5 * s.s2 / unit), kept(0.5 + 0.5 * s.s3 / unit)};
}

/// Nothing brighter than 1.
StokesImage dim_scenery() {
    return changed(scenery(40, 30), [](const Stokes<double>& s) { return (1.0 / 3.0) * s; });
}

TEST(StoredNumbers, NumbersWithAnOffsetAreToldWithTheConventionUnderThem) {
    const StokesImage a = dim_scenery();
    const StokesImage b = changed(a, [](const Stokes<double>& s) { return in_8_bits(s, 1.0); });
    const ConventionVerdict verdict = verdict_of(a, b);
    EXPECT_EQ(verdict.coding, Coding::offset);
    EXPECT_EQ(verdict.finding, Finding::explained);  // never the same: the numbers are not
    EXPECT_EQ(verdict.fit.signs, (std::array<int, 3>{1, 1, 1}));
    // Half a step of 255, twice in s, over S0 of some 0.5.
    EXPECT_LT(verdict.difference, 0.01);
    EXPECT_NEAR(verdict.fit.dop_scale, 1.0, 0.01);
    EXPECT_EQ(adoptable(verdict, {}), std::nullopt);
    const std::string words = sentence(verdict, {});
    EXPECT_EQ(words.find("B has S1 to S3 stored as 0.5 + s/2; with that the pictures agree to"), 0U) << words;
    EXPECT_NE(words.find("Take s = 2 b - 1 of each number b first."), std::string::npos) << words;

    for (const SignChange& change : sign_changes()) {
        const StokesImage other = changed(a, [&](const Stokes<double>& s) {
            return in_8_bits({s.s0, change.signs[0] * s.s1, change.signs[1] * s.s2, change.signs[2] * s.s3}, 1.0);
        });
        const ConventionVerdict found = verdict_of(a, other);
        EXPECT_EQ(found.coding, Coding::offset) << change.name;
        EXPECT_EQ(found.fit.signs, change.signs) << change.name;
        // The reader took the file to be in another convention.
        const StokesConvention assumed{true, true, 90.0};
        const ConventionVerdict read =
            verdict_of(a, changed(other, [&](const Stokes<double>& s) { return assumed.to_ours(s); }));
        EXPECT_EQ(read.coding, Coding::offset) << change.name;
    }
}

TEST(StoredNumbers, AnOffsetOfSharesOfS0IsToldFromOneOfLight) {
    const StokesImage a = dim_scenery();
    const StokesImage b = changed(a, [](const Stokes<double>& s) {
        const Stokes<double> kept = in_8_bits(s, s.s0);
        return Stokes<double>{kept.s0, kept.s1, kept.s2, 1.0 - kept.s3};
    });
    const ConventionVerdict verdict = verdict_of(a, b);
    EXPECT_EQ(verdict.coding, Coding::ratio_offset);
    EXPECT_EQ(verdict.fit.signs, (std::array<int, 3>{1, 1, -1}));
    const std::string words = sentence(verdict, {});
    EXPECT_NE(words.find("S1 to S3 stored as 0.5 + s/(2 S0); and it has S3 with the other sign"), std::string::npos)
        << words;
    EXPECT_NE(words.find("s = (2 b - 1) S0"), std::string::npos) << words;
}

TEST(StoredNumbers, AnOffsetIsNotReadIntoOtherNumbers) {
    const StokesImage a = dim_scenery();
    // Positive everywhere, but not by an offset.
    const StokesImage rectified = changed(a, [](const Stokes<double>& s) {
        return Stokes<double>{s.s0, std::abs(s.s1), std::abs(s.s2), std::abs(s.s3)};
    });
    EXPECT_EQ(verdict_of(a, rectified).finding, Finding::disagree);
    EXPECT_EQ(verdict_of(a, rectified).coding, Coding::plain);
    // Slopes and intercepts of others.
    for (const auto& [intercept, slope] : std::vector<std::pair<double, double>>{{0.5, 0.25}, {0.3, 0.5}, {0.5, 1.0}}) {
        const double c = intercept, m = slope;
        const StokesImage b = changed(a, [&](const Stokes<double>& s) {
            return Stokes<double>{s.s0, c + m * s.s1, c + m * s.s2, c + m * s.s3};
        });
        EXPECT_EQ(verdict_of(a, b).coding, Coding::plain) << c << " + " << m << " s";
    }
    // The light behind a polarizer is the same everywhere: half of S0 is no offset.
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 0.001);
    const StokesImage polarizer = changed(a, [&](const Stokes<double>&) {
        return Stokes<double>{1.0, -1.0 + noise(random), 0.0, 0.0};
    });
    StokesImage dark = changed(polarizer, [&](const Stokes<double>& s) {
        return Stokes<double>{s.s0, 0.01 + noise(random), 0.0, 0.0};
    });
    dark.bands[0].known = StokesComponents::s0().with(1);
    EXPECT_EQ(verdict_of(polarizer, dark).coding, Coding::plain);
    EXPECT_EQ(verdict_of(a, a).coding, Coding::plain);
}

TEST(StoredNumbers, LightThatIsCutOffIsToldAndLeftOut) {
    const StokesImage a = scenery(40, 30);
    const double at = 2.0;
    std::size_t cut = 0;
    for (const Stokes<double>& s : a.stokes) cut += s.s0 >= at ? 1U : 0U;
    const double share = static_cast<double>(cut) / static_cast<double>(a.stokes.size());
    ASSERT_GT(share, 0.1);
    ASSERT_LT(share, 0.5);
    const StokesImage b = changed(a, [&](const Stokes<double>& s) {
        return Stokes<double>{std::min(s.s0, at), s.s1, s.s2, -s.s3};
    });
    const ConventionVerdict verdict = verdict_of(a, b);
    ASSERT_TRUE(verdict.clip.has_value());
    EXPECT_EQ(verdict.clip->at, at);
    EXPECT_NEAR(verdict.clip->share, share, 1e-12);
    // All that is left is exact.
    EXPECT_EQ(verdict.boxes, static_cast<int>(a.stokes.size() - cut));
    EXPECT_NEAR(verdict.fit.scale, 1.0, 1e-12);
    ASSERT_TRUE(verdict.gamma.has_value());
    EXPECT_NEAR(*verdict.gamma, 1.0, 1e-12);
    EXPECT_LT(verdict.difference, 1e-6);
    EXPECT_EQ(verdict.finding, Finding::explained);
    const std::string words = sentence(verdict, {});
    EXPECT_NE(words.find("S0 of B is clipped at 2 in "), std::string::npos) << words;
    // The other way round A is cut off, which is no fault of B.
    EXPECT_FALSE(verdict_of(b, a).clip.has_value());
}

TEST(StoredNumbers, ClippedHighlightsOfLargePicturesAreCountedByThePixel) {
    const StokesImage a = scenery(579, 193);  // boxes of 5 x 3
    const double at = 2.0;
    const StokesImage b = changed(a, [&](const Stokes<double>& s) {
        return Stokes<double>{std::min(s.s0, at), s.s1, s.s2, s.s3};
    });
    double cut = 0.0;
    for (const Stokes<double>& s : a.stokes) cut += s.s0 >= at ? 1.0 : 0.0;
    const ConventionVerdict verdict = verdict_of(a, b);
    ASSERT_TRUE(verdict.clip.has_value());
    // The pixels at the edges that fill no box are not counted: 4 of 579 columns, 1 of 193 rows.
    EXPECT_NEAR(verdict.clip->share, cut / static_cast<double>(a.stokes.size()), 0.02);
    EXPECT_NEAR(verdict.fit.scale, 1.0, 1e-12);
}

TEST(StoredNumbers, ALampOfOneBrightnessIsNotClipped) {
    std::mt19937 random(9);
    std::normal_distribution<double> noise(0.0, 0.2);
    StokesImage b = scenery(40, 30);
    for (Stokes<double>& s : b.stokes) s.s0 = std::min(s.s0, 2.0);
    EXPECT_FALSE(verdict_of(b, b).clip.has_value());
    // Neither if ours is noisy: it is no brighter there on average.
    const StokesImage a = changed(b, [&](const Stokes<double>& s) {
        return Stokes<double>{s.s0 + noise(random), s.s1, s.s2, s.s3};
    });
    EXPECT_FALSE(verdict_of(a, b).clip.has_value());
}

}  // namespace
}  // namespace pol::compare::test
