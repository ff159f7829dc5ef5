// SPDX-License-Identifier: Apache-2.0
// Absorbing media in scenes: metals that are written as plain media, and slabs that let a little light through.
#include <complex>

#include "physics/fact_scene.h"

namespace pol::test {
namespace {

using Index = std::complex<double>;

/// A block of a medium under surroundings of radiance 1, the camera looking down at the angle i. Nothing comes back out
/// of a block that is a million wavelengths deep.
std::string block(const std::string& medium, double i) {
    return camera_along(downward(i)) + "background: 1\nmedia: {matter: " + medium + "}\nobjects:\n" +
           box("block", {400.0, 400.0, 200.0}, {0.0, 0.0, -100.0}, "matter");
}

/// R_s, R_p of a thick body of complex index (Born & Wolf 14.2, Snell's law with a complex sine).
Stokes<double> reflected(const Index& n, double i) {
    const Index cosine = std::sqrt(1.0 - std::pow(std::sin(i), 2) / (n * n));
    const double r_s = std::norm((std::cos(i) - n * cosine) / (std::cos(i) + n * cosine));
    const double r_p = std::norm((n * std::cos(i) - cosine) / (n * std::cos(i) + cosine));
    return {0.5 * (r_s + r_p), 0.5 * (r_s - r_p), 0.0, 0.0};
}

// One surface of some 60 operations.
constexpr double one_surface = 64.0 * eps;

TEST(AbsorbingMedium, ReflectsWithNPlusIKHoweverItIsWritten) {
    for (const double i : {0.0, 0.7, 1.3}) {
        const std::string dye = text(4.0 * pi * 0.5 / 580e-6);  // k = 0.5 at 580 nm, per mm
        expect_stokes(look(block("{index: [1.5, 0.5]}", i)), reflected({1.5, 0.5}, i), one_surface);
        expect_stokes(look(block("{index: 1.5, absorption: " + dye + "}", i)), reflected({1.5, 0.5}, i), one_surface);
        expect_stokes(look(block("{index: [0.299, 2.837]}", i)), reflected({0.299, 2.837}, i), one_surface);
        expect_stokes(look(block("{ordinary: [1.5, 0.5], extraordinary: [1.5, 0.5]}", i)), reflected({1.5, 0.5}, i),
                      one_surface);
        for (const char* gold : {"gold", "{index: gold}"})
            expect_stokes(look(block(gold, i)), look(block("{conductor: gold}", i)), one_surface);
    }
    EXPECT_NEAR(look(block("gold", 0.0)).s0, 0.8772715, 1e-7);
}

/// All passes of a slab, added as powers: T = |t t'|^2 a/(1 - |r|^4 a^2), R = |r|^2 + |t t'|^2 |r|^2 a^2/(1 - ...),
/// with |t t'| = |4 q q'/(q + q')^2| for s and the power a = exp(-2 k0 Im q d) of one pass, exact between parallel
/// faces.
struct Slab {
    double t_s, t_p, r_s, r_p;
    Slab(const Index& n, double i, double d_over_lambda) {
        const Index q = std::sqrt(n * n - std::pow(std::sin(i), 2));
        const double a = std::exp(-4.0 * pi * q.imag() * d_over_lambda);
        const auto sum = [a](const Index& r, double& passed, double& returned) {
            const double r2 = std::norm(r);
            const double both = std::norm(1.0 - r * r);  // t t' = 1 - r^2
            passed = both * a / (1.0 - r2 * r2 * a * a);
            returned = r2 + both * r2 * a * a / (1.0 - r2 * r2 * a * a);
        };
        sum((std::cos(i) - q) / (std::cos(i) + q), t_s, r_s);
        sum((n * n * std::cos(i) - q) / (n * n * std::cos(i) + q), t_p, r_p);
    }
};

// A residual of 1e-14 and a dozen passes of 60 operations each; the length of a pass is good to eps of the camera's
// distance, 10 of 0.02 mm, and the absorbance of one pass is of order 1.
constexpr double slab_tolerance = 1e-14 + 12.0 * one_surface + 10.0 / 0.02 * 4.0 * eps;

TEST(AbsorbingMedium, PassesAndReflectsAsTheExactSumOfAllPassesOfASlab) {
    for (const double k : {1e-4, 3e-3, 0.02})
        for (const double i : {0.0, 0.6, 1.2}) {
            const double d = 0.02;
            const Slab slab({1.7, k}, i, d / 580e-6);
            const std::string head = camera_along(downward(i)) +
                                     "render: {residual: 1e-15}\nmedia: {dye: {index: [1.7, " + text(k) + "]}}\n";
            const std::string body = "objects:\n" + box("slab", {40.0, 40.0, d}, {0.0, 0.0, -0.5 * d}, "dye");
            expect_stokes(look(head + body + lamp("lamp", {0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}, 100.0)),
                          {0.5 * (slab.t_s + slab.t_p), 0.5 * (slab.t_s - slab.t_p), 0.0, 0.0}, slab_tolerance);
            const Explanation above =
                explain_look(scene_of(head + body + lamp("lamp", {0.0, 0.0, 50.0}, {0.0, 0.0, -1.0}, 400.0)));
            expect_stokes(above.sample_light, {0.5 * (slab.r_s + slab.r_p), 0.5 * (slab.r_s - slab.r_p), 0.0, 0.0},
                          slab_tolerance);
            EXPECT_EQ(above.result.failures, 0U);
            EXPECT_NEAR(above.result.absorbed, 1.0 - 0.5 * (slab.t_s + slab.t_p + slab.r_s + slab.r_p), slab_tolerance);
        }
}

// Half of the light is bent into each mode, R of each is ((n - 1)^2 + k^2)/((n + 1)^2 + k^2): with k left out it is off
// by 4 n k^2/(n + 1)^4, which is what the limit for crystals is documented with.
TEST(AbsorbingCrystal, MisjudgesReflectionByAMillionthFromTheDocumentedKOn) {
    const double off = reflected({1.5, 2.6e-3}, 0.0).s0 - reflected({1.5, 0.0}, 0.0).s0;
    EXPECT_GT(off, 1e-6);
    EXPECT_LT(off, 1.1e-6);
    EXPECT_NEAR(off, 4.0 * 1.5 * std::pow(2.6e-3, 2) / std::pow(2.5, 4), 1e-10);
}

std::string refusal(const std::string& medium) {
    Scene scene = scene_of(block(medium, 0.0));
    const auto plan = compile(scene);
    return plan ? "" : to_string(plan.error());
}

TEST(AbsorbingCrystal, IsRefusedWithTheHintOfAConductorWhereRealIndicesWouldLie) {
    for (const char* medium : {"{ordinary: gold, extraordinary: 1.5}", "{ordinary: 1.5, extraordinary: [1.6, 0.01]}",
                               "{ordinary: 1.5, extraordinary: 1.6, absorption_o: 220}"}) {
        EXPECT_NE(refusal(medium).find("conductor:"), std::string::npos) << medium;
        EXPECT_NE(refusal(medium).find("media.matter"), std::string::npos) << medium;
    }
    EXPECT_EQ(refusal("{ordinary: 1.5, extraordinary: [1.6, 0.0099]}"), "");
}

}  // namespace
}  // namespace pol::test
