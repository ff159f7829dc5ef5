// SPDX-License-Identifier: Apache-2.0
// What a picture says about its own error is true: deep renders against shallow ones, on every shipped scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "maps/error_bars.h"
#include "support/shipped_scenes.h"

namespace pol {
namespace {

/// Rounding of a Stokes vector, relative to the brightest light: up to 20000 additions of 1.1e-16, and 40 surfaces of
/// 60 operations on the way of each leaf, 2.5e-12. An error of that size is a difference of two states of light of that
/// trace, so it is taken into account as light that may be missing and as light that may be too much.
constexpr double rounding = 5e-12;

MeasureBounds<double> bars_with_rounding(const StokesImage& image, std::size_t pixel) {
    const double brightest = image.brightest[0];
    const double surplus = (image.plane_value(image.tail, 0, pixel) + rounding) * brightest;
    const double missing = image.plane_value(image.residual, 0, pixel) * brightest + surplus;
    return measure_bounds(image.at(0, pixel), missing, surplus);
}

bool meet(const Interval<double>& a, const Interval<double>& b, double slack = 1e-14) {
    return a.low <= b.high + slack && b.low <= a.high + slack;
}

/// Angle between two undirected lines.
double line_angle(double a, double b) {
    const double d = std::abs(std::remainder(a - b, std::numbers::pi));
    return std::min(d, std::numbers::pi - d);
}

/// Whether some truth is compatible with what both pictures say of the pixel.
testing::AssertionResult compatible(const StokesImage& a, const StokesImage& b, std::size_t pixel) {
    const MeasureBounds<double> bar_a = bars_with_rounding(a, pixel);
    const MeasureBounds<double> bar_b = bars_with_rounding(b, pixel);
    const auto refuse = [&](const char* what, const Interval<double>& x, const Interval<double>& y) {
        return testing::AssertionFailure() << what << " of pixel " << pixel << " in [" << x.low << ", " << x.high
                                           << "] and in [" << y.low << ", " << y.high << "]";
    };
    if (!meet(bar_a.s0, bar_b.s0)) return refuse("S0", bar_a.s0, bar_b.s0);
    if (!meet(bar_a.s1, bar_b.s1)) return refuse("S1", bar_a.s1, bar_b.s1);
    if (!meet(bar_a.s2, bar_b.s2)) return refuse("S2", bar_a.s2, bar_b.s2);
    if (!meet(bar_a.s3, bar_b.s3)) return refuse("S3", bar_a.s3, bar_b.s3);
    if (!meet(bar_a.dop, bar_b.dop)) return refuse("DoP", bar_a.dop, bar_b.dop);
    if (!meet(bar_a.dolp, bar_b.dolp)) return refuse("DoLP", bar_a.dolp, bar_b.dolp);
    if (!meet(bar_a.docp, bar_b.docp)) return refuse("DoCP", bar_a.docp, bar_b.docp);
    if (!meet(bar_a.ellipticity, bar_b.ellipticity)) return refuse("ellipticity", bar_a.ellipticity, bar_b.ellipticity);
    if (!meet(bar_a.ellipticity_angle, bar_b.ellipticity_angle))
        return refuse("ellipticity angle", bar_a.ellipticity_angle, bar_b.ellipticity_angle);
    const Measures<double> measures_a = measure(a.at(0, pixel));
    const Measures<double> measures_b = measure(b.at(0, pixel));
    if (measures_a.has_azimuth && measures_b.has_azimuth) {
        const double apart = line_angle(measures_a.azimuth, measures_b.azimuth);
        if (apart > bar_a.azimuth + bar_b.azimuth + 1e-14)
            return testing::AssertionFailure() << "azimuths of pixel " << pixel << " are " << apart << " apart, bars "
                                               << bar_a.azimuth << " and " << bar_b.azimuth;
    }
    return testing::AssertionSuccess();
}

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
    for (std::size_t p = 0; p < deep.pixel_count(); ++p) EXPECT_TRUE(compatible(deep, bushy, p));
    for (const Cut& cut : shallow_cuts) {
        const StokesImage shallow = render_cut(scene, cut);
        int violated = 0;
        for (std::size_t p = 0; p < deep.pixel_count(); ++p) {
            const bool fine = compatible(deep, shallow, p) && compatible(bushy, shallow, p);
            if (!fine && ++violated <= 3) ADD_FAILURE() << cut.name << ": " << compatible(deep, shallow, p).message();
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
