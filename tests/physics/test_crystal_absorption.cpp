// SPDX-License-Identifier: Apache-2.0
// Crystals that absorb: each mode by its own coefficient over its own path (physics.md 2.9).
#include "physics/crystal_scene.h"

namespace pol::test {
namespace {

// E along the axis passes, E across it is swallowed: 1 - P is exp(-200). The absorbed share is what enters as o.
TEST(Plate, OfTourmalineIsAPolarizer) {
    const std::string yaml =
        plate_scene("{ordinary: 1.640, extraordinary: 1.620, axis: [1, 0, 0], absorption_o: 200, absorption_e: 0}");
    const double t_e = plate_transmittance(1.620);
    const Stokes<double> s = look(yaml);
    expect_stokes(s, {0.5 * t_e, -0.5 * t_e, 0.0, 0.0}, all_passes);
    EXPECT_NEAR(measure(s).dop, 1.0, 4.0 * eps);
    EXPECT_NEAR(explain_look(scene_of(yaml)).result.absorbed, 0.5 * (1.0 - normal_reflectance(1.640)), all_passes);
}

// The axis is across the plane of incidence: s is e with the plain index n_e and E along the axis, p is o. Each falls
// as exp(-alpha l) over its own path l = 1/cos of its own angle of refraction.
TEST(Plate, AbsorbsEachModeOverItsOwnPath) {
    const double i = radians(50.0);
    const double alpha_o = 0.7;
    const double alpha_e = 0.2;
    const Stokes<double> s =
        look(plate_scene("{ordinary: 1.6584, extraordinary: 1.4864, axis: [0, 1, 0], "
                         "absorption_o: 0.7, absorption_e: 0.2}",
                         "{depth: 2}", i));
    const auto path = [&](double n) { return 1.0 / std::cos(std::asin(std::sin(i) / n)); };
    const double t_s = std::pow(1.0 - ClosedFresnel(n_e, i).R_s(), 2) * std::exp(-alpha_e * path(n_e));
    const double t_p = std::pow(1.0 - ClosedFresnel(n_o, i).R_p(), 2) * std::exp(-alpha_o * path(n_o));
    expect_stokes(s, {0.5 * (t_s + t_p), 0.5 * (t_s - t_p), 0.0, 0.0}, 4.0 * surface_rounding);
}

// Weak absorption makes the principal indices n + i alpha/(2 k0). To first order 1/n^2 = cos^2/n_o^2 + sin^2/n_e^2
// gives alpha along the wave normal: n^3 (alpha_o cos^2/n_o^3 + alpha_e sin^2/n_e^3), whatever way the ray takes.
TEST(Plate, AbsorbsTheExtraordinaryWaveByItsDepthAndDirection) {
    const double theta = radians(35.0);
    const Stokes<double> s = look(plate_scene(
        "{ordinary: 1.6584, extraordinary: 1.4864, axis: " + text(DVec3(std::sin(theta), 0.0, std::cos(theta))) +
        ", absorption_o: 0.7, absorption_e: 0.2}"));
    const double n = e_index(theta);
    const double alpha = std::pow(n, 3) * (0.7 * std::pow(std::cos(theta), 2) / std::pow(n_o, 3) +
                                           0.2 * std::pow(std::sin(theta), 2) / std::pow(n_e, 3));
    const auto passes = [](double index, double attenuation) {
        const double r = normal_reflectance(index);
        const double a = std::exp(-attenuation);
        return (1.0 - r) * (1.0 - r) * a / (1.0 - r * r * a * a);
    };
    EXPECT_NEAR(s.s0 - s.s1, passes(n, alpha), 2.0 * all_passes);
    EXPECT_NEAR(s.s0 + s.s1, passes(n_o, 0.7), 2.0 * all_passes);
}

}  // namespace
}  // namespace pol::test
