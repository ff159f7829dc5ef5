// SPDX-License-Identifier: Apache-2.0
// Branches side by side give the bits of the scalar kernel, on every instruction set: what `explain` tells, which
// follows one after the other, is what the picture shows.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <atomic>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "plan/lanes.h"
#include "render/render_pass.h"
#include "support/instruction_sets.h"
#include "support/render_scene.h"

namespace pol {
namespace {

struct PassResult {
    TileBuffer buffer;
    RenderStatistics statistics;
};

/// All samples of the picture in one pass.
PassResult pass(const Plan& plan, Follow follow) {
    PassResult result;
    result.buffer.rect = {0, 0, plan.settings.width, plan.settings.height};
    const std::atomic<bool> cancelled{false};
    const int samples = plan.settings.mode == SampleMode::area ? plan.settings.samples_per_pixel : 1;
    result.statistics =
        make_pass_tracer(plan, follow)->trace({0, static_cast<std::uint32_t>(samples)}, cancelled, result.buffer);
    return result;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expect_same(const PassResult& a, const PassResult& b) {
    EXPECT_TRUE(same_bits(a.buffer.stokes, b.buffer.stokes));
    EXPECT_TRUE(same_bits(a.buffer.odd_minus_even, b.buffer.odd_minus_even));
    EXPECT_TRUE(same_bits(a.buffer.residual, b.buffer.residual));
    EXPECT_TRUE(same_bits(a.buffer.tail, b.buffer.tail));
    EXPECT_EQ(a.buffer.failures, b.buffer.failures);
    EXPECT_EQ(a.statistics.nodes, b.statistics.nodes);
    EXPECT_EQ(a.statistics.most_nodes, b.statistics.most_nodes);
    EXPECT_EQ(a.statistics.failures, b.statistics.failures);
    EXPECT_EQ(a.statistics.samples, b.statistics.samples);
    EXPECT_EQ(a.statistics.worst_energy_defect, b.statistics.worst_energy_defect);
}

struct LaneScene {
    std::string name;
    Scene scene;
};

Scene scene_of(const std::string& camera, const std::string& objects, const std::string& glass) {
    Scene scene = test::scene_of("camera: {" + camera + "}\nmedia: {" + glass + "}\nobjects:\n" + objects);
    scene.render.width = 31;
    scene.render.height = 23;
    scene.render.mode = SampleMode::area;
    scene.render.samples_per_pixel = 5;
    scene.render.residual = 1e-4;
    return scene;
}

Scene scene_of(const std::string& camera, const std::string& objects, double n) {
    return scene_of(camera, objects, "glass: " + std::to_string(n));
}

std::vector<LaneScene> scenes() {
    const std::string far = "position: [0.35, -4, 3.2], target: [0, 0, -0.2], fov: 28";
    const std::string flat = "type: orthographic, position: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], width: 3";
    const std::string lamp =
        "  - {name: lamp, shape: {rectangle: {size: 3}}, transform: [{translate: [0, 0, -1.5]}], emission: {radiance: "
        "1}}\n";
    const std::string disk =
        "  - {name: disk, shape: {disk: {radius: 3}}, transform: [{translate: [0, 0, -3]}], "
        "emission: {radiance: 2, polarization: {stokes: [0.5, 0.3, 0.2], x_axis: [1, 0, 0]}}}\n";
    const std::string card =
        "  - {name: card, shape: {rectangle: {size: 4}}, transform: [{translate: [0, 0, -2]}], "
        "emission: {radiance: {texture: test-card.png}}}\n";
    const std::string backs =
        "  - {name: back, shape: {rectangle: {size: 9}}, transform: [{translate: [0, 0, 6]}], emission: {radiance: "
        "3}}\n"
        "  - {name: both, shape: {rectangle: {size: 1}}, transform: [{translate: [0, 0, 5]}], "
        "emission: {radiance: {table: [[400, 1], [600, 2]]}, two_sided: on}}\n"
        "  - {name: black, shape: {disk: {radius: 0.5}}, transform: [{translate: [0, 0.5, -1.2]}], absorber: on}\n";
    const std::string gem = "  - {name: gem, shape: {brilliant: {diameter: 2}}, medium: glass}\n";
    const std::string box = "  - {name: box, shape: {box: {size: [1, 1, 1]}}, medium: glass}\n";
    const std::string prism =
        "  - {name: prism, shape: {prism: {apex_angle: 60, side: 1, height: 1}}, medium: glass}\n";
    std::vector<LaneScene> all;
    all.push_back({"glass jewel", scene_of(far, gem + lamp, 1.5)});
    all.push_back({"diamond", scene_of(far, gem + lamp, 2.417)});
    all.push_back({"diamond with a small budget", scene_of(far, gem + lamp, 2.417)});
    all.back().scene.render.node_budget = 5;
    all.push_back({"diamond to the last", scene_of(far, gem + lamp, 2.417)});
    all.back().scene.render.residual = 1e-12;
    all.back().scene.render.node_budget = 3000;
    all.push_back({"box in grazing and normal light", scene_of(flat, box + lamp, 1.5)});
    all.push_back({"box that is not there", scene_of(far, box + lamp, 1.0)});
    all.push_back({"bubble of less index", scene_of(far, box + lamp, 0.5)});
    all.push_back({"prism in total reflection", scene_of(far, prism + lamp, 1.9)});
    all.push_back({"polarized lamp", scene_of(far, gem + disk, 1.5)});
    all.push_back({"textured lamp", scene_of(far, gem + card, 1.8)});
    all.push_back({"backs of lamps and black things", scene_of(far, gem + backs + lamp, 1.5)});
    all.back().scene.render.wavelengths_nm = {450.0, 550.0};
    all.push_back({"jewel of a glass on record", scene_of(far, gem + card, "glass: n-bk7")});
    all.back().scene.render.wavelengths_nm = {400.0, 580.0, 700.0};
    all.push_back({"smoky jewel", scene_of(far, gem + disk, "glass: {index: 1.8, absorption: 0.7}")});
    all.push_back({"dark glass", scene_of(far, box + lamp, "glass: {index: 1.5, absorption: 300}")});
    all.push_back({"glass that wavelengths of some color pass",
                   scene_of(far, prism + lamp,
                            "glass: {index: 1.9, absorption: {table: [[400, 0], [500, 0], [501, 0.8], [700, 1]]}}")});
    all.back().scene.render.wavelengths_nm = {450.0, 490.0, 550.0};
    all.push_back(
        {"smoky jewel with a small budget", scene_of(far, gem + lamp, "glass: {index: 2.417, absorption: 0.1}")});
    all.back().scene.render.node_budget = 5;
    const std::string ball = "  - {name: ball, shape: {sphere: {radius: 0.9}}, medium: glass}\n";
    all.push_back({"ball of glass", scene_of(far, ball + card + backs, 1.5)});
    all.push_back({"ball that hardly bends light", scene_of(far, ball + disk, "glass: 1.0000001")});
    all.push_back({"ball that is not there", scene_of(far, ball + lamp, 1.0)});
    all.push_back({"bubble of less index, in light along its axis", scene_of(flat, ball + disk, 0.6)});
    all.push_back({"drop of water on record", scene_of(far, ball + disk, "glass: water")});
    all.back().scene.render.wavelengths_nm = {450.0, 580.0};
    all.push_back({"ball of smoky glass", scene_of(far, ball + lamp, "glass: {index: 2.1, absorption: 0.6}")});
    all.push_back({"ball with a small budget", scene_of(far, ball + lamp, 2.417)});
    all.back().scene.render.node_budget = 4;
    all.push_back(
        {"thin air that absorbs, like vacuum else", scene_of(flat, box + lamp, "glass: {index: 1, absorption: 0.5}")});
    for (const int budget : {1000, 7}) {
        all.push_back({"until the maps are determined", scene_of(far, gem + card, 1.5)});
        all.back().scene.render.mode = SampleMode::point;
        all.back().scene.render.residual.reset();
        all.back().scene.render.node_budget = budget;
        all.back().scene.render.wavelengths_nm = {450.0, 550.0, 650.0};
    }
    return all;
}

TEST(Lanes, ThePictureHasTheBitsOfOneBranchAfterTheOtherOnEveryInstructionSet) {
    const test::EveryInstructionSet restore;
    for (const LaneScene& lane_scene : scenes()) {
        SCOPED_TRACE(lane_scene.name);
        const auto plan = test::plan_of(lane_scene.scene);
        ASSERT_EQ(why_not_in_lanes(*plan), "");
        hwy::SetSupportedTargetsForTest(0);
        const PassResult expected = pass(*plan, Follow::one_by_one);
        EXPECT_GT(expected.statistics.nodes, expected.statistics.samples);
        EXPECT_EQ(expected.statistics.failures, 0U);
        EXPECT_LE(expected.statistics.worst_energy_defect, 1e-12);
        for (const std::int64_t target : test::instruction_sets()) {
            SCOPED_TRACE(hwy::TargetName(target));
            hwy::SetSupportedTargetsForTest(target);
            expect_same(pass(*plan, Follow::side_by_side), expected);
        }
    }
}

TEST(Lanes, ASceneThatTheyDoNotKnowSaysWhy) {
    const std::string camera = "position: [0.35, -4, 3.2], target: [0, 0, -0.2], fov: 28";
    const std::string box = "  - {name: box, shape: {box: {size: [1, 1, 1]}}, medium: glass}\n";
    const std::string ball = "  - {name: ball, shape: {sphere: {radius: 1}}, medium: glass}\n";
    const std::string far_box =
        "  - {name: far, shape: {box: {size: [1, 1, 1]}}, transform: [{translate: [3, 0, 0]}], medium: glass}\n";
    const auto why = [](const Scene& scene) { return why_not_in_lanes(*test::plan_of(scene)); };
    EXPECT_EQ(why(scene_of(camera, box, 1.5)), "");
    EXPECT_EQ(why(scene_of(camera, ball, "glass: n-bk7")), "");
    EXPECT_EQ(why(scene_of(camera, ball, "glass: {conductor: [0.3, 2.8]}")), "'glass' is no glass");
    EXPECT_EQ(why(scene_of(camera, ball, "glass: {crystal: calcite}")), "the kernel is anisotropic, lossless");
    Scene misty = scene_of(camera, ball, "glass: 1.5, mist: {index: 1, absorption: 0.1}");
    misty.ambient = "mist";
    EXPECT_EQ(why(misty), "'mist' around 'ball' absorbs");
    EXPECT_EQ(why(scene_of(camera, box + far_box, 1.5)), "there is more than one solid");
    Scene limited = scene_of(camera, box, 1.5);
    limited.render.depth = 9;
    EXPECT_EQ(why(limited), "the depth is limited");
    Scene unpolarized = scene_of(camera, box, 1.5);
    unpolarized.render.unpolarized = true;
    EXPECT_EQ(why(unpolarized), "polarization is left out");
}

TEST(Lanes, ThePictureDoesNotDependOnTilesAndThreads) {
    const auto plan = test::plan_of(scenes()[1].scene);
    const StokesImage expected = test::render(plan, 1, 32);
    for (const int threads : {1, 2, 7})
        for (const int tile : {8, 32, 64}) {
            const StokesImage image = test::render(plan, threads, tile);
            EXPECT_TRUE(same_bits(image.stokes, expected.stokes)) << threads << " threads, tiles of " << tile;
        }
}

}  // namespace
}  // namespace pol
