// SPDX-License-Identifier: Apache-2.0
// render.unpolarized: what a renderer shows that knows reflectances but no polarization.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/units.h"
#include "polarization/measures.h"
#include "support/render_scene.h"
#include "support/two_mirrors.h"

namespace pol {
namespace {

/// Fresnel's reflectances at the angle, from n = 1 into n.
struct Reflectances {
    double s;
    double p;
    [[nodiscard]] double mean() const { return 0.5 * (s + p); }
};
Reflectances reflectances(double angle, double n) {
    const double c1 = std::cos(angle);
    const double c2 = std::sqrt(1.0 - std::pow(std::sin(angle) / n, 2));
    return {std::pow((c1 - n * c2) / (c1 + n * c2), 2), std::pow((n * c1 - c2) / (n * c1 + c2), 2)};
}

// A tree of a dozen steps, each of them a handful of roundings of 1.1e-16 of the pixel.
constexpr double light_rounding = 1e-14;

TEST(Unpolarized, TwoMirrorsAtBrewstersAngleReflectHalfOfWhatPolarizationMakesOfThem) {
    Scene scene = test::scene_of(test::two_mirrors);
    const double r_s = test::brewster_s_reflectance;
    EXPECT_NEAR(test::look(scene).s0, 0.5 * r_s * r_s, light_rounding);
    scene.render.unpolarized = true;
    EXPECT_NEAR(test::look(scene).s0, std::pow(0.5 * r_s, 2), light_rounding);
}

// A renderer without polarization knows nothing of a lamp but its S0.
TEST(Unpolarized, APolarizedLampIsAsBrightAndAsUnpolarizedAsAnyOther) {
    const std::string lamp =
        "camera: {position: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], fov: 10}\n"
        "objects: [{name: lamp, shape: {rectangle: {size: 4}}, emission: {radiance: 0.75, polarization: "
        "{dop: 0.8, azimuth: 20, ellipticity: 0.4, handedness: left}}}]\n";
    Scene scene = test::scene_of(lamp);
    const Stokes<double> polarized = test::look(scene);
    EXPECT_NEAR(polarized_part(polarized), 0.8 * 0.75, light_rounding);
    scene.render.unpolarized = true;
    EXPECT_EQ(test::look(scene), (Stokes<double>{polarized.s0, 0.0, 0.0, 0.0}));
}

// Born & Wolf 1.6.4 with one reflectance R for all light: 2m faces without interference pass (1 - R)/(1 + (2m - 1) R).
TEST(Unpolarized, APileOfPlatesPassesWhatTheMeanReflectanceOfAFaceLetsThrough) {
    for (const int plates : {1, 2, 3}) {
        std::string yaml =
            "camera: {type: orthographic, position: [-3, 0, 1.7320508075688772], target: [0, 0, 0], width: 1e-9}\n"
            "render: {residual: 1e-9, node_budget: 100000, unpolarized: on}\n"
            "media: {glass: 1.5}\n"
            "objects:\n"
            "  - {name: lamp, shape: {rectangle: {size: 4000}}, transform: [{translate: [0, 0, -10]}], "
            "emission: {radiance: 1}}\n";
        for (int i = 0; i < plates; ++i)
            yaml += "  - {name: plate" + std::to_string(i) +
                    ", shape: {box: {size: [3000, 3000, 0.5]}}, medium: glass, transform: [{translate: [0, 0, " +
                    std::to_string(-1 - i) + "]}]}\n";
        const double angle = radians(60.0);
        const double r = reflectances(angle, 1.5).mean();
        const Explanation seen = test::explain_look(test::scene_of(yaml));
        // The lamp's radiance is 1, so what was not traced, or by one random path, is off by at most its share.
        const double bound = seen.result.residual + seen.result.tail + light_rounding;
        EXPECT_LT(bound, 1e-3);
        EXPECT_NEAR(seen.sample_light.s0, (1.0 - r) / (1.0 + (2.0 * plates - 1.0) * r), bound) << plates;
        EXPECT_EQ(polarized_part(seen.sample_light), 0.0);
    }
}

class UnpolarizedScene : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Some, UnpolarizedScene,
                         testing::Values("paper-calcite-unpolarized", "glan-air", "pile-of-plates", "metal-spheres"));

// Light that comes in by a camera ray's tree: the leaves, and the light that is gathered step by step from them.
TEST_P(UnpolarizedScene, KeepsItsEnergyAndAddsUp) {
    Scene scene = test::shipped_scene(GetParam());
    scene.render.unpolarized = true;
    const auto plan = test::plan_of(scene);
    const int width = scene.render.width;
    const int height = scene.render.height;
    for (const auto& [x, y] :
         {std::pair{width / 2, height / 2}, {width / 3, height / 2}, {width / 2, 2 * height / 3}}) {
        const Explanation found = explain(*plan, x, y, 0, 0);
        EXPECT_TRUE(found.exact());
        EXPECT_EQ(found.result.failures, 0U);
        EXPECT_EQ(polarized_part(found.sample_light), 0.0);
        for (const RayTreeNode& node : found.tree.nodes) {
            if (!node.arriving) continue;
            EXPECT_EQ(polarized_part(to_stokes(*node.arriving)), 0.0) << "of a mode, too";
        }
        if (found.result.tail > 0.0) continue;  // what a random path brings is not gathered
        const auto& root = *found.tree.nodes.front().arriving;
        EXPECT_NEAR(root.xx + root.yy, found.sample_light.s0, 1e-12 * (1.0 + found.sample_light.s0));
    }
}

TEST(Unpolarized, AtNormalIncidenceOnGlassThereIsNothingToForget) {
    Scene scene = test::scene_of(
        "camera: {type: orthographic, position: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], width: 1e-9}\n"
        "render: {residual: 1e-12}\n"
        "media: {glass: 1.5}\n"
        "background: 1\n"
        "objects: [{name: plate, shape: {box: {size: 2}}, medium: glass}]\n");
    const Stokes<double> polarized = test::look(scene);
    scene.render.unpolarized = true;
    EXPECT_NEAR(test::look(scene).s0, polarized.s0, light_rounding);
}

}  // namespace
}  // namespace pol
