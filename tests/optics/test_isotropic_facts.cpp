// SPDX-License-Identifier: Apache-2.0
// Facts of PHYSICS.md 5 A that concern one interface between isotropic media, and Fresnel's corner cases.
#include <gtest/gtest.h>

#include "optics/boundary_helpers.h"
#include "polarization/coherence_matrix.h"

namespace pol::test {
namespace {

constexpr double printed = 0.5000001e-10;  // expected values below are printed with ten decimals

/// Stokes vector (frame s, p) of the pair that leaves on `side` for a Jones vector coming in.
Stokes<double> leaving(const BoundaryResponse<double>& r, Side side, const JonesVector<double>& in) {
    const auto& a = find(r, side, WaveKind::pair)->amplitude;
    return to_stokes(
        CoherenceMatrix<double>::outer({a[0][0] * in.x + a[0][1] * in.y, a[1][0] * in.x + a[1][1] * in.y}));
}

double ellipticity(const Stokes<double>& s) {
    const double linear = std::hypot(s.s1, s.s2);
    return std::abs(s.s3) / (std::hypot(linear, s.s3) + linear);
}

const JonesVector<double> diagonal{std::sqrt(0.5), std::sqrt(0.5)};

TEST(IsotropicFacts, T1BrewsterReflectsOnlyS) {
    const auto r = arrive(air, glass, up, tilted(std::atan(1.5)));
    // R_p is the square of an amplitude that cancels to a few eps.
    EXPECT_LT(power(r, Side::reflected, WaveKind::pair, 1), 16.0 * eps * eps);
    EXPECT_NEAR(power(r, Side::reflected, WaveKind::pair, 0), 0.1479289941, printed);
}

TEST(IsotropicFacts, T2LightRefractedAtBrewsterIsPartiallyPolarized) {
    const auto r = arrive(air, glass, up, tilted(std::atan(1.5)));
    const double t_s = power(r, Side::transmitted, WaveKind::pair, 0);
    const double t_p = power(r, Side::transmitted, WaveKind::pair, 1);
    EXPECT_NEAR((t_p - t_s) / (t_p + t_s), 0.0798722045, printed);
}

TEST(IsotropicFacts, T3ReflectionAtNormalDiagonalAndGrazingIncidence) {
    const auto normal = arrive(air, glass, up, up);
    EXPECT_NEAR(power(normal, Side::reflected, WaveKind::pair, 0), 0.04, 2.0 * eps);
    EXPECT_EQ(power(normal, Side::reflected, WaveKind::pair, 0), power(normal, Side::reflected, WaveKind::pair, 1));

    const auto diagonal_ray = arrive(air, glass, up, tilted(45.0 * degree));
    const double r_s = power(diagonal_ray, Side::reflected, WaveKind::pair, 0);
    const double r_p = power(diagonal_ray, Side::reflected, WaveKind::pair, 1);
    EXPECT_NEAR(r_s, 0.0920133630, printed);
    EXPECT_NEAR(r_p, r_s * r_s, 4.0 * eps);
    EXPECT_NEAR((r_s - r_p) / (r_s + r_p), 0.8314794193, printed);

    const auto grazing = arrive(air, glass, up, tilted(90.0 * degree - 1e-9));
    // 1 - R = 4 q1/q2 (s), 4 n^2 q1/q2 (p), with q1 = 1e-9, q2 = sqrt(1.25).
    EXPECT_NEAR(power(grazing, Side::transmitted, WaveKind::pair, 0), 4e-9 / std::sqrt(1.25), 1e-15);
    EXPECT_NEAR(power(grazing, Side::transmitted, WaveKind::pair, 1), 9e-9 / std::sqrt(1.25), 2e-15);
}

TEST(IsotropicFacts, T9TotalReflectionTurnsDiagonalLightRightHandedElliptic) {
    for (const auto& [angle, expected] : {std::pair{45.0, 1.0 / 3.0}, std::pair{60.0, std::sqrt(11.0) / 9.0}}) {
        const auto r = arrive(glass, air, up, tilted(angle * degree));
        EXPECT_EQ(r.outgoing_count, 1);
        const Stokes<double> s = leaving(r, Side::reflected, diagonal);
        EXPECT_NEAR(s.s0, 1.0, 8.0 * eps);
        EXPECT_GT(s.s3, 0.0);
        EXPECT_NEAR(ellipticity(s), expected, 16.0 * eps);
    }
    EXPECT_NEAR(std::asin(1.0 / 1.5) / degree, 41.810315, 5e-7);
    EXPECT_EQ(arrive(glass, air, up, tilted(41.8104 * degree)).outgoing_count, 1);
    EXPECT_EQ(arrive(glass, air, up, tilted(41.8103 * degree)).outgoing_count, 2);
}

TEST(IsotropicFacts, T16DiamondIndex) {
    const auto diamond = make_isotropic(2.4172592);
    EXPECT_NEAR(power(arrive(air, diamond, up, up), Side::reflected, WaveKind::pair, 0), 0.172006, 5e-7);
    EXPECT_LT(power(arrive(air, diamond, up, tilted(67.5255 * degree)), Side::reflected, WaveKind::pair, 1), 1e-12);
    EXPECT_EQ(arrive(diamond, air, up, tilted(24.4371 * degree)).outgoing_count, 1);
    EXPECT_EQ(arrive(diamond, air, up, tilted(24.4369 * degree)).outgoing_count, 2);
}

TEST(IsotropicFacts, T17MetalsAt580nm) {
    struct Metal {
        double n, k, r_normal, p_45, e_45, principal_angle;
    };
    const Metal metals[] = {{0.299, 2.837, 0.877272, 0.0449203, 0.2393842, 72.4015},
                            {0.051, 3.841, 0.987229, 0.0044692, 0.1810244, 76.2266},
                            {1.158, 6.965, 0.912862, 0.0320678, 0.0983249, 82.0871}};
    for (const Metal& metal : metals) {
        const auto m = make_conductor(metal.n, metal.k);
        // n and k are rounded to the third decimal in the table; its figures come from the unrounded interpolation.
        EXPECT_NEAR(power(arrive(air, m, up, up), Side::reflected, WaveKind::pair, 0), metal.r_normal, 2e-3);
        const auto r = arrive(air, m, up, tilted(45.0 * degree));
        const double r_s = power(r, Side::reflected, WaveKind::pair, 0);
        const double r_p = power(r, Side::reflected, WaveKind::pair, 1);
        EXPECT_NEAR(r_p, r_s * r_s, 4.0 * eps);
        EXPECT_NEAR((r_s - r_p) / (r_s + r_p), metal.p_45, 6e-4);
        const Stokes<double> s = leaving(r, Side::reflected, diagonal);
        EXPECT_GT(s.s3, 0.0);
        EXPECT_NEAR(ellipticity(s), metal.e_45, 2e-4);
        // At the principal angle the phases of p and s differ by a quarter: r_p conj(r_s) is imaginary.
        const auto principal = arrive(air, m, up, tilted(metal.principal_angle * degree));
        const auto& a = find(principal, Side::reflected, WaveKind::pair)->amplitude;
        const Complex<double> product = a[1][1] * conj(a[0][0]);
        EXPECT_NEAR(product.re, 0.0, 2e-3);
        EXPECT_GT(std::abs(product.im), 0.7);
    }
}

TEST(IsotropicFacts, ConductorAbsorbsWhatItDoesNotReflect) {
    Dice dice(11);
    for (int i = 0; i < 500; ++i) {
        const auto metal = make_conductor(dice.uniform(0.02, 3.0), dice.uniform(0.0, 8.0));
        const auto r = arrive(dice.isotropic(), metal, up, tilted(dice.uniform(0.0, 89.9) * degree));
        ASSERT_TRUE(r.absorbs);
        for (std::size_t j = 0; j < 2; ++j) EXPECT_NEAR(total_power(r, j), 1.0, 16.0 * eps);
    }
}

TEST(IsotropicFacts, T18ReflectionAtNormalIncidenceFlipsHandedness) {
    const JonesVector<double> right{std::sqrt(0.5), {0.0, -std::sqrt(0.5)}};
    for (const auto& mirror : {glass, make_conductor(0.05, 3.8)}) {
        const Stokes<double> s = leaving(arrive(air, mirror, up, up), Side::reflected, right);
        EXPECT_NEAR(s.s3, -s.s0, 4.0 * eps);
    }
}

TEST(IsotropicFacts, T19ReversedRayHasTheSamePowersAndOppositeR) {
    const double sine = 0.6;
    const auto in = fresnel(1.0, 1.5, std::sqrt(1.0 - sine * sine));
    const auto out = fresnel(1.5, 1.0, std::sqrt(2.25 - sine * sine));
    EXPECT_NEAR(in.r_s.re, -out.r_s.re, 4.0 * eps);
    EXPECT_NEAR(in.r_p.re, -out.r_p.re, 4.0 * eps);
    EXPECT_NEAR(in.t_s, out.t_s, 4.0 * eps);
    EXPECT_NEAR(in.t_p, out.t_p, 4.0 * eps);
    EXPECT_NEAR(in.t_s * out.t_s, 1.0 - norm2(in.r_s), 4.0 * eps);
    EXPECT_NEAR(in.t_p * out.t_p, 1.0 - norm2(in.r_p), 4.0 * eps);
}

TEST(IsotropicFacts, T20RadianceOfAnEmitterInsideGlass) {
    EXPECT_NEAR(power(arrive(glass, air, up, up), Side::transmitted, WaveKind::pair, 0) / 2.25, 0.4266667, 5e-8);
}

TEST(IsotropicFacts, EqualIndicesReflectExactlyNothing) {
    for (const double angle : {0.0, 0.3, 1.2, 1.57}) {
        const auto f = fresnel(1.7, 1.7, 1.7 * std::cos(angle));
        EXPECT_EQ(f.r_s, Complex<double>(0.0));
        EXPECT_EQ(f.r_p, Complex<double>(0.0));
        EXPECT_NEAR(f.t_s, 1.0, 2.0 * eps);
        EXPECT_NEAR(f.t_p, 1.0, 4.0 * eps);
        const auto r = arrive(glass, glass, up, tilted(angle));
        ASSERT_EQ(r.outgoing_count, 1);
        EXPECT_EQ(r.outgoing[0].side, Side::transmitted);
        EXPECT_EQ(r.outgoing[0].wave.k, 1.5 * tilted(angle));
    }
}

TEST(IsotropicFacts, AnIndexStepOf1e12KeepsTheRelativeAccuracyOfR) {
    for (const double sign : {-1.0, 1.0}) {
        const double n2 = 1.5 + sign * 1e-12;
        const double step = n2 - 1.5;  // exact (Sterbenz)
        const auto f = fresnel(1.5, n2, 1.5 * std::cos(0.5));
        // r_s = -dn n/(2 q^2) to first order in the step, which is all of it at this size.
        const double expected = -step / (3.0 * std::cos(0.5) * std::cos(0.5));
        EXPECT_FALSE(f.total);
        EXPECT_NEAR(f.r_s.re / expected, 1.0, 1e-11);
    }
}

TEST(IsotropicFacts, AnExactlyCriticalWaveIsReflectedCompletely) {
    // 1.25^2 - 1^2 = 0.75^2: q1 = 0.75 is exactly critical.
    const auto f = fresnel(1.25, 1.0, 0.75);
    EXPECT_TRUE(f.total);
    EXPECT_EQ(f.q2, 0.0);
    EXPECT_EQ(f.r_s, Complex<double>(1.0));
    EXPECT_EQ(f.r_p, Complex<double>(1.0));
    EXPECT_EQ(f.t_s, 0.0);
    EXPECT_EQ(f.t_p, 0.0);
}

TEST(IsotropicFacts, FresnelAgreesWithTheTextbookForms) {
    Dice dice(5);
    for (int i = 0; i < 1000; ++i) {
        const double n1 = dice.uniform(1.0, 2.5);
        const double n2 = dice.uniform(1.0, 2.5);
        const double q1 = n1 * std::cos(dice.uniform(0.0, 1.5));
        const double q2_squared = n2 * n2 - n1 * n1 + q1 * q1;
        if (q2_squared < 1e-3) continue;  // the textbook form of q2 loses digits below
        const double q2 = std::sqrt(q2_squared);
        const auto f = fresnel(n1, n2, q1);
        EXPECT_NEAR(f.r_s.re, (q1 - q2) / (q1 + q2), 1e-13);
        EXPECT_NEAR(f.r_p.re, (n2 * n2 * q1 - n1 * n1 * q2) / (n2 * n2 * q1 + n1 * n1 * q2), 1e-13);
        EXPECT_NEAR(f.t_s * f.t_s, 4.0 * q1 * q2 / ((q1 + q2) * (q1 + q2)), 1e-13);
        EXPECT_NEAR(f.t_p * f.t_p + norm2(f.r_p), 1.0, 8.0 * eps);
    }
}

}  // namespace
}  // namespace pol::test
