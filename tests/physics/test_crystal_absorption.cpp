// SPDX-License-Identifier: Apache-2.0
// Crystals that absorb: each mode by its own coefficient over its own path (PHYSICS.md 2.9).
#include "physics/crystal_scene.h"

namespace pol::test {
namespace {

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
