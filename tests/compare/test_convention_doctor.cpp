// SPDX-License-Identifier: Apache-2.0
// The doctor on pictures whose convention was changed on purpose. The 24 cases and their verdicts are those of a
// separate implementation, in numpy.
#include "compare/convention_doctor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "compare/scenery.h"

namespace pol::compare::test {
namespace {

using nlohmann::json;

StokesImage picture_of(const json& rows) {
    StokesImage image = picture(static_cast<int>(rows.at(0).size()), static_cast<int>(rows.size()));
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const json& p = rows.at(static_cast<std::size_t>(y)).at(static_cast<std::size_t>(x));
            image.stokes[image.pixel(x, y)] = {p.at(0), p.at(1), p.at(2), p.at(3)};
        }
    }
    return image;
}

const json& cases() {
    static const json all = json::parse(std::ifstream(POL_TESTS_DIR "/compare/data/convention_cases.json"));
    return all;
}

TEST(ConventionDoctor, AllTwentyFourCasesHaveTheirVerdicts) {
    ASSERT_EQ(cases().at("cases").size(), 24U);
    for (const json& one : cases().at("cases")) {
        SCOPED_TRACE(one.at("name").get<std::string>());
        const StokesImage a = picture_of(one.contains("reference") ? one.at("reference") : cases().at("reference"));
        const StokesImage b = picture_of(one.at("other"));
        const ConventionVerdict verdict = verdict_of(a, b);
        const json& expected = one.at("expected");
        EXPECT_EQ(name_of(verdict.finding), expected.at("verdict").get<std::string>());
        EXPECT_EQ(name_of(verdict.fit.frame), expected.at("kind").get<std::string>());
        EXPECT_EQ(name_of(verdict.fit.geometry), expected.at("geometry").get<std::string>());
        EXPECT_EQ(verdict.fit.order, (expected.at("order").get<std::array<int, 3>>()));
        EXPECT_EQ(verdict.fit.signs, (expected.at("signs").get<std::array<int, 3>>()));
        EXPECT_EQ(verdict.fit.turn_deg.has_value(), !expected.at("turn_deg").is_null());
        if (verdict.fit.turn_deg && !expected.at("turn_deg").is_null()) {
            // The file has four digits of each number.
            EXPECT_NEAR(*verdict.fit.turn_deg, expected.at("turn_deg").get<double>(), 0.01);
        }
        for (unsigned i = 1; i < 4; ++i) {
            const auto& names = expected.at("undecided");
            const bool is_undecided = std::find(names.begin(), names.end(), "S" + std::to_string(i)) != names.end();
            EXPECT_EQ(verdict.undecided.has(i), is_undecided) << "S" << i;
        }
        // Expected numbers are rounded to four and three places.
        EXPECT_NEAR(verdict.fit.scale, expected.at("scale").get<double>(), 0.5001e-4);
        ASSERT_TRUE(verdict.gamma.has_value());
        EXPECT_NEAR(*verdict.gamma, expected.at("gamma").get<double>(), 0.5001e-3);
        EXPECT_FALSE(sentence(verdict, {}).empty());
    }
}

TEST(ConventionDoctor, EveryCombinationOfSignsIsFoundAndTakenBack) {
    const StokesImage a = scenery(40, 30);
    for (const SignChange& change : sign_changes()) {
        SCOPED_TRACE(std::string(change.name));
        StokesImage b = changed(a, [&](const Stokes<double>& s) {
            return Stokes<double>{s.s0, change.signs[0] * s.s1, change.signs[1] * s.s2, change.signs[2] * s.s3};
        });
        const ConventionVerdict verdict = verdict_of(a, b);
        EXPECT_EQ(verdict.fit.signs, change.signs);
        EXPECT_EQ(verdict.undecided, StokesComponents());
        const bool is_same = change.signs == sign_changes().front().signs;
        EXPECT_EQ(verdict.finding, is_same ? Finding::same_convention : Finding::explained);
        const auto convention = adoptable(verdict, {});
        ASSERT_EQ(convention.has_value(), !is_same);
        if (!convention) continue;
        for (std::size_t p = 0; p < a.stokes.size(); ++p) EXPECT_EQ(convention->to_ours(b.stokes[p]), a.stokes[p]);
    }
}

TEST(ConventionDoctor, WhatIsAdoptedBuildsOnWhatWasAssumed) {
    // Written in one convention, read in another: whatever both are, the doctor finds the first.
    const StokesImage a = scenery(40, 30);
    std::vector<StokesConvention> conventions;
    for (const bool left_handed : {false, true})
        for (const bool y_down : {false, true})
            for (const double zero : {0.0, 45.0, 90.0, 135.0, 20.0}) conventions.push_back({left_handed, y_down, zero});
    for (const StokesConvention& written : conventions) {
        for (const StokesConvention& assumed : conventions) {
            SCOPED_TRACE(written.text() + " read as " + assumed.text());
            const StokesImage b =
                changed(a, [&](const Stokes<double>& s) { return assumed.to_ours(written.from_ours(s)); });
            const ConventionVerdict verdict = verdict_of(a, b);
            const StokesConvention adopted = adoptable(verdict, assumed).value_or(assumed);
            EXPECT_EQ(adopted.left_handed, written.left_handed);
            EXPECT_EQ(adopted.y_down, written.y_down);
            // The angle that is found is exact but for rounding.
            EXPECT_NEAR(std::remainder(adopted.azimuth_zero_deg - written.azimuth_zero_deg, 180.0), 0.0, 1e-9);
            for (std::size_t p = 0; p < a.stokes.size(); ++p) {
                const Stokes<double> mended = adopted.to_ours(assumed.from_ours(b.stokes[p]));
                EXPECT_NEAR(mended.s1, a.stokes[p].s1, 1e-12);
                EXPECT_NEAR(mended.s2, a.stokes[p].s2, 1e-12);
                EXPECT_NEAR(mended.s3, a.stokes[p].s3, 1e-12);
            }
        }
    }
}

TEST(ConventionDoctor, CircularLightBelowTheNoiseIsLeftUndecided) {
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, 0.02);
    StokesImage a = scenery(40, 30);
    for (Stokes<double>& s : a.stokes) s.s3 *= 1e-4;
    const StokesImage b = changed(a, [&](const Stokes<double>& s) {
        return Stokes<double>{s.s0 + noise(random), s.s1 + noise(random), -s.s2 + noise(random), -s.s3 + noise(random)};
    });
    const ConventionVerdict verdict = verdict_of(a, b);
    EXPECT_EQ(verdict.finding, Finding::explained);
    EXPECT_EQ(verdict.undecided, StokesComponents().with(3));
    const std::vector<SignChange> fitting = fitting_sign_changes(verdict);
    ASSERT_EQ(fitting.size(), 2U);
    EXPECT_EQ(fitting[0].name, "y down");
    EXPECT_EQ(fitting[1].name, "S2 alone");
    // The simplest of both: handedness stays as it was.
    EXPECT_EQ(adoptable(verdict, {}), (StokesConvention{false, true, 0.0}));
    EXPECT_NE(sentence(verdict, {}).find("y down, or S2 alone would fit"), std::string::npos) << sentence(verdict, {});
}

TEST(ConventionDoctor, KnownErrorBarsKeepNoiseFromBeingTakenForPolarization) {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 0.01);
    StokesImage a = scenery(40, 30);
    for (Stokes<double>& s : a.stokes) s = {s.s0, 0.0, 0.0, 0.0};
    StokesImage b = changed(a, [&](const Stokes<double>& s) {
        return Stokes<double>{s.s0, noise(random), noise(random), noise(random)};
    });
    EXPECT_EQ(verdict_of(a, b).finding, Finding::one_unpolarized);
    b.sampling_error.assign(b.stokes.size(), {0.01, 0.01, 0.01, 0.01});
    EXPECT_EQ(verdict_of(a, b).finding, Finding::unpolarized);
}

TEST(ConventionDoctor, ASymmetricSceneIsNotTakenForAMirroredOne) {
    // Its mirror image has the signs of y down: left and right are seen in the other hand.
    StokesImage a = scenery(40, 30);
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width / 2; ++x) {
            const Stokes<double>& s = a.stokes[a.pixel(x, y)];
            a.stokes[a.pixel(a.width - 1 - x, y)] = {s.s0, s.s1, -s.s2, -s.s3};
        }
    }
    const ConventionVerdict verdict = verdict_of(a, a);
    EXPECT_EQ(verdict.finding, Finding::same_convention);
    EXPECT_EQ(verdict.fit.geometry, Geometry::same);
    EXPECT_EQ(verdict.tied, (std::vector<Geometry>{Geometry::same, Geometry::flip_x}));
    EXPECT_NE(sentence(verdict, {}).find("symmetric"), std::string::npos) << sentence(verdict, {});
}

TEST(ConventionDoctor, AComponentThatWasNotMeasuredIsNotJudged) {
    const StokesImage a = scenery(40, 30);
    StokesImage b = changed(a, [](const Stokes<double>& s) { return Stokes<double>{s.s0, s.s1, -s.s2, 0.0}; });
    b.bands[0].known = StokesComponents::linear();
    const ConventionVerdict verdict = verdict_of(a, b);
    EXPECT_EQ(verdict.finding, Finding::explained);
    EXPECT_EQ(verdict.judged, StokesComponents().with(1).with(2));
    EXPECT_EQ(verdict.undecided, StokesComponents());
    EXPECT_EQ(adoptable(verdict, {}), (StokesConvention{false, true, 0.0}));
    EXPECT_NE(sentence(verdict, {}).find("S3 is not measured in both"), std::string::npos) << sentence(verdict, {});
}

TEST(ConventionDoctor, APhotographOnlyTellsWhetherTheViewIsTheSame) {
    const StokesImage a = scenery(40, 30);
    StokesImage b = changed(a, [](const Stokes<double>& s) { return Stokes<double>{2.0 * s.s0, 0.0, 0.0, 0.0}; });
    b.bands[0].known = StokesComponents::s0();
    const ConventionVerdict verdict = verdict_of(a, b);
    EXPECT_EQ(verdict.finding, Finding::not_measured);
    EXPECT_NEAR(verdict.fit.scale, 2.0, 1e-12);
    EXPECT_EQ(adoptable(verdict, {}), std::nullopt);
}

TEST(ConventionDoctor, ASumOverFourPolarizersThatWasNotHalvedIsTold) {
    const StokesImage a = scenery(40, 30);
    const StokesImage b = changed(a, [](const Stokes<double>& s) {
        return Stokes<double>{2.0 * s.s0, s.s1, s.s2, s.s3};
    });
    const ConventionVerdict verdict = verdict_of(a, b);
    EXPECT_EQ(verdict.finding, Finding::same_convention);
    EXPECT_NEAR(verdict.fit.scale, 2.0, 1e-12);
    EXPECT_NEAR(verdict.fit.dop_scale, 0.5, 1e-12);
    EXPECT_NE(sentence(verdict, {}).find("degree of polarization is 0.5 times ours"), std::string::npos);
}

TEST(ConventionDoctor, EvenLightIsNoOtherPicture) {
    // A lamp that fills the picture, behind a polarizer: S0 has nothing to correlate.
    StokesImage a = picture(8, 8);
    a.stokes.assign(a.stokes.size(), {1.0, 0.5, 0.2, 0.1});
    const StokesImage b = changed(a, [](const Stokes<double>& s) { return Stokes<double>{s.s0, s.s1, s.s2, -s.s3}; });
    const ConventionVerdict verdict = verdict_of(a, b);
    EXPECT_EQ(verdict.finding, Finding::explained);
    EXPECT_EQ(verdict.fit.signs, (std::array<int, 3>{1, 1, -1}));
    EXPECT_FALSE(verdict.gamma.has_value());
}

TEST(ConventionDoctor, BlackPicturesHaveNothingInCommon) {
    const StokesImage black = picture(8, 8);
    EXPECT_EQ(verdict_of(black, black).finding, Finding::nothing_in_common);
    EXPECT_EQ(verdict_of(scenery(8, 8), scenery(9, 9)).finding, Finding::nothing_in_common);
    EXPECT_EQ(verdict_of(scenery(2, 2), scenery(2, 2)).finding, Finding::nothing_in_common);
}

TEST(ConventionDoctor, AFrameProjectedAcrossTheRayIsFoundWhereTheFieldOfViewIsKnown) {
    // x of B: the camera's right without its part along the ray; of A: across the ray and up. Both by their vectors.
    const int side = 48;
    const double pixel_tangent = 1.2 / (0.5 * side);  // 100 degrees across
    const StokesImage a = scenery(side, side);
    StokesImage b = a;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const double sx = (x + 0.5 - 0.5 * side) * pixel_tangent;
            const double sy = (0.5 * side - y - 0.5) * pixel_tangent;
            const double length = std::sqrt(1.0 + sx * sx + sy * sy);
            // right = (1, 0, 0), up = (0, 1, 0), the camera looks along (0, 0, -1).
            const std::array<double, 3> d{sx / length, sy / length, -1.0 / length};
            std::array<double, 3> ours_x{-d[2], 0.0, d[0]};  // d x up
            const double norm = std::hypot(ours_x[0], ours_x[2]);
            for (double& v : ours_x) v /= norm;
            const std::array<double, 3> ours_y{ours_x[1] * d[2] - ours_x[2] * d[1], ours_x[2] * d[0] - ours_x[0] * d[2],
                                               ours_x[0] * d[1] - ours_x[1] * d[0]};
            const std::array<double, 3> theirs_x{1.0 - d[0] * d[0], -d[0] * d[1], -d[0] * d[2]};
            double along = 0.0, across = 0.0;
            for (std::size_t i = 0; i < 3; ++i) {
                along += theirs_x[i] * ours_x[i];
                across += theirs_x[i] * ours_y[i];
            }
            const double angle = 2.0 * std::atan2(across, along);
            Stokes<double>& s = b.stokes[b.pixel(x, y)];
            s = {s.s0, s.s1 * std::cos(angle) + s.s2 * std::sin(angle), s.s2 * std::cos(angle) - s.s1 * std::sin(angle),
                 s.s3};
        }
    }
    const ConventionVerdict verdict = diagnose(whole(a), whole(b), pixel_tangent);
    EXPECT_EQ(verdict.finding, Finding::explained);
    EXPECT_EQ(verdict.fit.frame, FrameChange::projected);
    EXPECT_LT(verdict.polarization_residual, 1e-6);
    EXPECT_EQ(adoptable(verdict, {}), std::nullopt);
    EXPECT_EQ(diagnose(whole(b), whole(a), pixel_tangent).fit.frame, FrameChange::unprojected);
}

TEST(StokesPlane, BoxesOfAPictureAndOfItsMirrorImageAreTheSame) {
    for (const int width : {1, 63, 192, 193, 384, 385, 386, 1000, 1001}) {
        const StokesImage image = scenery(width, 2);
        StokesImage mirror = image;
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < width; ++x)
                mirror.stokes[mirror.pixel(width - 1 - x, y)] = image.stokes[image.pixel(x, y)];
        const StokesPlane one = whole(image);
        const StokesPlane other = whole(mirror);
        ASSERT_GE(one.width, std::min(width, 63)) << width;
        ASSERT_LE(one.width, 192) << width;
        for (int x = 0; x < one.width; ++x) {
            const auto i = static_cast<std::size_t>(x);
            const auto j = static_cast<std::size_t>(one.width - 1 - x);
            EXPECT_NEAR(one.light[i].s0, other.light[j].s0, 1e-12) << width << ' ' << x;
        }
    }
}

TEST(StokesPlane, PixelsThatAreNoLightAreLeftOutOfTheMean) {
    StokesImage image = picture(579, 3);  // boxes of 5 x 1
    image.stokes.assign(image.stokes.size(), {1.0, 0.5, 0.0, 0.0});
    const StokesPlane clean = whole(image);
    ASSERT_EQ(clean.box_width, 5);
    const int first = (579 - 5 * clean.width) / 2;
    image.stokes[image.pixel(first, 0)].s1 = std::numeric_limits<double>::quiet_NaN();
    image.stokes[image.pixel(first + 1, 0)].s0 = -1.0;
    const StokesPlane some = whole(image);
    EXPECT_EQ(some.counts[0], 1);
    EXPECT_EQ(some.light[0], (Stokes<double>{1.0, 0.5, 0.0, 0.0}));
    image.residual.assign(image.pixel_count(), 0.0);
    image.residual[image.pixel(first + 2, 0)] = 0.2;
    EXPECT_EQ(whole(image).counts[0], 0);
    EXPECT_EQ(whole(image).counts[1], 1);
}

}  // namespace
}  // namespace pol::compare::test
