// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "compare/error_metrics.h"
#include "support/render_scene.h"
#include "verify/convergence/anytime.h"

namespace pol::verify {
namespace {

bool go_on(std::size_t /*branches*/) {
    return true;
}

// CUTTING.md 1.2: at every moment the light still missing is positive semidefinite and at most open * L_max. In a
// picture of pixel centers nothing else is wrong; the reference is known a thousand times better.
TEST(Anytime, AtEveryMomentTheErrorIsWithinTheBoundAndBothFall) {
    Scene scene = test::shipped_scene("paper-glass-unpolarized");
    scene.render.width = scene.render.height = 48;
    scene.render.residual = 1e-6;
    scene.render.node_budget = 1 << 16;
    const StokesImage reference = test::render(scene);
    scene.render.residual = 1e-2;
    const auto plan = test::plan_of(scene);
    const std::vector<AnytimePoint> curve = anytime_curve(plan, reference, 1, go_on);
    ASSERT_FALSE(curve.empty());
    for (std::size_t i = 0; i < curve.size(); ++i) {
        EXPECT_LE(curve[i].error, curve[i].bound + 1e-4) << i;
        if (i == 0) continue;
        EXPECT_GE(curve[i].seconds, curve[i - 1].seconds);
        EXPECT_LE(curve[i].bound, curve[i - 1].bound);
    }
    EXPECT_EQ(curve.back().error, error_metrics(test::render(plan), reference).fro_c.whole);
    const std::string csv = anytime_csv(curve);
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), static_cast<std::ptrdiff_t>(curve.size() + 1));
}

TEST(Anytime, EndsWhenNobodyWaits) {
    Scene scene = test::shipped_scene("paper-calcite-unpolarized");
    const auto plan = test::plan_of(scene);
    StokesImage reference;
    reference.width = scene.render.width;
    reference.height = scene.render.height;
    reference.bands = bands_at(plan->wavelengths_nm);
    reference.stokes.assign(reference.pixel_count() * reference.bands.size(), {1.0, 0.0, 0.0, 0.0});
    reference.brightest.assign(reference.bands.size(), 1.0);
    EXPECT_TRUE(anytime_curve(plan, reference, 1, [](std::size_t) { return false; }).empty());
}

}  // namespace
}  // namespace pol::verify
