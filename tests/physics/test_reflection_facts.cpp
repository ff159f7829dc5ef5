// SPDX-License-Identifier: Apache-2.0
// One glass surface beyond facts T1, T3, T11 and T19: every angle, both sides, and either side of a special angle.
#include "physics/fact_scene.h"

namespace pol::test {
namespace {

// One surface is some 20 operations on numbers of order 1, each rounded by eps/2, and the angle itself (a direction
// normalised by the camera) is good to a few eps with a slope of order n.
constexpr double one_reflection = 32.0 * eps;

/// A lamp seen by reflection in a deep block of the medium, at the angle of incidence `i`.
std::string mirror_scene(const std::string& medium, double i, const std::string& emission = "radiance: 1") {
    // The lamp is farther than the camera, which it would otherwise hide at normal incidence, and small enough to stay
    // above the block at grazing incidence.
    return camera_along(downward(i)) + "media: {stuff: " + medium + "}\nobjects:\n" + deep_block("stuff") +
           lamp("lamp", upward(i) * 10.0, -upward(i), std::cos(i), emission);
}

/// Unpolarized light of radiance 1 reflected with R_s, R_p.
Stokes<double> reflected(double r_s, double r_p) {
    return {0.5 * (r_s + r_p), 0.5 * (r_s - r_p), 0.0, 0.0};
}

const double brewster = std::atan(1.5);

TEST(Reflection, T1TurnsFromOneSideToTheOtherOfPAtBrewstersAngle) {
    // r_p changes its sign: +45 degrees goes to -45 below the angle (as at normal incidence), to +45 above it.
    EXPECT_LT(look(mirror_scene("1.5", brewster - 1e-6, polarized("[0, 1, 0]"))).s2, 0.0);
    EXPECT_GT(look(mirror_scene("1.5", brewster + 1e-6, polarized("[0, 1, 0]"))).s2, 0.0);
}

// Close to grazing, 1 - R_s = 4 c/sqrt(n^2 - 1) and 1 - R_p = n^2 times that, to first order in c = cos i.
TEST(Reflection, T3AtGrazingIncidenceBecomesTotalAndUnpolarized) {
    for (const double grazing : {1e-2, 1e-4, 1e-6}) {
        SCOPED_TRACE(grazing);
        const Stokes<double> s = look(mirror_scene("1.5", 0.5 * pi - grazing));
        const double lost_s = 4.0 * grazing / std::sqrt(1.25);
        // The next orders are -8 (grazing/1.118)^2 and -8 (2.25 grazing/1.118)^2 and smaller still.
        EXPECT_NEAR(1.0 - (s.s0 + s.s1), lost_s, 10.0 * grazing * grazing + one_reflection);
        EXPECT_NEAR(1.0 - (s.s0 - s.s1), 2.25 * lost_s, 40.0 * grazing * grazing + one_reflection);
        EXPECT_GT(s.s1, 0.0);
    }
}

TEST(Reflection, FollowsFresnelAtEveryAngle) {
    for (int degree = 1; degree < 90; degree += 4) {
        SCOPED_TRACE(degree);
        const double i = radians(degree);
        const ClosedFresnel f(1.5, i);
        expect_stokes(look(mirror_scene("1.5", i)), reflected(f.R_s(), f.R_p()), one_reflection);
        expect_stokes(look(mirror_scene("1.5", i, polarized("[0, 1, 0]"))), f.of_diagonal_light(), one_reflection);
    }
}

/// Light of a lamp inside the glass, seen from outside through one surface at the angle `i` outside.
std::string refraction_scene(double n, double i, const std::string& emission = "radiance: 1") {
    const double t = std::asin(std::sin(i) / n);
    return camera_along(downward(i)) + "media: {stuff: " + text(n) + "}\nobjects:\n" +
           box("block", {40.0, 40.0, 4.0}, {0.0, 0.0, -2.0}, "stuff") +
           lamp("lamp", downward(t), -downward(t), 0.5, emission);
}

/// The lamp outside, seen from inside the glass by refraction or reflection; `i` is the angle outside.
std::string inside_scene(double n, double i, bool reflection, const std::string& emission) {
    const double t = std::asin(std::sin(i) / n);
    const DVec3 inside(std::sin(t), 0.0, std::cos(t));
    const std::string lamp_text = reflection ? lamp("lamp", downward(t) * 1.5, -downward(t), 0.2, emission)
                                             : lamp("lamp", upward(i) * 5.0, -upward(i), 0.5 * std::cos(i), emission);
    return camera_along(inside, 1.0) + "media: {stuff: " + text(n) + "}\nobjects:\n" + deep_block("stuff") + lamp_text;
}

// Light passes a surface both ways with the same T, and is reflected with the same R; radiance is divided by n^2 on the
// way out and multiplied by it on the way in.
TEST(ReversedRay, T19FindsTheSameTransmittanceAndReflectanceFromBothSides) {
    const double n = 1.5;
    for (const double degree : {0.0, 20.0, 45.0, 56.0, 80.0}) {
        SCOPED_TRACE(degree);
        const double i = radians(degree);
        for (const std::string state : {"[1, 0, 0]", "[-1, 0, 0]", "[0, 1, 0]"}) {
            SCOPED_TRACE(state);
            const Stokes<double> out = look(refraction_scene(n, i, polarized(state)));
            const Stokes<double> in = look(inside_scene(n, i, false, polarized(state)));
            expect_stokes(n * n * n * n * out, in, n * n * one_reflection);
            const Stokes<double> above = look(mirror_scene(text(n), i, polarized(state)));
            const Stokes<double> below = look(inside_scene(n, i, true, polarized(state)));
            expect_stokes(above, below, one_reflection);
            // R + T = 1, whatever the state.
            EXPECT_NEAR(n * n * out.s0 + above.s0, 1.0, n * n * one_reflection);
        }
    }
}

/// Amplitude of s through the first surface, from the branch that left it on the given side. The sign of s on the way
/// is the same before and behind the surface, and the camera's x is s up to that sign.
double s_amplitude(const std::string& yaml, Interaction side) {
    const Explanation e = explain_look(scene_of(yaml));
    for (const RayTreeNode& node : e.tree.nodes)
        if (node.parent == 0 && node.interaction == side)
            return node.start.throughput.m[0][0].re * dot(node.start.wave.field[0], DVec3(0.0, -1.0, 0.0));
    throw std::runtime_error("no such branch");
}

// Stokes' relations for flux-normalised amplitudes: t is the same both ways, t t_rev = 1 - r^2.
TEST(ReversedRay, T19HasTheOppositeReflectedAmplitudeAndObeysStokesRelations) {
    for (const double degree : {20.0, 45.0, 70.0}) {
        const std::string outside = refraction_scene(1.5, radians(degree));
        const std::string inside = inside_scene(1.5, radians(degree), false, "radiance: 1");
        const double r = s_amplitude(outside, Interaction::reflected);
        const double r_rev = s_amplitude(inside, Interaction::reflected);
        const double t = s_amplitude(outside, Interaction::transmitted);
        const double t_rev = s_amplitude(inside, Interaction::transmitted);
        EXPECT_NEAR(r, ClosedFresnel(1.5, radians(degree)).r_s.re, one_reflection);
        EXPECT_NEAR(r_rev, -r, one_reflection);
        EXPECT_NEAR(t * t_rev, 1.0 - r * r, one_reflection);
    }
}

/// A lamp inside a medium seen from inside it by reflection in its surface at the angle `i`; the camera's x is s.
std::string inner_mirror_scene(double n, double i, const std::string& emission) {
    return camera_along(upward(i), 1.0) + "media: {stuff: " + text(n) + "}\nobjects:\n" +
           box("block", {40.0, 40.0, 4.0}, {0.0, 0.0, -2.0}, "stuff") +
           lamp("lamp", downward(i), -downward(i), 0.2, emission);
}

TEST(TotalReflection, T11DelaysMostAtTheAngleOfItsClosedForm) {
    // tan(|Delta|/2) = (1 - m^2)/(2 m) at sin^2 i = 2 m^2/(1 + m^2), m = 1/1.51.
    const double m2 = 1.0 / (1.51 * 1.51);
    const double best = std::asin(std::sqrt(2.0 * m2 / (1.0 + m2)));
    const double largest = 2.0 * std::atan((1.0 - m2) / (2.0 * std::sqrt(m2)));
    EXPECT_NEAR(degrees(best), 51.339100, printed(6));
    EXPECT_NEAR(degrees(largest), 45.941667, printed(6));
    const auto delay = [](double i) {
        const Stokes<double> s = look(inner_mirror_scene(1.51, i, polarized("[0, 1, 0]")));
        return std::atan2(s.s3, s.s2);
    };
    EXPECT_NEAR(delay(best), largest, one_reflection);
    EXPECT_LT(delay(best - 0.01), largest - 1e-5);
    EXPECT_LT(delay(best + 0.01), largest - 1e-5);
}

}  // namespace
}  // namespace pol::test
