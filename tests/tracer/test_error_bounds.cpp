// SPDX-License-Identifier: Apache-2.0
// What a picture says about its own error is true: deep renders against shallow ones, on every shipped scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "polarization/measures.h"
#include "support/shipped_scenes.h"
#include "verify/invariants/error_bar_check.h"

namespace pol {
namespace {

/// How much of the bar of S0..S3 the error uses up, at the pixel that uses most of it.
double most_used(const StokesImage& shallow, const StokesImage& deep) {
    double most = 0.0;
    for (std::size_t p = 0; p < shallow.pixel_count(); ++p) {
        const double bar =
            (shallow.plane_value(shallow.residual, 0, p) + 2.0 * shallow.plane_value(shallow.tail, 0, p)) *
            shallow.brightest[0];
        const Stokes<double> d = deep.at(0, p) - shallow.at(0, p);
        if (bar > 1e-3 * shallow.brightest[0]) most = std::max(most, std::max(std::abs(d.s0), polarized_part(d)) / bar);
    }
    return most;
}

struct Cut {
    const char* name;
    double residual;
    int depth;  ///< -1: none
    int node_budget;
};

StokesImage render_cut(Scene scene, const Cut& cut) {
    scene.render.residual = cut.residual;
    scene.render.node_budget = cut.node_budget;
    if (cut.depth >= 0)
        scene.render.depth = cut.depth;
    else
        scene.render.depth.reset();
    return test::render(scene);
}

constexpr Cut shallow_cuts[] = {{"residual 0.3", 0.3, -1, 100000},    {"residual 0.1", 0.1, -1, 100000},
                                {"residual 0.03", 0.03, -1, 2000},    {"depth 3", 1e-3, 3, 2000},
                                {"depth 5", 1e-3, 5, 2000},           {"depth 9", 1e-3, 9, 2000},
                                {"20 rays and a tail", 1e-3, -1, 20}, {"tails, depth 7", 1e-3, 7, 10}};

class BoundedScene : public testing::TestWithParam<std::string> {};

std::string name_of(const testing::TestParamInfo<std::string>& parameter) {
    return test::test_name(parameter.param);
}

INSTANTIATE_TEST_SUITE_P(All, BoundedScene, testing::ValuesIn(test::shipped_scene_names()), name_of);

// Two references that cut the tree in different ways, by energy (with a tail where that is not enough) and by depth
// alone, against each other and against shallow renders: every pixel's bars have a truth in common.
TEST_P(BoundedScene, TruthLiesInsideTheErrorBarsOfEveryPixel) {
    const Scene scene = test::small(test::shipped_scene(GetParam()), 16);
    const bool crystals = test::has_crystals(*test::plan_of(scene));
    const StokesImage deep = render_cut(scene, {"deep", 1e-7, -1, crystals ? 10000 : 20000});
    const StokesImage bushy = render_cut(scene, {"bushy", 0.0, crystals ? 8 : 12, 20000});
    for (std::size_t p = 0; p < deep.pixel_count(); ++p)
        EXPECT_FALSE(verify::contradiction(deep, bushy, 0, p)) << *verify::contradiction(deep, bushy, 0, p);
    for (const Cut& cut : shallow_cuts) {
        const StokesImage shallow = render_cut(scene, cut);
        int violated = 0;
        for (std::size_t p = 0; p < deep.pixel_count(); ++p) {
            const auto wrong = verify::contradiction(deep, shallow, 0, p);
            const auto also_wrong = verify::contradiction(bushy, shallow, 0, p);
            if ((wrong || also_wrong) && ++violated <= 3)
                ADD_FAILURE() << cut.name << ": pixel " << p << ": " << (wrong ? *wrong : *also_wrong);
        }
        EXPECT_EQ(violated, 0) << cut.name;
    }
}

// The bars are not so wide that anything would lie in them: in a furnace all missing light is as bright as can be, and
// S0 lacks exactly what its bar says.
TEST(ErrorBounds, AreSharpInAFurnace) {
    const Scene furnace = test::as_furnace(test::small(test::shipped_scene("paper-glass-unpolarized"), 16), 1.0);
    const StokesImage deep = render_cut(furnace, {"deep", 1e-9, -1, 100000});
    const StokesImage shallow = render_cut(furnace, {"shallow", 0.1, -1, 100000});
    EXPECT_NEAR(most_used(shallow, deep), 1.0, 1e-6);  // the reference lacks 1e-9 of a bar of at least 1e-3
}

}  // namespace
}  // namespace pol
