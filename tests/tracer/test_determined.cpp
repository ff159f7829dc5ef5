// SPDX-License-Identifier: Apache-2.0
// Where no residual is asked for, a point picture's trees are followed until its maps are determined (CUTTING.md 2.1).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "maps/error_bars.h"
#include "maps/evaluate.h"
#include "polarization/bounds.h"
#include "polarization/measures.h"
#include "spectrum/illuminant.h"
#include "support/render_scene.h"
#include "support/shipped_scenes.h"
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

/// All that shines with the spectrum of D65: then every wavelength is judged by its own light (CUTTING.md 2.1).
Scene in_white_light(Scene scene) {
    const auto white = [](const Spectrum& spectrum) { return Spectrum{D65Spectrum{luminance(spectrum)}}; };
    scene.background.radiance = white(scene.background.radiance);
    for (Object& object : scene.objects)
        if (auto* emission = std::get_if<Emission>(&object.role)) {
            const auto* spectrum = std::get_if<Spectrum>(&emission->radiance);
            emission->radiance = spectrum != nullptr ? white(*spectrum) : Spectrum{D65Spectrum{1.0}};
        }
    return scene;
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
        Scene scene = in_white_light(small_scene(name));
        scene.render.wavelengths_nm = {450.0};
        const auto plan = test::plan_of(scene);
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
        const double luminance = plan->groups[0].brightest_luminance;
        for_each_pixel(*plan, [&](const Sample& sample, TraceTask task) {
            task.until_determined = false;
            const Sample cut = traced(*plan, task);
            EXPECT_LE(sample.result.residual, cut.result.residual + energy_tolerance);
            EXPECT_EQ(sample.result.tail, cut.result.tail) << "what is open below 1e-3 is never estimated";
            if (cut.result.tail > 0.0) return;
            EXPECT_GE(sample.light.s0, cut.light.s0);
            EXPECT_LE(sample.light.s0, cut.light.s0 + cut.result.residual * brightest * (1.0 + 1e-12));
            EXPECT_LE(sample.result.residual, 1e-3);
            const Stokes<double>& seen = sample.result.seen;
            const double missing = sample.result.residual * luminance;
            const bool is_dark = seen.s0 + missing <= dark_part * luminance;
            const auto budget = static_cast<std::uint32_t>(task.node_budget);
            // The last branch may end in as many leaves as a surface has children.
            EXPECT_LE(sample.result.nodes, budget + 4);
            EXPECT_TRUE(is_determined(seen, missing) || (is_dark && sample.result.nodes >= dark_budget) ||
                        sample.result.nodes >= budget || sample.result.residual <= least_open_weight);
        });
    }
}

bool same_light(const Stokes<double>& a, const Stokes<double>& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

// Red, green and blue lamps, and black patterns on them: what is bright at one wavelength is dark at another, so that a
// rule that looks at the light of a list stops elsewhere.
TEST(Determined, AWavelengthHasTheSameBitsAloneAndInAnyList) {
    const std::vector<double> list{450.0, 580.0, 650.0};
    for (const std::string& name : test::shipped_scene_names()) {
        SCOPED_TRACE(name);
        Scene scene = test::shipped_scene(name);
        scene.render.width = scene.render.height = name == "pile-of-plates" ? 2 : 20;
        scene.render.mode = SampleMode::point;
        scene.render.residual.reset();
        scene.render.wavelengths_nm = list;
        const auto together = test::plan_of(scene);
        for (std::size_t w = 0; w < list.size(); ++w) {
            SCOPED_TRACE(list[w]);
            scene.render.wavelengths_nm = {list[w]};
            const auto alone = test::plan_of(scene);
            const int group = together->group_of_wavelength[w];
            const std::vector<int>& members = together->groups[static_cast<std::size_t>(group)].wavelengths;
            const auto place = static_cast<std::size_t>(std::find(members.begin(), members.end(), static_cast<int>(w)) -
                                                        members.begin());
            std::vector<Stokes<double>> light(members.size());
            for_each_pixel(*alone, [&](const Sample& sample, const TraceTask& task) {
                TraceTask shared = task;
                shared.group = group;
                std::fill(light.begin(), light.end(), Stokes<double>{});
                const TraceResult result = trace_sample(*together, shared, light);
                ASSERT_TRUE(same_light(light[place], sample.light));
                ASSERT_EQ(result.residual, sample.result.residual);
                ASSERT_EQ(result.tail, sample.result.tail);
                ASSERT_EQ(result.nodes, sample.result.nodes);
            });
        }
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
