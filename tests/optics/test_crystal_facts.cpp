// SPDX-License-Identifier: Apache-2.0
// Facts of PHYSICS.md 5 B that concern one interface. Calcite is (1.6584, 1.4864) literally.
#include <gtest/gtest.h>

#include "optics/boundary_helpers.h"

namespace pol::test {
namespace {

constexpr double printed10 = 0.5000001e-10;
constexpr double printed7 = 0.5000001e-7;

double ray_angle(const OutgoingWave<double>& out) {
    return std::atan2(std::hypot(out.wave.ray.x, out.wave.ray.y), std::abs(out.wave.ray.z)) / degree;
}

TEST(CrystalFacts, T21CCutAtNormalIncidenceIsGlassOfTheOrdinaryIndex) {
    const auto r = arrive(air, calcite(up), up, up);
    ASSERT_EQ(r.outgoing_count, 2);
    const auto twin = fresnel(1.0, 1.6584, 1.0);
    EXPECT_NEAR(power(r, Side::reflected, WaveKind::pair, 0), norm2(twin.r_s), 2.0 * eps);
    EXPECT_NEAR(power(r, Side::reflected, WaveKind::pair, 1), norm2(twin.r_p), 2.0 * eps);
    const auto* through = find(r, Side::transmitted, WaveKind::pair);
    ASSERT_NE(through, nullptr);
    EXPECT_NEAR(through->wave.k.z, 1.6584, 2.0 * eps);
}

TEST(CrystalFacts, T22ACutReflectsPolarizedLight) {
    const auto r = arrive(air, calcite({1.0, 0.0, 0.0}), up, up);
    double along = 0.0, across = 0.0;
    const auto* back = find(r, Side::reflected, WaveKind::pair);
    ASSERT_NE(back, nullptr);
    for (std::size_t j = 0; j < 2; ++j) {  // unpolarized light: both columns
        Complex<double> x, y;
        for (std::size_t i = 0; i < 2; ++i) {
            x += back->amplitude[i][j] * back->wave.field[i].x;
            y += back->amplitude[i][j] * back->wave.field[i].y;
        }
        along += norm2(x);
        across += norm2(y);
    }
    // Fresnel at normal incidence with the index that each field sees; ordinary: E across the axis.
    EXPECT_NEAR(across, std::pow(0.6584 / 2.6584, 2), 4.0 * eps);
    EXPECT_NEAR(along, std::pow(0.4864 / 2.4864, 2), 4.0 * eps);
    EXPECT_NEAR((across - along) / (across + along), 0.2316126, printed7);
}

TEST(CrystalFacts, T23WalkOff) {
    const auto r = arrive(air, calcite({std::sqrt(0.5), 0.0, std::sqrt(0.5)}), up, up);
    const auto* e = find(r, Side::transmitted, WaveKind::extraordinary);
    ASSERT_NE(e, nullptr);
    EXPECT_NEAR(ray_angle(*e), 6.2241176, printed7);
    EXPECT_LT(e->wave.ray.x, 0.0);  // away from the axis
    const auto steepest = waves_of_wave_normal(calcite(up), tilted(41.8694 * degree)).wave[1];
    EXPECT_NEAR(std::acos(dot(steepest.ray, unit(steepest.k))) / degree, 6.2611709, printed7);
}

TEST(CrystalFacts, T24SharesOfAnUnpolarizedRay) {
    const auto r = arrive(air, calcite({1.0, 0.0, 1.0}), up, up);
    const double o =
        power(r, Side::transmitted, WaveKind::ordinary, 0) + power(r, Side::transmitted, WaveKind::ordinary, 1);
    const double e = power(r, Side::transmitted, WaveKind::extraordinary, 0) +
                     power(r, Side::transmitted, WaveKind::extraordinary, 1);
    EXPECT_NEAR(o / 2.0, 0.4693303, printed7);
    EXPECT_NEAR(e / 2.0, 0.4757160, printed7);
    EXPECT_NEAR(find(r, Side::transmitted, WaveKind::extraordinary)->wave.k.z, 1.5653568, printed7);
}

TEST(CrystalFacts, T28GlanFaces) {
    // The wedge is cut at 38.5 degrees and the light falls on the gap at that angle, axis across or in the plane.
    const DVec3 s = tilted(38.5 * degree);
    const DVec3 across(0.0, 1.0, 0.0);
    EXPECT_EQ(side_power(arrive(calcite(across), air, up, s, 0), Side::transmitted, 0), 0.0);
    EXPECT_NEAR(side_power(arrive(calcite(across), air, up, s, 1), Side::transmitted, 0), 0.7416319, printed7);
    // Taylor: the axis lies in the entrance face, perpendicular to s in the plane.
    const DVec3 in_plane(std::cos(38.5 * degree), 0.0, -std::sin(38.5 * degree));
    EXPECT_NEAR(side_power(arrive(calcite(in_plane), air, up, s, 1), Side::transmitted, 0), 0.9735547, printed7);
    // o critical 37.084..., e critical 42.281: usable between
    const auto o_passes = [&](double angle) {
        return arrive(calcite(across), air, up, tilted(angle * degree), 0).outgoing_count > 1;
    };
    const auto e_passes = [&](double angle) {
        return side_power(arrive(calcite(across), air, up, tilted(angle * degree), 1), Side::transmitted, 0) > 0.0;
    };
    EXPECT_TRUE(o_passes(37.0844019));
    EXPECT_FALSE(o_passes(37.0844021));
    EXPECT_TRUE(e_passes(42.2809387));
    EXPECT_FALSE(e_passes(42.2809389));
    const auto balsam = make_isotropic(1.55);
    EXPECT_GT(side_power(arrive(calcite(across), balsam, up, tilted(69.1693 * degree), 0), Side::transmitted, 0), 0.0);
    EXPECT_EQ(side_power(arrive(calcite(across), balsam, up, tilted(69.1695 * degree), 0), Side::transmitted, 0), 0.0);
}

TEST(CrystalFacts, T30BrewsterAnglesOnCalcite) {
    // R_p = r_p^2 grows from its zero like (slope * angle error)^2, slope of order 1: 1e-9 rad of printing gives 1e-17.
    const auto r_p = [](const DVec3& axis, double angle) {
        const auto r = arrive(air, calcite(axis), up, tilted(angle * degree));
        return norm2(find(r, Side::reflected, WaveKind::pair)->amplitude[1][1]);
    };
    EXPECT_LT(r_p(up, 60.7847111), 1e-17);
    EXPECT_LT(r_p({1.0, 0.0, 0.0}, 54.0424954), 1e-17);
    EXPECT_LT(r_p({0.0, 1.0, 0.0}, 58.9104081), 1e-17);
}

TEST(CrystalFacts, T31AboveTheExtraordinarySheetAllPowerStaysOrdinary) {
    const auto crystal = calcite({1.0, 1.0, 1.0});
    const auto r = arrive(crystal, air, up, tilted(75.0 * degree), 0);
    ASSERT_EQ(r.outgoing_count, 1);
    EXPECT_NEAR(power(r, Side::reflected, WaveKind::ordinary, 0), 1.0, 16.0 * eps);
    EXPECT_EQ(arrive(crystal, air, up, tilted(68.3543896 * degree), 0).outgoing_count, 2);
    EXPECT_EQ(arrive(crystal, air, up, tilted(68.3543898 * degree), 0).outgoing_count, 1);
}

TEST(CrystalFacts, T32TotalReflectionConvertsOrdinaryToExtraordinary) {
    const auto r = arrive(calcite({1.0, 1.0, 1.0}), air, up, tilted(60.0 * degree), 0);
    EXPECT_NEAR(power(r, Side::reflected, WaveKind::ordinary, 0), 0.6648153, printed7);
    EXPECT_NEAR(power(r, Side::reflected, WaveKind::extraordinary, 0), 0.3351847, printed7);
}

TEST(CrystalFacts, T33AirToCalciteWithAnObliqueAxis) {
    const auto r = arrive(air, calcite({1.0, 2.0, 3.0}), up, tilted(40.0 * degree));
    const auto* back = find(r, Side::reflected, WaveKind::pair);
    const double expected[2][4] = {{0.0988192860, 0.0003862017, 0.0136222293, 0.8871722831},
                                   {0.0000051598, 0.0260771219, 0.9598073577, 0.0141103606}};
    for (std::size_t j = 0; j < 2; ++j) {
        EXPECT_NEAR(norm2(back->amplitude[0][j]), expected[j][0], printed10);
        EXPECT_NEAR(norm2(back->amplitude[1][j]), expected[j][1], printed10);
        EXPECT_NEAR(power(r, Side::transmitted, WaveKind::ordinary, j), expected[j][2], printed10);
        EXPECT_NEAR(power(r, Side::transmitted, WaveKind::extraordinary, j), expected[j][3], printed10);
    }
    const DVec3 ray = find(r, Side::transmitted, WaveKind::extraordinary)->wave.ray;
    EXPECT_NEAR(ray.x, 0.4125141726, printed10);
    EXPECT_NEAR(ray.y, -0.1022513741, printed10);
    EXPECT_NEAR(ray.z, 0.9051942962, printed10);
}

TEST(CrystalFacts, T34ExtraordinaryRayAngles) {
    const struct {
        DVec3 axis;
        double incidence, angle;
    } rows[] = {{up, 30.0, 21.7288873},
                {up, 60.0, 38.6539716},
                {{1.0, 0.0, 0.0}, 30.0, 15.8234678},
                {{1.0, 0.0, 0.0}, 60.0, 28.7588923}};
    for (const auto& row : rows) {
        const auto r = arrive(air, calcite(row.axis), up, tilted(row.incidence * degree));
        EXPECT_NEAR(ray_angle(*find(r, Side::transmitted, WaveKind::extraordinary)), row.angle, printed7);
        EXPECT_NEAR(ray_angle(*find(r, Side::transmitted, WaveKind::ordinary)),
                    row.incidence == 30.0 ? 17.5474435 : 31.4803007, printed7);
    }
}

TEST(CrystalFacts, T36IndexMatchedLiquidPassesTheOrdinaryWave) {
    const auto liquid = make_isotropic(1.6584);
    const auto r = arrive(liquid, calcite({0.0, 1.0, 0.0}), up, tilted(0.7));
    EXPECT_NEAR(power(r, Side::transmitted, WaveKind::ordinary, 1), 1.0, 4.0 * eps);
    const DVec3 k = find(r, Side::transmitted, WaveKind::ordinary)->wave.k;
    EXPECT_LT(std::sqrt(length2(k - 1.6584 * tilted(0.7))), 4.0 * eps);
    for (int wave = 0; wave < 2; ++wave) {  // identical crystals, axes named from either end
        const auto same = arrive(calcite({1.0, 2.0, 3.0}), calcite({-1.0, -2.0, -3.0}), up, tilted(0.7), wave);
        ASSERT_EQ(same.outgoing_count, 1);
        EXPECT_EQ(same.outgoing[0].side, Side::transmitted);
        EXPECT_EQ(same.outgoing[0].amplitude[0][0], Complex<double>(1.0));
        EXPECT_EQ(same.outgoing[0].wave.kind, wave == 0 ? WaveKind::ordinary : WaveKind::extraordinary);
    }
}

TEST(CrystalFacts, T37CrossedPlatesInContactExchangeOrdinaryAndExtraordinary) {
    const auto r = arrive(calcite({1.0, 0.0, 0.0}), calcite({0.0, 1.0, 0.0}), up, up, 0);
    const double reflected = std::pow((1.6584 - 1.4864) / (1.6584 + 1.4864), 2);  // 0.00299
    EXPECT_NEAR(side_power(r, Side::reflected, 0), reflected, 4.0 * eps);
    EXPECT_NEAR(power(r, Side::transmitted, WaveKind::extraordinary, 0), 1.0 - reflected, 4.0 * eps);
    EXPECT_LT(power(r, Side::transmitted, WaveKind::ordinary, 0), 16.0 * eps * eps);
}

TEST(CrystalFacts, T26ContactOfTwistedPlates) {
    const DVec3 turned(std::cos(30.0 * degree), std::sin(30.0 * degree), 1.0);
    const auto r = arrive(calcite({1.0, 0.0, 1.0}), calcite(turned), up, up, 0);
    EXPECT_NEAR(power(r, Side::transmitted, WaveKind::ordinary, 0), 0.7496875, printed7);
    EXPECT_NEAR(power(r, Side::transmitted, WaveKind::extraordinary, 0), 0.2501042, printed7);
}

TEST(CrystalFacts, T39EveryInterfaceConservesEnergy) {
    Dice dice(39);
    for (int i = 0; i < 3000; ++i) {
        const auto from = dice.any();
        const auto to =
            dice.uniform(0.0, 1.0) < 0.2 ? make_conductor(dice.uniform(0.05, 2.0), dice.uniform(0.5, 6.0)) : dice.any();
        const DVec3 normal = dice.direction();
        const auto waves = waves_of_wave_normal(from, dice.direction());
        for (int w = 0; w < waves.count; ++w) {
            const auto r = respond(from, to, normal, waves.wave[w]);
            EXPECT_EQ(r.incident, dot(waves.wave[w].ray, normal) > 0.0);
            if (!r.incident) continue;
            // Grazing and nearly critical waves amplify rounding; the smallest flux of 9,000 random waves is near 1e-4.
            for (std::size_t j = 0; j < static_cast<std::size_t>(r.incident_modes); ++j) {
                EXPECT_NEAR(total_power(r, j), 1.0, 1e-11);
            }
        }
    }
}

}  // namespace
}  // namespace pol::test
