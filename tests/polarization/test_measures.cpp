// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/units.h"
#include "polarization/coherence_matrix.h"
#include "polarization/measures.h"

namespace pol {
namespace {

using Jones = JonesVector<double>;
using Coherence = CoherenceMatrix<double>;

// hypot is good to 1 ulp, division and addition to half an ulp each, atan2 to 1 ulp: every measure, of order 1, is good
// to about 4 epsilon = 9e-16 once the Stokes vector is exact. Building it with sin and cos adds a few more.
constexpr double rounding = 4e-15;

/// Stokes vector of a state with given measures (Born & Wolf, 7th ed., eq. 1.4.45).
Stokes<double> state(double s0, double dop, double azimuth, double chi) {
    return {s0, s0 * dop * std::cos(2.0 * chi) * std::cos(2.0 * azimuth),
            s0 * dop * std::cos(2.0 * chi) * std::sin(2.0 * azimuth), s0 * dop * std::sin(2.0 * chi)};
}

double axial_distance(double a, double b) {
    return std::abs(std::remainder(a - b, pi));
}

TEST(Measures, AreThoseTheStateWasMadeFrom) {
    for (const double dop : {1e-6, 0.1, 0.5, 1.0}) {
        for (double azimuth = -1.5; azimuth <= 1.5; azimuth += 0.25) {
            for (const double chi : {-0.75, -0.3, -1e-5, 1e-5, 0.2, 0.78}) {
                const Measures<double> m = measure(state(3.0, dop, azimuth, chi));
                EXPECT_NEAR(m.dop, dop, rounding * dop);
                EXPECT_NEAR(m.dolp, dop * std::cos(2.0 * chi), rounding * dop);
                EXPECT_NEAR(m.docp, dop * std::abs(std::sin(2.0 * chi)), rounding * dop);
                EXPECT_NEAR(m.unpolarized, 1.0 - dop, rounding);
                EXPECT_NEAR(m.ellipticity, std::abs(std::tan(chi)), rounding);
                EXPECT_NEAR(m.ellipticity_angle, chi, rounding);
                // A vector error of epsilon turns a linear part cos(2 chi) by epsilon/cos(2 chi); 0.78 leaves 0.011.
                EXPECT_LT(axial_distance(m.azimuth, azimuth), rounding / std::cos(2.0 * chi));
                EXPECT_EQ(m.handedness, chi > 0.0 ? 1 : -1);
                EXPECT_TRUE(m.has_light && m.has_polarization && m.has_azimuth);
            }
        }
    }
}

// tan(asin(s3/p)/2) errs by 1e-8 near circular light; the form in use does not (PHYSICS.md 1).
TEST(Measures, EllipticityIsGoodToRoundingNextToCircular) {
    const double linear = 1e-9;
    const Measures<double> m = measure(Stokes<double>{1.0, linear, 0.0, std::sqrt((1.0 - linear) * (1.0 + linear))});
    // e = s3/(1 + linear) = 1 - linear + O(linear^2)
    EXPECT_NEAR(m.ellipticity, 1.0 - linear, 1e-15);
    EXPECT_NEAR(m.ellipticity_angle, pi / 4.0 - linear / 2.0, 1e-15);
}

// sqrt(1 - 4 det/tr^2) gives 0 here.
TEST(Measures, DegreeOfPolarizationKeepsItsDigitsWhereItIsTiny) {
    const Measures<double> m = measure(Stokes<double>{1.0, 3e-12, 4e-12, 0.0});
    EXPECT_NEAR(m.dop, 5e-12, 5e-12 * rounding);
}

TEST(Measures, T46TwoEqualLinearStatesAtAnAngleHaveDopCosine) {
    for (double angle = 0.0; angle <= pi; angle += pi / 24.0) {
        const Coherence sum = Coherence::outer({1.0, 0.0}) + Coherence::outer({std::cos(angle), std::sin(angle)});
        const Measures<double> m = measure(to_stokes(sum));
        EXPECT_NEAR(m.dop, std::abs(std::cos(angle)), rounding);
        EXPECT_EQ(m.ellipticity, 0.0);
    }
}

TEST(Measures, T47OrthogonalEqualStatesAreUnpolarizedAndHaveNoEllipticity) {
    for (const double chi : {0.0, 0.2, 0.6, pi / 4.0}) {
        for (double azimuth = 0.0; azimuth < pi; azimuth += 0.3) {
            const Stokes<double> sum = state(1.0, 1.0, azimuth, chi) + state(1.0, 1.0, azimuth + pi / 2.0, -chi);
            const Measures<double> m = measure(sum, noise_threshold(2.0));
            EXPECT_NEAR(m.dop, 0.0, rounding);
            EXPECT_FALSE(m.has_polarization);
            EXPECT_EQ(m.ellipticity, 0.0);
            EXPECT_EQ(m.handedness, 0);
        }
    }
}

TEST(Measures, T48TurningTheBasisTurnsOnlyTheAzimuth) {
    const Stokes<double> s = state(2.0, 0.7, 0.4, -0.3);
    const Measures<double> before = measure(s);
    for (double angle = -3.0; angle <= 3.0; angle += 0.37) {
        const Measures<double> after = measure(rotate_basis(s, angle));
        EXPECT_NEAR(after.dop, before.dop, rounding);
        EXPECT_NEAR(after.ellipticity, before.ellipticity, rounding);
        EXPECT_NEAR(after.ellipticity_angle, before.ellipticity_angle, rounding);
        EXPECT_EQ(after.handedness, before.handedness);
        EXPECT_LT(axial_distance(after.azimuth, before.azimuth - angle), rounding);
    }
}

TEST(Measures, T49ScalingTheLightByPowersOfTwoChangesNotOneBit) {
    const Stokes<double> s = state(1.0, 0.3, 1.1, 0.25);
    const Measures<double> one = measure(s);
    for (const int exponent : {-990, -100, -1, 1, 100, 990}) {  // 1e-298 to 1e298
        const Measures<double> scaled = measure(std::ldexp(1.0, exponent) * s);
        EXPECT_EQ(scaled.dop, one.dop);
        EXPECT_EQ(scaled.dolp, one.dolp);
        EXPECT_EQ(scaled.docp, one.docp);
        EXPECT_EQ(scaled.unpolarized, one.unpolarized);
        EXPECT_EQ(scaled.ellipticity, one.ellipticity);
        EXPECT_EQ(scaled.ellipticity_angle, one.ellipticity_angle);
        EXPECT_EQ(scaled.azimuth, one.azimuth);
        EXPECT_TRUE(scaled.has_light && scaled.has_polarization && scaled.has_azimuth);
    }
}

TEST(Measures, T49ScalingFrom1em30To1e30ChangesOnlyTheLastDigits) {
    const Stokes<double> s = state(1.0, 0.3, 1.1, 0.25);
    const Measures<double> one = measure(s);
    for (const double scale : {1e-300, 1e-30, 1e30, 1e300}) {
        const Measures<double> scaled = measure(scale * s);
        EXPECT_NEAR(scaled.dop, one.dop, rounding);
        EXPECT_NEAR(scaled.ellipticity, one.ellipticity, rounding);
        EXPECT_NEAR(scaled.azimuth, one.azimuth, rounding);
    }
}

TEST(Measures, T50MirroringThePictureFlipsS2AndS3AndNothingElse) {
    const Stokes<double> s = state(1.0, 0.8, 0.4, 0.3);
    const Measures<double> m = measure(s);
    const Measures<double> mirrored = measure(Stokes<double>{s.s0, s.s1, -s.s2, -s.s3});
    EXPECT_EQ(mirrored.dop, m.dop);
    EXPECT_EQ(mirrored.ellipticity, m.ellipticity);
    EXPECT_EQ(mirrored.ellipticity_angle, -m.ellipticity_angle);
    EXPECT_EQ(mirrored.azimuth, -m.azimuth);
    EXPECT_EQ(mirrored.handedness, -m.handedness);
}

TEST(Measures, OfNoLightAreZeroAndFlagged) {
    const Measures<double> m = measure(Stokes<double>{});
    EXPECT_FALSE(m.has_light || m.has_polarization || m.has_azimuth);
    for (const double value : {m.dop, m.dolp, m.docp, m.unpolarized, m.ellipticity, m.ellipticity_angle, m.azimuth}) {
        EXPECT_EQ(value, 0.0);
    }
}

TEST(Measures, OfNoiseBelowTheThresholdHaveNoEllipticity) {
    const Stokes<double> noise{1.0, 1e-17, -2e-17, 3e-17};
    EXPECT_FALSE(measure(noise).has_polarization);
    EXPECT_EQ(measure(noise).ellipticity, 0.0);
    // The threshold grows with the number of terms: 1e-13 is noise in a sum of 1000 parts, not in a sum of 10.
    const Stokes<double> weak{1.0, 1e-13, 0.0, 0.0};
    EXPECT_TRUE(measure(weak, noise_threshold(10.0)).has_polarization);
    EXPECT_FALSE(measure(weak, noise_threshold(1000.0)).has_polarization);
}

TEST(Measures, CircularLightHasNoAzimuth) {
    const Measures<double> m = measure(Stokes<double>{1.0, 1e-17, 0.0, 1.0});
    EXPECT_TRUE(m.has_polarization);
    EXPECT_FALSE(m.has_azimuth);
    EXPECT_EQ(m.azimuth, 0.0);
    EXPECT_EQ(m.ellipticity, 1.0);
}

TEST(Measures, VerticalLightHasAzimuthPlus90WhateverTheSignOfItsZero) {
    EXPECT_DOUBLE_EQ(measure(Stokes<double>{1.0, -1.0, 0.0, 0.0}).azimuth, pi / 2.0);
    EXPECT_DOUBLE_EQ(measure(Stokes<double>{1.0, -1.0, -0.0, 0.0}).azimuth, pi / 2.0);
}

TEST(Measures, OfWhatIsNoLightAreNotNumbers) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const Stokes<double>& s : {Stokes<double>{nan, 0.0, 0.0, 0.0}, Stokes<double>{1.0, nan, 0.0, 0.0},
                                    Stokes<double>{1.0, 0.0, 0.0, infinity}, Stokes<double>{-1.0, 0.0, 0.0, 0.0},
                                    Stokes<double>{0.0, 1.0, 0.0, 0.0}, Stokes<double>{infinity, 0.0, 0.0, 0.0}}) {
        const Measures<double> m = measure(s);
        EXPECT_TRUE(std::isnan(m.dop) && std::isnan(m.ellipticity) && std::isnan(m.azimuth));
        EXPECT_FALSE(m.has_light || m.has_polarization || m.has_azimuth);
    }
}

TEST(Measures, ADegreeAboveOneIsShownNotRepaired) {
    EXPECT_DOUBLE_EQ(measure(Stokes<double>{1.0, 1.5, 0.0, 0.0}).dop, 1.5);
}

TEST(Measures, WorkInLongDoubleToo) {
    const Measures<long double> m = measure(Stokes<long double>{1.0L, 0.6L, 0.0L, 0.8L});
    EXPECT_NEAR(static_cast<double>(m.ellipticity - 0.5L), 0.0, 1e-18);
}

// Two fields at a tiny angle t: P = cos t, so 1 - P = 2 sin^2(t/2), of which 1 - p/s0 keeps nothing below t = 1e-8.
TEST(UnpolarizedFraction, KeepsItsDigitsForNearlyPolarizedLight) {
    for (const double t : {1.0, 1e-3, 1e-6, 1e-9, 1e-12}) {
        const double half = std::sin(t / 2.0);
        for (const double scale : {1e-150, 1.0, 1e150}) {
            const std::vector<Jones> fields{{scale, 0.0}, {scale * std::cos(t), scale * std::sin(t)}};
            const double expected = 2.0 * half * half;
            EXPECT_NEAR(unpolarized_fraction<double>(fields), expected, rounding * expected);
        }
    }
}

TEST(UnpolarizedFraction, AgreesWithTheDegreeOfPolarization) {
    const std::vector<Jones> fields{{1.0, {0.2, 0.3}}, {{0.0, 0.4}, -0.7}, {{0.3, 0.3}, {0.1, -0.9}}};
    Coherence sum;
    for (const Jones& v : fields) sum += Coherence::outer(v);
    EXPECT_NEAR(unpolarized_fraction<double>(fields), measure(to_stokes(sum)).unpolarized, rounding);
    EXPECT_EQ(unpolarized_fraction<double>({}), 0.0);
}

// A fully polarized field E turns as Re[E exp(-i phase)]; measured through its Stokes vector, the same ellipse is run
// through in the same sense, from an end of its major axis, which is where E.E exp(-2 i phase) is real and positive.
TEST(FieldTip, RunsThroughTheEllipseOfTheJonesVectorItWasMeasuredFrom) {
    const JonesVector<double> fields[] = {{{0.8, 0.0}, {0.3, -0.4}},  {{0.2, 0.5}, {-0.6, 0.1}},
                                          {{0.6, 0.0}, {0.0, -0.5}},  {{0.6, 0.0}, {0.0, 0.5}},
                                          {{-0.3, 0.7}, {0.4, 0.45}}, {{0.1, 0.0}, {0.9, 0.2}}};
    for (const JonesVector<double>& e : fields) {
        const Stokes<double> s = to_stokes(CoherenceMatrix<double>::outer(e));
        const Measures<double> m = measure(s);
        const Complex<double> square = e.x * e.x + e.y * e.y;
        const double at_major_axis = 0.5 * std::atan2(square.im, square.re);
        const auto real_field = [&](double phase) {
            const Complex<double> turn(std::cos(phase), -std::sin(phase));
            return DVec2((e.x * turn).re, (e.y * turn).re) / std::sqrt(s.s0);
        };
        // The azimuth is that of a line: the tip may start at either end.
        const double sign =
            dot(field_tip(m.azimuth, m.ellipticity_angle, 0.0), real_field(at_major_axis)) > 0.0 ? 1.0 : -1.0;
        for (int degree = 0; degree < 360; degree += 15) {
            const DVec2 expected = real_field(at_major_axis + radians(degree));
            const DVec2 tip = sign * field_tip(m.azimuth, m.ellipticity_angle, radians(degree));
            // A few roundings of numbers up to 1; azimuth and angle are good to epsilon over the ellipse's flatness,
            // 0.1.
            EXPECT_NEAR(tip.x, expected.x, 1e-14);
            EXPECT_NEAR(tip.y, expected.y, 1e-14);
        }
    }
}

// 89 and -89 degrees are 2 degrees apart.
TEST(LineAngle, KnowsNoDirectionOfALine) {
    EXPECT_NEAR(line_angle(radians(89.0), radians(-89.0)), radians(2.0), 1e-15);
    EXPECT_NEAR(line_angle(0.0, pi / 2.0), pi / 2.0, 1e-15);
}

}  // namespace
}  // namespace pol
