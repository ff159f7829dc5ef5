// SPDX-License-Identifier: Apache-2.0
// Where no residual is asked for, a point picture's trees are followed until its maps are determined (CUTTING.md 2.1).
#include <gtest/gtest.h>

#include <cmath>

#include "maps/error_bars.h"
#include "maps/evaluate.h"
#include "polarization/bounds.h"
#include "polarization/measures.h"
#include "support/render_scene.h"
#include "tracer/determined.h"
#include "tracer/sample_task.h"
#include "tracer/trace_sample.h"

namespace pol {
namespace {

Scene small_scene(const char* name) {
    Scene scene = test::shipped_scene(name);
    scene.render.width = scene.render.height = 48;
    scene.render.residual.reset();
    scene.render.node_budget.reset();
    return scene;
}

struct Sample {
    Stokes<double> light{};
    TraceResult result{};
};

Sample traced(const Plan& plan, const TraceTask& task) {
    Sample sample;
    sample.result = trace_sample(plan, task, {&sample.light, 1});
    return sample;
}

/// Calls look(sample at the default, its task) for the centre of every pixel.
template <class Look>
void for_each_pixel(const Plan& plan, const Look& look) {
    for (int y = 0; y < plan.settings.height; ++y)
        for (int x = 0; x < plan.settings.width; ++x) {
            SCOPED_TRACE(testing::Message() << x << "," << y);
            const TraceTask task = sample_task(plan, x, y, 0, 0);
            look(traced(plan, task), task);
        }
}

// The truth lies in a bar that is as narrow as is_determined promises, so it is at most so far away. What is left open
// of the whole tree, 1e-15 of the brightest light, and rounding are far below the slack.
TEST(Determined, GlassHasThePolarizationOfItsWholeTree) {
    constexpr double slack = 1e-6;
    for (const char* name : {"paper-glass-unpolarized", "paper-glass-polarized", "water-drop"}) {
        SCOPED_TRACE(name);
        const auto plan = test::plan_of(small_scene(name));
        const double brightest = plan->brightest[0];
        int determined = 0;
        int lit = 0;
        for_each_pixel(*plan, [&](const Sample& sample, TraceTask task) {
            task.until_determined = false;
            task.residual = 1e-15;
            task.node_budget = 1 << 20;
            const Sample whole = traced(*plan, task);
            if (whole.light.s0 < 1e-3 * brightest) return;
            ++lit;
            if (!is_determined(sample.light, sample.result.residual * brightest)) return;
            ++determined;
            const Measures<double> found = measure(sample.light, 1e-12);
            const Measures<double> truth = measure(whole.light, 1e-12);
            EXPECT_NEAR(found.dop, truth.dop, determined_width + slack);
            const bool has_ellipticity = truth.dop > weak_polarization;
            EXPECT_NEAR(found.ellipticity, truth.ellipticity, has_ellipticity ? determined_width + slack : 1.0);
        });
        EXPECT_GT(lit, 100);
        EXPECT_EQ(determined, lit) << "whatever is not dark is determined";
    }
}

TEST(Determined, NoMapOfGlassOrOfADropHatchesAPixel) {
    for (const char* name : {"paper-glass-unpolarized", "paper-glass-polarized", "water-drop", "cube-glass",
                             "fresnel-rhomb", "wollaston"}) {
        const StokesImage image = test::render(small_scene(name));
        for (const Quantity quantity : {Quantity::dop, Quantity::ellipticity}) {
            const Map map = evaluate(image, quantity, 0).value();
            for (const MapPixel& pixel : map.pixels) ASSERT_NE(pixel.state, PixelState::undetermined) << name;
        }
    }
}

// A tree at 1e-3 is the beginning of the one that goes on: light is only added, and less stays open.
TEST(Determined, FollowingOnOnlyAddsLight) {
    for (const char* name : {"paper-glass-polarized", "wollaston", "paper-calcite-unpolarized"}) {
        SCOPED_TRACE(name);
        const auto plan = test::plan_of(small_scene(name));
        const double brightest = plan->brightest[0];
        for_each_pixel(*plan, [&](const Sample& sample, TraceTask task) {
            task.until_determined = false;
            const Sample cut = traced(*plan, task);
            EXPECT_LE(sample.result.residual, cut.result.residual + energy_tolerance);
            EXPECT_EQ(sample.result.tail, cut.result.tail) << "what is open below 1e-3 is never estimated";
            if (cut.result.tail > 0.0) return;
            EXPECT_GE(sample.light.s0, cut.light.s0);
            EXPECT_LE(sample.light.s0, cut.light.s0 + cut.result.residual * brightest * (1.0 + 1e-12));
            EXPECT_LE(sample.result.residual, 1e-3);
            const bool is_dark = sample.light.s0 + sample.result.residual * brightest <= dark_part * brightest;
            const auto budget = static_cast<std::uint32_t>(task.node_budget);
            // The last branch may end in as many leaves as a surface has children.
            EXPECT_LE(sample.result.nodes, budget + 4);
            EXPECT_TRUE(is_determined(sample.light, sample.result.residual * brightest) ||
                        (is_dark && sample.result.nodes >= dark_budget) || sample.result.nodes >= budget ||
                        sample.result.residual <= least_open_weight);
        });
    }
}

TEST(Determined, AResidualThatIsGivenIsAllThatCounts) {
    Scene scene = small_scene("paper-glass-unpolarized");
    scene.render.residual = RenderSettings::usual_residual;
    const auto given = test::plan_of(scene);
    int shorter = 0;
    for_each_pixel(*given, [&](const Sample& sample, TraceTask task) {
        EXPECT_FALSE(task.until_determined);
        EXPECT_LE(sample.result.residual, RenderSettings::usual_residual);
        task.until_determined = true;
        if (sample.result.nodes < traced(*given, task).result.nodes) ++shorter;
    });
    EXPECT_GT(shorter, 100);
    scene.render.residual.reset();
    EXPECT_TRUE(scene.render.until_determined());
    scene.render.mode = SampleMode::area;
    EXPECT_FALSE(scene.render.until_determined()) << "the mean of many samples needs none of them that well";
    EXPECT_EQ(scene.render.residual_in_force(), RenderSettings::usual_residual);
}

}  // namespace
}  // namespace pol
