// SPDX-License-Identifier: Apache-2.0
// Trees followed again in 128 bit: they give the closed forms to thirty digits, and what the kernel is off from them is
// its rounding.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <utility>

#include "support/shipped_scenes.h"
#include "verify/convergence/rounding_error.h"
#include "verify/convergence/wide_replay.h"
#include "verify/degenerate/closed_paths.h"
#include "verify/invariants/invariants.h"

namespace pol::verify {
namespace {

constexpr Quad wide_epsilon = std::numeric_limits<Quad>::epsilon();

double as_double(const Quad& a) {
    return static_cast<double>(a);
}

/// |a - b| in units of `operations` roundings of 128 bit numbers around 1.
double roundings(const Quad& a, const Quad& b, int operations) {
    return as_double(abs(a - b) / (Quad(operations) * wide_epsilon));
}

/// The middle pixel's light without rounding.
Stokes<Quad> wide_look(const std::shared_ptr<const Plan>& plan) {
    const auto wide = wide_light(*plan, explain(*plan, 0, 0, 0, 0));
    if (!wide) throw std::runtime_error("the tree is another one in 128 bit");
    return wide->light;
}

/// S0 and S1 of uniform light after `depth` faces that all meet it at the same angle, s along the picture's x axis:
/// 1 - (1 - R) R^(depth - 1) with Fresnel's equations as Born and Wolf write them (Principles of Optics, 1.5.2).
std::pair<Quad, Quad> cut_furnace_light(const Quad& n, const Quad& sin_i, int depth) {
    const Quad cos_i = sqrt(Quad(1) - sin_i * sin_i);
    const Quad cos_t = sqrt(Quad(1) - sin_i * sin_i / (n * n));
    const Quad r_s = (cos_i - n * cos_t) / (cos_i + n * cos_t);
    const Quad r_p = (n * cos_i - cos_t) / (n * cos_i + cos_t);
    const auto light = [&](const Quad& r) {
        Quad missing = Quad(1) - r * r;
        for (int i = 1; i < depth; ++i) missing *= r * r;
        return Quad(1) - missing;
    };
    return {(light(r_s) + light(r_p)) / Quad(2), (light(r_s) - light(r_p)) / Quad(2)};
}

constexpr int depth = 5;

TEST(WideReplay, GivesTheLightOfACutFurnaceToThirtyDigitsInABall) {
    const double offset = 0.6;
    const Stokes<Quad> light = wide_look(test::plan_of(furnace_sphere(1.5, offset, depth)));
    const auto [s0, s1] = cut_furnace_light(Quad(1.5), Quad(offset), depth);
    EXPECT_LE(roundings(light.s0, s0, depth * surface_operations), 1.0);
    EXPECT_LE(roundings(light.s1, s1, depth * surface_operations), 1.0);
    EXPECT_LE(roundings(light.s2, Quad(0), depth * surface_operations), 1.0);
}

// Without polarization every face has the mean reflectance R of s and p, and 1 - (1 - R) R^(depth - 1) is left.
TEST(WideReplay, GivesTheLightOfTheUnpolarizedTwinToThirtyDigits) {
    const double offset = 0.6;
    Scene scene = furnace_sphere(1.5, offset, depth);
    scene.render.unpolarized = true;
    const Stokes<Quad> light = wide_look(test::plan_of(scene));
    const auto [one_face, difference] = cut_furnace_light(Quad(1.5), Quad(offset), 1);  // R_s and R_p: mean, half width
    const Quad r = one_face;
    Quad missing = Quad(1) - r;
    for (int i = 1; i < depth; ++i) missing *= r;
    EXPECT_LE(roundings(light.s0, Quad(1) - missing, depth * surface_operations), 1.0);
    EXPECT_GT(abs(difference), Quad(1e-3));
    EXPECT_EQ(light.s1, Quad(0));
}

Scene furnace_slab(double n, double size) {
    Scene scene = empty_scene(camera_at({-3.0, 0.0, 4.0}, {0.6, 0.0, -0.8}, {0.8, 0.0, 0.6}));
    scene.background.radiance = ConstantSpectrum{1.0};
    scene.media = {glass_medium("glass", n)};
    scene.objects = {solid("slab", BoxShape{{size, size, 1.0}}, {0.0, 0.0, -0.5}, "glass")};
    scene.render.cut_by_depth_alone(depth);
    return scene;
}

// The slab's corners are exact in double, so that its planes and its triangles are the same faces.
TEST(WideReplay, GivesTheLightOfACutFurnaceToThirtyDigitsInASlabOfPlanesOrTriangles) {
    for (const bool meshes : {false, true}) {
        const auto plan = compile(furnace_slab(1.5, 20.0), {.meshes = meshes}).value();
        const Explanation explanation = explain(*plan, 0, 0, 0, 0);
        const Vec3<Quad> direction = unit(Vec3<Quad>(explanation.task.ray.direction));
        const auto [s0, s1] = cut_furnace_light(Quad(1.5), abs(direction.x), depth);
        const Stokes<Quad> light = wide_light(*plan, explanation).value().light;
        EXPECT_LE(roundings(light.s0, s0, depth * surface_operations), 1.0);
        EXPECT_LE(roundings(light.s1, s1, depth * surface_operations), 1.0);
        // What is measured as the kernel's error is the kernel's distance from the closed form, to the last bit.
        const Stokes<double> kernels = light_without_tail(explanation.tree);
        EXPECT_EQ(as_double(Quad(kernels.s0) - light.s0), as_double(Quad(kernels.s0) - s0));
    }
}

// T = (1 - R)^2 exp(-alpha d) of each wave at normal incidence, the second pass cut off.
TEST(WideReplay, GivesTheTransmittanceOfATourmalinePlateToThirtyDigits) {
    UniaxialMedium crystal;
    crystal.ordinary = ConstantIndex{{1.64, 0.0}};
    crystal.extraordinary = ConstantIndex{{1.62, 0.0}};
    crystal.axis = {1.0, 0.0, 0.0};
    crystal.absorption_o = ConstantSpectrum{2.5};
    Scene scene = empty_scene(camera_at({0.0, 0.0, 3.0}, {0.0, 0.0, -1.0}, {1.0, 0.0, 0.0}));
    scene.media = {Medium{"tourmaline", crystal}};
    scene.objects = {solid("plate", BoxShape{{4.0, 4.0, 0.25}}, {0.0, 0.0, 0.0}, "tourmaline"),
                     lamp_sheet({0.0, 0.0, -4.0}, 40.0)};
    scene.render.cut_by_depth_alone(2);
    const Stokes<Quad> light = wide_look(test::plan_of(scene));
    const auto transmittance = [](const Quad& n, const Quad& absorbance) {
        const Quad r = (n - Quad(1)) / (n + Quad(1));
        return (Quad(1) - r * r) * (Quad(1) - r * r) * exp(-absorbance);
    };
    const Quad o = transmittance(Quad(1.64), Quad(2.5) / Quad(4));
    const Quad e = transmittance(Quad(1.62), Quad(0));
    EXPECT_LE(roundings(light.s0, (o + e) / Quad(2), 2 * surface_operations), 1.0);
    EXPECT_LE(roundings(light.s1, (o - e) / Quad(2), 2 * surface_operations), 1.0);  // o is along the picture's x axis
}

// Light at 45 degrees behind a retarder along x: S2 + i S3 = exp(-i retardance)/2, since y gains the phase and
// S2 + i S3 = 2 <E_x E_y*>. cos and sin of 100 radians to 40 digits by mpmath, as sums of doubles.
TEST(WideReplay, GivesTheStateBehindARetarderOfManyTurnsToThirtyDigits) {
    const auto sheet = [](const char* name, double z, Sheet kind) {
        return Object{
            name, RectangleShape{{4.0, 4.0}}, glm::translate(DMat4(1.0), DVec3(0.0, 0.0, z)), std::move(kind), {}};
    };
    Scene scene = empty_scene(camera_at({0.0, 0.0, 3.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}));
    scene.objects = {sheet("retarder", 1.0, Retarder{{1.0, 0.0, 0.0}, 100.0}),
                     sheet("polarizer", 0.0, LinearPolarizer{{1.0, 1.0, 0.0}}), lamp_sheet({0.0, 0.0, -4.0}, 40.0)};
    const Stokes<Quad> light = wide_look(test::plan_of(scene));
    const Quad cosine = Quad(0x1.b981dbf665fdfp-1) + Quad(0x1.8fd0cdcd985e8p-55) + Quad(0x1.057627d5fae8dp-111);
    const Quad sine = Quad(-0x1.03425b78c4db8p-1) + Quad(-0x1.c23d8557420fbp-59) + Quad(0x1.bc72a1db6abccp-114);
    // 16 turns are taken away, each to 1e-34; sheets take fewer operations than surfaces.
    EXPECT_LE(roundings(light.s0, Quad(0.5), 2 * surface_operations), 1.0);
    EXPECT_LE(roundings(light.s1, Quad(0), 2 * surface_operations), 1.0);
    EXPECT_LE(roundings(light.s2, cosine / Quad(2), 2 * surface_operations), 1.0);
    EXPECT_LE(roundings(light.s3, -sine / Quad(2), 2 * surface_operations), 1.0);
}

// R = ((n - 1)/(n + 1))^2, dR/dn = 4 (n - 1)/(n + 1)^3. The second order is 1e-16 of the first, and 60 roundings of
// 2^-112 are 60 * 2^-60 of a step of 2^-52.
TEST(WideReplay, SeesTheLastBitOfAnIndex) {
    const auto mirror = [](double n) {
        Scene scene = furnace_sphere(n, 0.0, 1);
        return test::plan_of(scene);
    };
    const double n = 1.5;
    const double nudged = std::nextafter(n, 2.0);
    const auto plan = mirror(n);
    const Explanation explanation = explain(*plan, 0, 0, 0, 0);
    const Quad change =
        wide_light(*mirror(nudged), explanation).value().light.s0 - wide_light(*plan, explanation).value().light.s0;
    const double expected = 4.0 * (n - 1.0) / std::pow(n + 1.0, 3) * (nudged - n);
    EXPECT_NEAR(as_double(change), expected, 1e-15 * expected);
}

// From inside, sin i = 0.6: glass of 1.6 refracts, glass of 1.7 reflects all.
TEST(WideReplay, LeavesOutAPixelWhoseBranchesAreOthersWithoutRounding) {
    const auto inside = [](double n) {
        Scene scene = furnace_slab(n, 20.0);
        scene.camera = camera_at({0.0, 0.0, -0.5}, {0.6, 0.0, 0.8}, {0.0, 1.0, 0.0});
        scene.render.cut_by_depth_alone(1);
        return test::plan_of(scene);
    };
    const auto refracts = inside(1.6);
    const auto reflects = inside(1.7);
    const Explanation two = explain(*refracts, 0, 0, 0, 0);
    const Explanation one = explain(*reflects, 0, 0, 0, 0);
    EXPECT_TRUE(wide_light(*refracts, two));
    EXPECT_TRUE(wide_light(*reflects, one));
    EXPECT_FALSE(wide_light(*reflects, two));
    EXPECT_FALSE(wide_light(*refracts, one));
}

TEST(WideReplay, TellsThatAFaceWasMetBeyondItsEdge) {
    const auto wide = test::plan_of(furnace_slab(1.5, 20.0));
    const auto narrow = test::plan_of(furnace_slab(1.5, 1.0));  // the second face is met at x = 0.4 / 0.8 * 1
    const Explanation explanation = explain(*wide, 0, 0, 0, 0);
    EXPECT_FALSE(wide_light(*wide, explanation).value().beyond_edge);
    EXPECT_TRUE(wide_light(*narrow, explanation).value().beyond_edge);
}

bool never_stop(std::size_t /*branches*/) {
    return true;
}

// The head of a tree is compared although its tail is not.
TEST(RoundingError, CountsThePixelsThatEndInARandomTail) {
    Scene scene = small(test::shipped_scene("cube-calcite"), 16);
    scene.render.node_budget = 10;
    const RoundingError error = rounding_error(*test::plan_of(scene), never_stop).value();
    EXPECT_EQ(error.compared, 256U);
    EXPECT_GT(error.with_tail, 0U);
    EXPECT_LE(error.with_tail, error.compared);
    EXPECT_GT(error.fro_c, 0.0);
}

TEST(RoundingError, IsZeroWhereNothingIsRounded) {
    Scene scene = empty_scene(camera_at({0.0, 0.0, 3.0}, {0.0, 0.0, -1.0}, {1.0, 0.0, 0.0}));
    scene.background.radiance = ConstantSpectrum{0.3};
    const RoundingError error = rounding_error(*test::plan_of(scene), never_stop).value();
    EXPECT_EQ(error.compared, 1U);
    EXPECT_EQ(error.largest, 0.0);
}

class ShippedTrees : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(All, ShippedTrees, testing::ValuesIn(test::shipped_scene_names()),
                         [](const auto& name) { return test::test_name(name.param); });

// tree_rounding: a sum of as many terms as the tree has branches, each with the rounding of 60 operations on each of 40
// surfaces. No entry of C, and no norm of it, exceeds the brightest light.
TEST_P(ShippedTrees, HaveNoMoreRoundingThanTheirOperationsAllow) {
    Scene scene = small(test::shipped_scene(GetParam()), 12);
    // Below, trees of the Wollaston prism get branches that they have not without rounding.
    scene.render.residual = scene.render.residual.value_or(RenderSettings::usual_residual);
    const auto plan = test::plan_of(scene);
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 12; ++x) {
            const Explanation e = explain(*plan, x, y, 0, 0);
            const auto wide = wide_light(*plan, e);
            ASSERT_TRUE(wide) << x << " " << y;
            const Stokes<double> light = light_without_tail(e.tree);
            const double allowed = tree_rounding(e.result.nodes) * plan->brightest[0];
            EXPECT_LE(rounding_distance(light, wide->light), allowed) << x << " " << y;
        }
    }
}

}  // namespace
}  // namespace pol::verify
