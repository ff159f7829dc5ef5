// SPDX-License-Identifier: Apache-2.0
// Faces of absorbing isotropic media: Fresnel's formulas with n + i k (Born & Wolf 14.2), written with std::complex.
#include <gtest/gtest.h>

#include <array>
#include <complex>
#include <string>

#include "optics/boundary_helpers.h"
#include "polarization/coherence_matrix.h"

namespace pol::test {
namespace {

using Index = std::complex<double>;

Dielectric<double> absorbing(const Index& n) {
    return make_isotropic(n.real(), n.imag());
}

/// Textbook amplitudes of one face, E for s and H for p, with sines from Snell's law: sin = k_t/n, complex.
struct Face {
    Index r_s, r_p, t_s, t_p;
    Face(const Index& n1, const Index& n2, double k_t) {
        const Index cos1 = std::sqrt(1.0 - k_t * k_t / (n1 * n1));
        const Index cos2 = std::sqrt(1.0 - k_t * k_t / (n2 * n2));
        r_s = (n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2);
        t_s = 2.0 * n1 * cos1 / (n1 * cos1 + n2 * cos2);
        r_p = (n2 * cos1 - n1 * cos2) / (n2 * cos1 + n1 * cos2);
        t_p = 2.0 * n2 * cos1 / (n2 * cos1 + n1 * cos2);
    }
};

Index number(const Complex<double>& z) {
    return {z.re, z.im};
}

/// A wave in a medium with tangential wave vector k_t along x, as it comes from a parallel face further up.
Wave<double> inside(const Index& n, double k_t) {
    const Index q = std::sqrt(n * n - k_t * k_t);
    const DVec3 k(k_t, 0.0, q.real());
    return {WaveKind::pair, k, unit(k), {DVec3(0.0, 1.0, 0.0), cross(unit(k), DVec3(0.0, 1.0, 0.0))}};
}

// ((n - 1)^2 + k^2)/((n + 1)^2 + k^2). 64 roundings of numbers of order 1.
TEST(AbsorbingFace, ReflectsAtNormalIncidenceWithNAndKHoweverSmallOrLargeKIs) {
    for (const Index n : {Index(0.298776, 2.837424), Index(1.5, 0.5), Index(1.5, 0.1), Index(1.5, 0.01),
                          Index(1.5, 1e-7), Index(0.05, 3.8), Index(4.0, 0.03)}) {
        const double sum2 = std::norm(n + 1.0);
        EXPECT_NEAR(power(arrive(air, absorbing(n), up, up), Side::reflected, WaveKind::pair, 0),
                    std::norm(n - 1.0) / sum2, 64.0 * eps);
    }
    // The figures of tables: gold at 580 nm, and a dye.
    EXPECT_NEAR(power(arrive(air, absorbing({0.298776, 2.837424}), up, up), Side::reflected, WaveKind::pair, 1),
                0.8772715, 1e-7);
    EXPECT_NEAR(power(arrive(air, absorbing({1.5, 0.5}), up, up), Side::reflected, WaveKind::pair, 1), 0.0769231, 1e-7);
}

TEST(AbsorbingFace, IsTheFaceOfTheConductorOfTheSameIndexFromGlassAndFromCalcite) {
    Dice dice(41);
    for (int i = 0; i < 300; ++i) {
        const Index n(dice.uniform(0.05, 3.0), dice.uniform(0.0, 4.0));
        const Dielectric<double> from = i % 2 == 0 ? dice.isotropic() : dice.crystal();
        const DVec3 s = tilted(dice.uniform(0.0, 1.5));
        const auto waves = waves_of_wave_normal(from, s);
        for (int w = 0; w < waves.count; ++w) {
            const auto metal = respond(from, make_conductor(n.real(), n.imag()), up, waves.wave[w]);
            const auto liquid = respond(from, absorbing(n), up, waves.wave[w]);
            if (!metal.incident) continue;
            for (std::size_t j = 0; j < static_cast<std::size_t>(metal.incident_modes); ++j) {
                EXPECT_NEAR(side_power(liquid, Side::reflected, j), side_power(metal, Side::reflected, j), 64.0 * eps);
                EXPECT_NEAR(side_power(liquid, Side::transmitted, j) + liquid.absorption[j][j].re,
                            metal.absorption[j][j].re, 64.0 * eps);
            }
        }
    }
}

// From inside, incident and reflected wave interfere: what that takes or adds is in closed form (AbsorbingFresnel), the
// powers are not. Sums of ten numbers that reach 1/cos^2 of 58 degrees, the largest angle of q that plates can bring.
TEST(AbsorbingFace, AccountsForAllPowerFromEitherSide) {
    Dice dice(42);
    for (int i = 0; i < 500; ++i) {
        const double n = dice.uniform(1.1, 2.5);
        const Index n1(n, n * dice.uniform(0.0, 0.6));
        const Dielectric<double> to = i % 3 == 0   ? dice.crystal()
                                      : i % 3 == 1 ? dice.isotropic()
                                                   : absorbing({dice.uniform(0.3, 2.5), dice.uniform(0.0, 2.0)});
        const auto r = respond(absorbing(n1), to, up, inside(n1, dice.uniform(0.0, 0.9)));
        ASSERT_TRUE(r.incident);
        for (std::size_t j = 0; j < 2; ++j) EXPECT_NEAR(total_power(r, j), 1.0, 1000.0 * eps);
    }
}

/// Amplitude that gets straight through a plate from air to `behind`, s or p, less what propagation inside does.
Index through(const Index& n, const Dielectric<double>& behind, double k_t, std::size_t mode) {
    const Dielectric<double> plate = absorbing(n);
    const auto first = respond(air, plate, up, inside(1.0, k_t));
    const auto* in = find(first, Side::transmitted, WaveKind::pair);
    if (in == nullptr) return 0.0;
    const auto second = respond(plate, behind, up, in->wave);
    const auto* out = find(second, Side::transmitted, WaveKind::pair);
    return number(in->amplitude[mode][mode] * out->amplitude[mode][mode]);
}

// Power s: |t t'|^2 q3/q1 of the transparent outer media, p: |t t'|^2 (q3/n3^2)/q1, whatever flux means in between.
TEST(AbsorbingPlate, PassesTheExactProductOfItsFacesAndTheirPhases) {
    for (const Index n : {Index(1.5, 1e-3), Index(1.5, 0.1), Index(2.0, 0.8)}) {
        for (const double k_t : {0.0, 0.3, 0.8, 0.99}) {
            const double n3 = 1.33;
            const Face in(1.0, n, k_t);
            const Face out(n, n3, k_t);
            const double q1 = std::sqrt(1.0 - k_t * k_t);
            const double q3 = std::sqrt(n3 * n3 - k_t * k_t);
            const Index s = through(n, make_isotropic(n3), k_t, 0);
            const Index p = through(n, make_isotropic(n3), k_t, 1);
            EXPECT_NEAR(std::norm(s), std::norm(in.t_s * out.t_s) * q3 / q1, 200.0 * eps);
            EXPECT_NEAR(std::norm(p), std::norm(in.t_p * out.t_p) * q3 / (q1 * n3 * n3), 200.0 * eps);
            EXPECT_NEAR(std::arg(p * std::conj(s)), std::arg(in.t_p * out.t_p * std::conj(in.t_s * out.t_s)),
                        200.0 * eps);
        }
    }
}

TEST(AbsorbingPlate, ReflectsFromInsideWithTheAmplitudesOfComplexIndices) {
    const Index n(1.6, 0.2);
    for (const double k_t : {0.0, 0.5, 0.95}) {
        const Face face(n, 1.2, k_t);
        const auto response = respond(absorbing(n), make_isotropic(1.2), up, inside(n, k_t));
        const auto* out = find(response, Side::reflected, WaveKind::pair);
        EXPECT_NEAR(std::abs(number(out->amplitude[0][0]) - face.r_s), 0.0, 100.0 * eps);
        EXPECT_NEAR(std::abs(number(out->amplitude[1][1]) - face.r_p), 0.0, 100.0 * eps);
    }
}

// Attenuated total reflection: what a rarer liquid takes is of first order in k, 1 - |(q1 - q2)/(q1 + q2)|^2.
TEST(AbsorbingFace, TakesItsShareOfTotalReflection) {
    const Index liquid(1.33, 1e-3);
    const double k_t = 1.7 * std::sin(70.0 * degree);
    const Face face(1.7, liquid, k_t);
    const auto r = respond(make_isotropic(1.7), absorbing(liquid), up, inside(1.7, k_t));
    EXPECT_EQ(r.outgoing_count, 1);
    EXPECT_NEAR(r.absorption[0][0].re, 1.0 - std::norm(face.r_s), 16.0 * eps);
    EXPECT_NEAR(r.absorption[1][1].re, 1.0 - std::norm(face.r_p), 16.0 * eps);
    EXPECT_GT(r.absorption[0][0].re, 1e-4);
}

// A crystal of nearly equal indices is nearly the glass between them: the general solver against Fresnel's formulas.
TEST(AbsorbingFace, TowardsAndFromACrystalGoesOverIntoThatOfGlass) {
    const double step = 1e-9;
    const Index n(1.5, 0.2);
    const Dielectric<double> crystal = make_uniaxial(1.7, 1.7 + step, unit(DVec3(1.0, 2.0, 3.0)));
    const Dielectric<double> likely = make_isotropic(1.7);
    for (const double k_t : {0.1, 0.7}) {
        const auto in = respond(absorbing(n), crystal, up, inside(n, k_t));
        const auto in_glass = respond(absorbing(n), likely, up, inside(n, k_t));
        for (std::size_t j = 0; j < 2; ++j) {
            EXPECT_NEAR(side_power(in, Side::transmitted, j), side_power(in_glass, Side::transmitted, j), 10.0 * step);
            EXPECT_NEAR(side_power(in, Side::reflected, j), side_power(in_glass, Side::reflected, j), 10.0 * step);
        }
        // A single mode of the crystal, as the state of glass that it is.
        const Wave<double> o = waves_of_wave_normal(crystal, tilted(std::asin(k_t / 1.7))).wave[0];
        const auto out = respond(crystal, absorbing(n), up, o);
        const auto out_glass = respond(likely, absorbing(n), up, inside(1.7, k_t));
        const auto* wave = find(out, Side::transmitted, WaveKind::pair);
        const auto* glass_wave = find(out_glass, Side::transmitted, WaveKind::pair);
        const double s = dot(o.field[0], out_glass.incident_field[0]);
        const double p = dot(o.field[0], out_glass.incident_field[1]);
        const Index expected_s = number(glass_wave->amplitude[0][0]) * s;
        const Index expected_p = number(glass_wave->amplitude[1][1]) * p;
        EXPECT_NEAR(std::norm(number(wave->amplitude[0][0])), std::norm(expected_s), 10.0 * step);
        EXPECT_NEAR(std::norm(number(wave->amplitude[1][0])), std::norm(expected_p), 10.0 * step);
        EXPECT_NEAR(std::arg(number(wave->amplitude[1][0] * conj(wave->amplitude[0][0]))),
                    std::arg(expected_p * std::conj(expected_s)), 10.0 * step);
        EXPECT_NEAR(wave->wave.k.z, glass_wave->wave.k.z, 10.0 * step);
    }
}

// At normal incidence no direction across the ray is special, so that neither power nor handedness may depend on the
// axis from which the frame is made.
TEST(AbsorbingPlate, KeepsEveryStateAtNormalIncidence) {
    const Index n(1.5, 0.3);
    const Index s = through(n, air, 0.0, 0);
    const Index p = through(n, air, 0.0, 1);
    EXPECT_NEAR(std::abs(s - p), 0.0, 32.0 * eps);
    EXPECT_NEAR(std::norm(s), std::norm(4.0 * n / ((1.0 + n) * (1.0 + n))), 32.0 * eps);
}

}  // namespace
}  // namespace pol::test
