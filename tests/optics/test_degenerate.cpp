// SPDX-License-Identifier: Apache-2.0
// The cases of PHYSICS.md 4 that concern one interface and are not facts with numbers of their own.
#include <gtest/gtest.h>

#include "optics/boundary_helpers.h"
#include "optics/evanescent_modes.h"

namespace pol::test {
namespace {

/// Sum of powers that unpolarized light of two units leaves in a kind of wave.
double both(const BoundaryResponse<double>& r, Side side, WaveKind kind) {
    return power(r, side, kind, 0) + power(r, side, kind, 1);
}

TEST(Degenerate, AWaveAlongTheAxisIsOnePairWithTheOrdinaryIndex) {  // case 1
    const DVec3 axis = unit(DVec3(1.0, 2.0, 3.0));
    const auto waves = waves_of_wave_normal(calcite(axis), axis);
    ASSERT_EQ(waves.count, 1);
    EXPECT_EQ(waves.wave[0].kind, WaveKind::pair);
    EXPECT_EQ(waves.wave[0].ray, axis);
    EXPECT_NEAR(std::sqrt(length2(waves.wave[0].k)), 1.6584, 4.0 * eps);
    // Into air the pair refracts like light in glass of index n_o.
    const auto from_crystal = arrive(calcite(axis), air, up, axis);
    const auto from_glass = arrive(make_isotropic(1.6584), air, up, axis);
    for (std::size_t j = 0; j < 2; ++j) {
        EXPECT_NEAR(total_power(from_crystal, j), 1.0, 16.0 * eps);
        EXPECT_NEAR(power(from_crystal, Side::transmitted, WaveKind::pair, j),
                    power(from_glass, Side::transmitted, WaveKind::pair, j),
                    0.03);  // reflected waves differ: not equal
    }
}

TEST(Degenerate, NextToTheAxisThePairAsAWholeStaysGood) {  // case 2
    const DVec3 s = unit(DVec3(0.3, -0.2, 0.9));
    for (const double angle : {1e-12, 1e-9, 1e-6, 1e-3}) {
        const DVec3 axis = unit(s + angle * any_perpendicular(s));
        const auto waves = waves_of_wave_normal(calcite(axis), s);
        ASSERT_EQ(waves.count, 2) << angle;
        double transmitted = 0.0;
        for (int w = 0; w < 2; ++w) {
            const auto r = respond(calcite(axis), air, up, waves.wave[w]);
            EXPECT_NEAR(total_power(r, 0), 1.0, 32.0 * eps) << angle;
            transmitted += side_power(r, Side::transmitted, 0);
        }
        const auto pair = arrive(calcite(s), air, up, s);
        // The sum moves with the axis, by O(angle) of it.
        EXPECT_NEAR(transmitted, side_power(pair, Side::transmitted, 0) + side_power(pair, Side::transmitted, 1),
                    32.0 * eps + 2.0 * angle)
            << angle;
    }
}

TEST(Degenerate, TheAxisAlongTheNormalNeverMixesPolarizations) {  // case 3
    for (const double angle : {0.1, 0.7, 1.5}) {
        const auto r = arrive(air, calcite(up), up, tilted(angle));
        EXPECT_EQ(power(r, Side::transmitted, WaveKind::ordinary, 1), 0.0);
        EXPECT_EQ(power(r, Side::transmitted, WaveKind::extraordinary, 0), 0.0);
        const auto* back = find(r, Side::reflected, WaveKind::pair);
        EXPECT_EQ(back->amplitude[0][1], Complex<double>(0.0));
        EXPECT_EQ(back->amplitude[1][0], Complex<double>(0.0));
    }
}

TEST(Degenerate, TheAxisInTheFaceSplitsNoRaysAtNormalIncidence) {  // case 4
    const auto r = arrive(air, calcite({1.0, 1.0, 0.0}), up, up);
    const auto* o = find(r, Side::transmitted, WaveKind::ordinary);
    const auto* e = find(r, Side::transmitted, WaveKind::extraordinary);
    EXPECT_LT(std::sqrt(length2(o->wave.ray - e->wave.ray)), 4.0 * eps);
    EXPECT_NEAR(o->wave.k.z, 1.6584, 4.0 * eps);
    EXPECT_NEAR(e->wave.k.z, 1.4864, 4.0 * eps);
}

TEST(Degenerate, TheAxisAcrossThePlaneOfIncidenceGivesSnellForBothWaves) {  // case 5
    const double angle = 0.8;
    const auto r = arrive(air, calcite({0.0, 1.0, 0.0}), up, tilted(angle));
    const auto as_glass = [&](double n) { return arrive(air, make_isotropic(n), up, tilted(angle)); };
    EXPECT_NEAR(power(r, Side::transmitted, WaveKind::extraordinary, 0),
                power(as_glass(1.4864), Side::transmitted, WaveKind::pair, 0), 8.0 * eps);
    EXPECT_NEAR(power(r, Side::transmitted, WaveKind::ordinary, 1),
                power(as_glass(1.6584), Side::transmitted, WaveKind::pair, 1), 8.0 * eps);
    EXPECT_NEAR(std::sin(angle) / 1.4864, find(r, Side::transmitted, WaveKind::extraordinary)->wave.ray.x, 4.0 * eps);
}

TEST(Degenerate, TheAxisInThePlaneOfIncidenceDoesNotConvert) {  // case 6
    const auto r = arrive(air, calcite({1.0, 0.0, 2.0}), up, tilted(0.6));
    EXPECT_EQ(power(r, Side::transmitted, WaveKind::ordinary, 1), 0.0);
    EXPECT_EQ(power(r, Side::transmitted, WaveKind::extraordinary, 0), 0.0);
    // r_p = (eta1 - eta2)/(eta1 + eta2), eta = q/n^2 and n.eps k/(eps_o eps_e) (PHYSICS.md 2.7)
    const auto* e = find(r, Side::transmitted, WaveKind::extraordinary);
    const double eps_o = 1.6584 * 1.6584, eps_e = 1.4864 * 1.4864;
    const DVec3 c = unit(DVec3(1.0, 0.0, 2.0));
    const double eta1 = std::cos(0.6);
    const double eta2 = (eps_o * e->wave.k + (eps_e - eps_o) * dot(e->wave.k, c) * c).z / (eps_o * eps_e);
    EXPECT_NEAR(find(r, Side::reflected, WaveKind::pair)->amplitude[1][1].re, (eta1 - eta2) / (eta1 + eta2), 8.0 * eps);
}

TEST(Degenerate, NormalIncidenceDoesNotDependOnTheChoiceOfAxes) {  // cases 7, 35
    // Turning the whole problem turns the answer: unpolarized powers stay.
    const auto reference = arrive(air, calcite({1.0, 0.0, 1.0}), up, up);
    Dice dice(7);
    for (int i = 0; i < 50; ++i) {
        const DVec3 n = dice.direction();
        const DVec3 axis = n + any_perpendicular(n);
        const auto r = arrive(air, calcite(axis), n, n);
        for (const WaveKind kind : {WaveKind::ordinary, WaveKind::extraordinary}) {
            EXPECT_NEAR(both(r, Side::transmitted, kind), both(reference, Side::transmitted, kind), 16.0 * eps);
        }
        // With k just off the normal nothing jumps: sin(1e-9 .. 1e-15) moves powers by less than that.
        for (const double off : {1e-9, 1e-12, 1e-15, 1e-16}) {
            const auto near = arrive(air, calcite(axis), n, unit(n + off * any_perpendicular(n)));
            EXPECT_NEAR(both(near, Side::transmitted, WaveKind::ordinary),
                        both(r, Side::transmitted, WaveKind::ordinary), 16.0 * eps + off);
        }
    }
}

TEST(Degenerate, GrazingLightIsReflectedByCrystalsToo) {  // case 8
    for (const double off : {1e-3, 1e-6, 1e-9}) {
        const auto r = arrive(air, calcite({1.0, 2.0, 3.0}), up, DVec3(std::cos(off), 0.0, std::sin(off)));
        for (std::size_t j = 0; j < 2; ++j) {
            EXPECT_NEAR(total_power(r, j), 1.0, 16.0 * eps);
            const double through = side_power(r, Side::transmitted, j);
            EXPECT_GT(through, off);  // T ~ 4 q1/q2 and 4 eps q1/q2, q2 near 1.2
            EXPECT_LT(through, 12.0 * off);
        }
    }
    EXPECT_FALSE(arrive(air, calcite(up), up, DVec3(1.0, 0.0, 0.0)).incident);
    EXPECT_FALSE(arrive(air, calcite(up), up, DVec3(0.6, 0.0, -0.8)).incident);
}

TEST(Degenerate, AWaveNearTheAxisThatGrazesAFaceFromInsideKeepsAllItsEnergy) {  // cases 2 and 8 at once
    // Also where the mirror image, not the wave itself, comes near the axis. About a hundred roundings of powers of
    // order 1 stand between the inputs and the sum.
    constexpr double rounding = 100.0 * eps;
    Dice dice(7);
    for (int i = 0; i < 4000; ++i) {
        const double grazing = std::pow(10.0, dice.uniform(-15.5, -1.5));
        const DVec3 s(std::cos(grazing), 0.0, std::sin(grazing));
        const DVec3 centre = i % 2 == 0 ? s : DVec3(s.x, 0.0, -s.z);
        const double angle = std::pow(10.0, dice.uniform(-16.0, -1.0));
        const auto crystal = calcite(unit(centre + angle * unit(cross(centre, dice.direction()))));
        const auto waves = waves_of_wave_normal(crystal, s);
        for (const auto& behind : {air, make_isotropic(1.8), make_uniaxial(1.8, 1.9, unit(DVec3(1.0, 2.0, 3.0)))}) {
            for (int w = 0; w < waves.count; ++w) {
                const auto response = respond(crystal, behind, up, waves.wave[w]);
                if (!response.incident) continue;
                for (int j = 0; j < response.incident_modes; ++j)
                    ASSERT_NEAR(total_power(response, static_cast<std::size_t>(j)), 1.0, rounding)
                        << "wave " << w << ", " << angle << " rad from the axis, " << grazing << " rad above the face";
            }
        }
    }
}

TEST(Degenerate, AnExactlyCriticalWaveTakesNothing) {  // case 9
    // n_o = 2 is met at exactly k_t = n_o by a wave of index 2.5 at (0.8, 0, 0.6): 2.5 * 0.8 = 2.
    const Wave<double> wave{WaveKind::pair, {2.0, 0.0, 1.5}, {0.8, 0.0, 0.6}, {{0.0, 1.0, 0.0}, {-0.6, 0.0, 0.8}}};
    const auto r = respond(make_isotropic(2.5), make_uniaxial(2.0, 1.5, DVec3(1.0, 2.0, 3.0)), up, wave);
    EXPECT_EQ(find(r, Side::transmitted, WaveKind::ordinary), nullptr);
    for (std::size_t j = 0; j < 2; ++j) EXPECT_NEAR(total_power(r, j), 1.0, 16.0 * eps);
    // From inside: the axis across the plane, an e wave of index n_e = 2.5 at the same angle against 2.
    const Wave<double> e{WaveKind::extraordinary, {2.0, 0.0, 1.5}, {0.8, 0.0, 0.6}, {{0.0, 1.0, 0.0}, {}}};
    const auto inside = respond(make_uniaxial(1.7, 2.5, DVec3(0.0, 1.0, 0.0)), make_isotropic(2.0), up, e);
    EXPECT_EQ(side_power(inside, Side::transmitted, 0), 0.0);
    EXPECT_NEAR(power(inside, Side::reflected, WaveKind::extraordinary, 0), 1.0, 16.0 * eps);
}

TEST(Degenerate, PowersAreContinuousAcrossTheCriticalAngles) {  // case 10
    const auto crystal = calcite({1.0, 2.0, 3.0});
    const double critical = std::asin(1.6584 / 2.5);
    double before[2] = {-1.0, -1.0};
    for (const double off : {-1e-8, -1e-12, 1e-12, 1e-8}) {
        const auto r = arrive(make_isotropic(2.5), crystal, up, tilted(critical + off));
        for (std::size_t j = 0; j < 2; ++j) {
            const double reflected = side_power(r, Side::reflected, j);
            // T ~ sqrt(angle): at most 40 sqrt(1e-8) here
            if (before[j] >= 0.0) {
                EXPECT_NEAR(reflected, before[j], 4e-3);
            }
            before[j] = reflected;
            EXPECT_NEAR(total_power(r, j), 1.0, 1e-13);
        }
    }
}

TEST(Degenerate, BetweenTheCriticalAnglesOneWaveIsEvanescentAndTheReflectionElliptic) {  // case 11
    const auto crystal = calcite({1.0, 2.0, 3.0});
    const DVec3 s = tilted(std::asin(1.6 / 2.5));  // e sheet ends below k_t = 1.6, o at 1.6584
    const auto waves = waves_of_wave_normal(make_isotropic(2.5), s);
    const auto r = respond(make_isotropic(2.5), crystal, up, waves.wave[0]);
    const auto dark = evanescent_modes(make_isotropic(2.5), crystal, up, waves.wave[0]);
    ASSERT_EQ(dark.size(), 1U);
    EXPECT_EQ(dark[0].kind, WaveKind::extraordinary);
    EXPECT_EQ(dark[0].side, Side::transmitted);
    EXPECT_GT(dark[0].k_im.z, 0.0);
    EXPECT_NE(find(r, Side::transmitted, WaveKind::ordinary), nullptr);
    EXPECT_EQ(find(r, Side::transmitted, WaveKind::extraordinary), nullptr);
    const auto& a = find(r, Side::reflected, WaveKind::pair)->amplitude;
    EXPECT_GT(std::abs(a[0][0].im) + std::abs(a[1][1].im), 0.1);
}

TEST(Degenerate, InhibitedReflectionLeavesOneReflectedWave) {  // case 12
    const auto crystal = calcite({1.0, 1.0, 1.0});
    const Wave<double> o = waves_of_wave_normal(crystal, tilted(75.0 * degree)).wave[0];
    const auto dark = evanescent_modes(crystal, air, up, o);
    ASSERT_EQ(dark.size(), 3U);  // reflected e, transmitted s and p
    EXPECT_EQ(dark[0].side, Side::reflected);
    EXPECT_LT(dark[0].k_im.z, 0.0);
    EXPECT_EQ(respond(crystal, air, up, o).outgoing_count, 1);
}

TEST(Degenerate, EnergyDecidesWhatIsIncidentAndWhereItGoes) {  // case 13
    // A strongly oblique crystal: the ray of a wave with k.n < 0 can point to the interface.
    const auto crystal = make_uniaxial(1.5, 2.5, DVec3(1.0, 0.0, 1.0));
    int backward = 0;
    for (double angle = 60.0; angle < 120.0; angle += 1.0) {
        const Wave<double> e = waves_of_wave_normal(crystal, tilted(angle * degree)).wave[1];
        const auto r = respond(crystal, air, up, e);
        EXPECT_EQ(r.incident, e.ray.z > 0.0);
        backward += r.incident && e.k.z < 0.0;
        for (int i = 0; i < r.outgoing_count; ++i) {
            const auto& out = r.outgoing[static_cast<std::size_t>(i)];
            EXPECT_EQ(out.wave.ray.z > 0.0, out.side == Side::transmitted);
        }
    }
    EXPECT_GT(backward, 0);
}

TEST(Degenerate, EqualPrincipalIndicesAreGlassToTheBit) {  // case 14
    EXPECT_EQ(make_uniaxial(1.5, 1.5, DVec3(1.0, 2.0, 3.0)), make_isotropic(1.5));
}

TEST(Degenerate, AlmostNoBirefringenceReflectsLikeGlass) {  // case 15
    for (const double step : {1e-15, 1e-12, 1e-9, 1e-6}) {
        const auto crystal = make_uniaxial(1.5, 1.5 + step, DVec3(1.0, 2.0, 3.0));
        const auto r = arrive(air, crystal, up, tilted(0.9));
        const auto twin = arrive(air, glass, up, tilted(0.9));
        EXPECT_NEAR(both(r, Side::reflected, WaveKind::pair), both(twin, Side::reflected, WaveKind::pair),
                    16.0 * eps + step);
        for (std::size_t j = 0; j < 2; ++j) EXPECT_NEAR(total_power(r, j), 1.0, 16.0 * eps);
    }
}

TEST(Degenerate, HugeBirefringenceWalksOffBySeventyOneDegrees) {  // case 16
    const auto crystal = make_uniaxial(1.0, 6.0, up);
    const Wave<double> e = waves_of_wave_normal(crystal, tilted(std::atan(6.0))).wave[1];
    EXPECT_NEAR(std::tan(std::acos(dot(e.ray, unit(e.k)))), 35.0 / 12.0, 64.0 * eps);
}

TEST(Degenerate, AMetalLetsNothingThrough) {  // case 30
    for (const auto& from : {air, calcite({1.0, 2.0, 3.0})}) {
        const auto waves = waves_of_wave_normal(from, tilted(0.5));
        for (int w = 0; w < waves.count; ++w) {
            const auto r = respond(from, make_conductor(0.2, 3.4), up, waves.wave[w]);
            EXPECT_TRUE(r.absorbs);
            EXPECT_EQ(side_power(r, Side::transmitted, 0), 0.0);
            EXPECT_GT(r.absorption[0][0].re, 0.01);
            EXPECT_NEAR(total_power(r, 0), 1.0, 16.0 * eps);
        }
    }
}

TEST(Degenerate, AbsorptionOfASuperpositionFollowsTheHermitianForm) {  // crystal pair on metal
    const DVec3 axis = tilted(0.5);
    const auto r = arrive(calcite(axis + DVec3(0.0, 0.0, 0.0)), make_conductor(0.2, 3.4), up, unit(axis));
    ASSERT_EQ(r.incident_modes, 2);
    const Complex<double> in[2] = {Complex<double>(0.6), Complex<double>(0.48, 0.64)};
    Complex<double> absorbed;
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) absorbed += conj(in[i]) * r.absorption[i][j] * in[j];
    }
    double reflected = 0.0;
    for (std::size_t o = 0; o < static_cast<std::size_t>(r.outgoing_count); ++o) {
        for (const auto& row : r.outgoing[o].amplitude) reflected += norm2(row[0] * in[0] + row[1] * in[1]);
    }
    EXPECT_NEAR(absorbed.re + reflected, 1.0, 16.0 * eps);
    EXPECT_NEAR(absorbed.im, 0.0, 4.0 * eps);
}

}  // namespace
}  // namespace pol::test
