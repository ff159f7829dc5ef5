// SPDX-License-Identifier: Apache-2.0
// Ideal sheets and the crystal plate on emitters.
#include <gtest/gtest.h>

#include "optics/boundary_helpers.h"
#include "optics/crystal_plate.h"
#include "optics/elements.h"

namespace pol::test {
namespace {

const DVec3 x(1.0, 0.0, 0.0);
const DVec3 y(0.0, 1.0, 0.0);

JonesMatrix<double> jones(const Sheet& sheet, const DVec3& light, const DVec3& e1, const DVec3& e2) {
    return sheet_jones(sheet, up, light, e1, e2);
}
JonesMatrix<double> jones(const Sheet& sheet) {
    return jones(sheet, up, x, y);
}

DVec3 azimuth(double angle) {
    return {std::cos(angle), std::sin(angle), 0.0};
}

const auto unpolarized = CoherenceMatrix<double>::unpolarized(1.0);

TEST(Elements, T13PolarizersObeyMalus) {
    for (const double angle : {0.0, 0.3, 1.0, 1.4}) {
        const auto pair = jones(LinearPolarizer{azimuth(angle)}) * jones(LinearPolarizer{x});
        EXPECT_NEAR(trace(transform(pair, unpolarized)), 0.5 * std::cos(angle) * std::cos(angle), 4.0 * eps);
    }
    EXPECT_EQ(trace(transform(jones(LinearPolarizer{y}) * jones(LinearPolarizer{x}), unpolarized)), 0.0);
    const auto three =
        jones(LinearPolarizer{y}) * jones(LinearPolarizer{azimuth(45.0 * degree)}) * jones(LinearPolarizer{x});
    EXPECT_NEAR(trace(transform(three, unpolarized)), 0.125, 4.0 * eps);
    for (const int steps : {2, 5, 20}) {
        JonesMatrix<double> fan = jones(LinearPolarizer{x});
        for (int i = 1; i <= steps; ++i) fan = jones(LinearPolarizer{azimuth(i * 90.0 * degree / steps)}) * fan;
        EXPECT_NEAR(trace(transform(fan, unpolarized)), 0.5 * std::pow(std::cos(90.0 * degree / steps), 2 * steps),
                    32.0 * eps);
    }
}

// Korger et al. 2013: film absorbs along b in the sheet, so a ray k at the angle t to the normal leaves with E along k
// x b. With b = (-1, 1, 0)/sqrt 2 and k in the xz plane that is (1, cos t) in the frame (cos t, 0, -sin t), y: azimuth
// atan(cos t), where projecting the passing axis would give atan(1/cos t).
TEST(Elements, ATiltedPolarizerProjectsTheAxisThatItBlocks) {
    for (const double t : {-60.0, 0.0, 15.0, 30.0, 45.0}) {
        const DVec3 light = tilted(t * degree);
        const DVec3 across(std::cos(t * degree), 0.0, -std::sin(t * degree));
        const auto azimuth_behind = [&](PolarizerModel model) {
            const auto m = jones(LinearPolarizer{DVec3(1.0, 1.0, 0.0), model}, light, across, y);
            const Stokes<double> s = to_stokes(transform(m, unpolarized));
            EXPECT_NEAR(s.s0, 0.5, 8.0 * eps);
            EXPECT_NEAR(std::hypot(s.s1, s.s2), s.s0, 8.0 * eps);
            return 0.5 * std::atan2(s.s2, s.s1);
        };
        EXPECT_NEAR(azimuth_behind(PolarizerModel::blocking), std::atan(std::cos(t * degree)), 16.0 * eps);
        EXPECT_NEAR(azimuth_behind(PolarizerModel::passing), std::atan(1.0 / std::cos(t * degree)), 16.0 * eps);
    }
}

TEST(Elements, ATiltedPolarizerIsTheSameFromBothFacesAndInAnyFrame) {
    Dice dice(5);
    for (int i = 0; i < 50; ++i) {
        const DVec3 light = dice.direction();
        const DVec3 normal = dice.direction();
        const DVec3 e1 = any_perpendicular(light);
        const DVec3 e2 = cross(light, e1);
        const LinearPolarizer film{cross(normal, dice.direction())};
        const auto m = sheet_jones(film, normal, light, e1, e2);
        const auto back = sheet_jones(film, -normal, light, e1, e2);
        EXPECT_EQ(m, back);
        // What passes lies across the light and across the axis in the sheet that is blocked.
        const DVec3 blocked = cross(normal, film.axis);
        const DVec3 passed = m[0][0].re * e1 + m[1][0].re * e2;
        EXPECT_NEAR(dot(passed, blocked), 0.0, 8.0 * eps);
    }
}

TEST(Elements, AQuarterWavePlateMakesDiagonalLightCircular) {
    // Fast axis x: y gains +pi/2 with exp(-i omega t), so E_y = +i E_x: left circular, s3 < 0 (PHYSICS.md 1).
    const Retarder quarter{x, 90.0 * degree};
    const auto plus45 = CoherenceMatrix<double>::outer({std::sqrt(0.5), std::sqrt(0.5)});
    const Stokes<double> s = to_stokes(transform(jones(quarter), plus45));
    EXPECT_NEAR(s.s3, -1.0, 4.0 * eps);
    // The same light and plate seen in a left-handed basis is the same operator on the same field.
    const auto mirrored = jones(quarter, up, x, -y);
    const Stokes<double> m =
        to_stokes(transform(mirrored, CoherenceMatrix<double>::outer({std::sqrt(0.5), -std::sqrt(0.5)})));
    EXPECT_NEAR(m.s3, 1.0, 4.0 * eps);
}

TEST(Elements, AHalfWavePlateTurnsTheAzimuthByTwiceTheAngleOfItsAxis) {
    const double phi = 0.4;
    const Retarder half{azimuth(phi), 180.0 * degree};
    const Stokes<double> s = to_stokes(transform(jones(half), CoherenceMatrix<double>::outer({1.0, 0.0})));
    EXPECT_NEAR(s.s1, std::cos(4.0 * phi), 8.0 * eps);
    EXPECT_NEAR(s.s2, std::sin(4.0 * phi), 8.0 * eps);
    EXPECT_NEAR(s.s3, 0.0, 4.0 * eps);
}

TEST(Elements, ARetarderKeepsEnergyAtAnyObliquity) {
    Dice dice(3);
    for (int i = 0; i < 100; ++i) {
        const DVec3 k = dice.direction();
        const DVec3 e1 = any_perpendicular(k);
        const auto m = jones(Retarder{dice.direction(), dice.uniform(-7.0, 7.0)}, k, e1, cross(k, e1));
        EXPECT_NEAR(trace(transform(m, unpolarized)), 1.0, 8.0 * eps);
        EXPECT_NEAR(trace(transform(m, CoherenceMatrix<double>::outer({0.6, {0.0, 0.8}}))), 1.0, 8.0 * eps);
        EXPECT_EQ(m[0][1], m[1][0]);  // reciprocal
    }
}

TEST(Elements, ACircularPolarizerPassesItsHandFromEitherSide) {
    const JonesVector<double> right{std::sqrt(0.5), {0.0, -std::sqrt(0.5)}};
    const JonesVector<double> left{std::sqrt(0.5), {0.0, std::sqrt(0.5)}};
    for (const DVec3& light : {up, -up}) {
        const DVec3 e2 = cross(light, x);  // right-handed about the light
        const auto passes_right = jones(CircularPolarizer{Handedness::right}, light, x, e2);
        EXPECT_NEAR(trace(transform(passes_right, CoherenceMatrix<double>::outer(right))), 1.0, 4.0 * eps);
        EXPECT_NEAR(trace(transform(passes_right, CoherenceMatrix<double>::outer(left))), 0.0, 4.0 * eps);
        EXPECT_NEAR(to_stokes(transform(passes_right, unpolarized)).s3, 0.5, 4.0 * eps);
        const auto passes_left = jones(CircularPolarizer{Handedness::left}, light, x, e2);
        EXPECT_NEAR(to_stokes(transform(passes_left, unpolarized)).s3, -0.5, 4.0 * eps);
    }
}

TEST(CrystalPlate, PassesHalfTheLightInOneLinearState) {
    const auto crystal = calcite({1.0, 0.0, 0.0});
    for (const CrystalRay ray : {CrystalRay::ordinary, CrystalRay::extraordinary}) {
        const auto j = crystal_plate_state(crystal, up, up, 1.0, ray, false, x, y);
        EXPECT_NEAR(trace(j), 0.5, 4.0 * eps);
        EXPECT_NEAR(to_stokes(j).s1, ray == CrystalRay::ordinary ? -0.5 : 0.5, 4.0 * eps);  // o: E across the axis
    }
}

TEST(CrystalPlate, WithFresnelTheExitFaceDimsIt) {
    // Normal incidence on an a-cut: T = 1 - ((n - 1)/(n + 1))^2 with the index of the mode.
    const auto crystal = calcite({1.0, 0.0, 0.0});
    const auto o = crystal_plate_state(crystal, up, up, 1.0, CrystalRay::ordinary, true, x, y);
    const auto e = crystal_plate_state(crystal, up, up, 1.0, CrystalRay::extraordinary, true, x, y);
    EXPECT_NEAR(trace(o), 0.5 * (1.0 - std::pow(0.6584 / 2.6584, 2)), 4.0 * eps);
    EXPECT_NEAR(trace(e), 0.5 * (1.0 - std::pow(0.4864 / 2.4864, 2)), 4.0 * eps);
}

TEST(CrystalPlate, AgreesWithLightSentForwardThroughTheFace) {
    const auto crystal = calcite({1.0, 2.0, 3.0});
    for (const int mode : {0, 1}) {
        const Wave<double> inside = waves_of_wave_normal(crystal, unit(DVec3(0.2, 0.3, 0.9))).wave[mode];
        const auto r = respond(crystal, air, up, inside);
        const auto* out = find(r, Side::transmitted, WaveKind::pair);
        ASSERT_NE(out, nullptr);
        const DVec3 e1 = out->wave.field[0], e2 = out->wave.field[1];
        const auto expected = CoherenceMatrix<double>::outer({out->amplitude[0][0], out->amplitude[1][0]});
        const auto state =
            crystal_plate_state(crystal, up, out->wave.ray, 1.0,
                                mode == 0 ? CrystalRay::ordinary : CrystalRay::extraordinary, true, e1, e2);
        EXPECT_NEAR(state.xx, 0.5 * expected.xx, 16.0 * eps);
        EXPECT_NEAR(state.yy, 0.5 * expected.yy, 16.0 * eps);
        EXPECT_NEAR(state.xy.re, 0.5 * expected.xy.re, 16.0 * eps);
        EXPECT_NEAR(state.xy.im, 0.5 * expected.xy.im, 16.0 * eps);
    }
}

TEST(CrystalPlate, AlongTheAxisHalfTheLightPassesUnpolarizedAndNothingGoesInward) {
    const auto j = crystal_plate_state(calcite(up), up, up, 1.0, CrystalRay::ordinary, false, x, y);
    EXPECT_NEAR(j.xx, 0.25, 4.0 * eps);
    EXPECT_NEAR(j.yy, 0.25, 4.0 * eps);
    EXPECT_EQ(trace(crystal_plate_state(calcite(x), up, -up, 1.0, CrystalRay::ordinary, false, x, y)), 0.0);
}

}  // namespace
}  // namespace pol::test
