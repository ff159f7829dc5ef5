// SPDX-License-Identifier: Apache-2.0
// The explanation of a pixel is that pixel: same kernel, same bits.
#include <gtest/gtest.h>

#include <atomic>

#include "render/render_pass.h"
#include "support/lit_trees.h"
#include "support/shipped_scenes.h"

namespace pol {
namespace {

class ExplainedScene : public testing::TestWithParam<std::string> {};

std::string name_of(const testing::TestParamInfo<std::string>& parameter) {
    return test::test_name(parameter.param);
}

INSTANTIATE_TEST_SUITE_P(All, ExplainedScene, testing::ValuesIn(test::shipped_scene_names()), name_of);

TEST_P(ExplainedScene, LeavesAddUpToTheRenderedPixelToTheLastBit) {
    const auto plan = test::plan_of(test::small(test::shipped_scene(GetParam()), 12));
    const StokesImage image = test::render(plan, 2, 16);
    for (int y = 0; y < 12; y += 2)
        for (int x = 0; x < 12; ++x) {
            const Explanation e = explain(*plan, x, y, static_cast<std::uint32_t>(plan->settings.first_sample()), 0);
            ASSERT_TRUE(e.exact()) << x << "," << y;
            ASSERT_EQ(e.leaf_sum, image.at(0, image.pixel(x, y))) << x << "," << y;
            ASSERT_EQ(e.result.residual, image.plane_value(image.residual, 0, image.pixel(x, y)));
            ASSERT_EQ(e.result.tail, image.plane_value(image.tail, 0, image.pixel(x, y)));
        }
}

// E1, E2 and -ray are right-handed whatever a path went through, and M takes the light on a branch to its share. A
// surface costs some 60 operations, each rounded by eps/2, and the light of a branch is a sum over what grew from it.
TEST_P(ExplainedScene, EveryBranchHasARightHandedFrameOfItsLightAndOfItsMatrix) {
    const auto plan = test::plan_of(test::small(test::shipped_scene(GetParam()), 12));
    for (int y = 1; y < 12; y += 3)
        for (int x = 1; x < 12; x += 3) {
            const Explanation e = explain(*plan, x, y, 0, 0);
            for (const RayTreeNode& node : e.tree.nodes) {
                const double rounding = 60.0 * test::eps * (node.start.depth + 1.0);
                const auto& [e1, e2] = node.start.wave.field;
                ASSERT_NEAR(dot(cross(e1, e2), -node.start.wave.ray), 1.0, rounding);
                if (!node.arriving || e.result.tail > 0.0) continue;  // what a random path brings is in the share only
                const double tolerance =
                    60.0 * test::eps * static_cast<double>(e.tree.nodes.size()) * e.sample_light.s0;
                test::expect_stokes(node.start.throughput.gather(*node.arriving), node.share, tolerance);
            }
        }
}

// Sample k of a pixel in area mode, rendered as a pass of its own, against its explanation.
TEST_P(ExplainedScene, AnySampleOfAnAreaPictureIsExplainedToTheLastBit) {
    Scene scene = test::small(test::shipped_scene(GetParam()), 8);
    scene.render.mode = SampleMode::area;
    scene.render.samples_per_pixel = 64;
    const auto plan = test::plan_of(scene);
    const auto tracer = make_pass_tracer(*plan);
    const std::atomic<bool> never{false};
    for (const std::uint32_t sample : {1U, 2U, 5U, 64U}) {
        TileBuffer buffer;
        buffer.rect = {2, 3, 5, 6};
        tracer->trace({sample - 1, sample}, never, buffer);  // passes count from 0
        std::size_t i = 0;
        for (int y = 3; y < 6; ++y)
            for (int x = 2; x < 5; ++x, ++i) {
                const Explanation e = explain(*plan, x, y, sample, 0);
                ASSERT_TRUE(e.exact());
                ASSERT_EQ(e.leaf_sum, buffer.stokes[i]) << sample << ": " << x << "," << y;
            }
    }
}

// Every wavelength of a dispersive scene has a tree of its own; without dispersion all share one.
TEST(Explain, EveryWavelengthOfAPixelAddsUpToTheLastBit) {
    for (const char* index : {"n-bk7", "1.5"}) {
        Scene scene = test::scene_of(std::string(R"(
camera: {position: [1.6, -3, 2.2], target: [0, 0, -0.1], fov: 28}
render: {size: [6, 6], wavelengths: [450, 550, 650]}
media: {glass: )") + index + R"(}
objects:
  - {name: cube, shape: {box: {size: 1}}, medium: glass}
  - {name: light, shape: {rectangle: {size: 2.4}}, transform: [{translate: [0, 0, -0.6]}], emission: {radiance: {d65: 1}}}
)");
        const auto plan = test::plan_of(scene);
        const StokesImage image = test::render(plan);
        for (int w = 0; w < 3; ++w)
            for (int x = 0; x < 6; ++x) {
                const Explanation e = explain(*plan, x, 3, 0, w);
                ASSERT_TRUE(e.exact());
                ASSERT_EQ(e.leaf_sum, image.at(static_cast<std::size_t>(w), image.pixel(x, 3))) << index << " " << w;
            }
    }
}

// E1, E2 and the light's direction -ray are right-handed (CONVENTIONS.md 2), and the light in them is that of Fresnel's
// formulas, of the crystal's modes and of Jones' sheets.
TEST(Explain, TheLightOnEveryBranchHasTheStateOfTheClosedFormInARightHandedFrame) {
    test::for_each_lit_branch([](const Plan&, const Explanation& e, int branch, const test::BranchLight& expected) {
        const RayTreeNode& node = e.tree.nodes[static_cast<std::size_t>(branch)];
        const auto& [e1, e2] = node.start.wave.field;
        EXPECT_NEAR(dot(cross(e1, e2), -node.start.wave.ray), 1.0, test::lit_rounding);
        test::expect_stokes(test::seen_from(to_stokes(*node.arriving), e1, e2, expected.x), expected.light,
                            test::lit_rounding);
    });
}

// M belongs to the same frame: it takes the light on the branch to what the branch brings to the pixel.
TEST(Explain, TheMatrixOfABranchTakesItsLightToItsShare) {
    test::for_each_lit_branch([](const Plan&, const Explanation& e, int branch, const test::BranchLight&) {
        const RayTreeNode& node = e.tree.nodes[static_cast<std::size_t>(branch)];
        test::expect_stokes(node.start.throughput.gather(*node.arriving), node.share, test::lit_rounding);
    });
}

}  // namespace
}  // namespace pol
