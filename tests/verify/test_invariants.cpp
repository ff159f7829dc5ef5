// SPDX-License-Identifier: Apache-2.0
// The invariants hold on every shipped scene, and fail where a picture is tampered with.
#include <gtest/gtest.h>

#include <limits>

#include "support/shipped_scenes.h"
#include "verify/invariants/error_bar_check.h"
#include "verify/invariants/invariants.h"
#include "verify/invariants/scene_twins.h"

namespace pol::verify {
namespace {

class ShippedScene : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(All, ShippedScene, testing::ValuesIn(test::shipped_scene_names()),
                         [](const auto& name) { return test::test_name(name.param); });

TEST_P(ShippedScene, HoldsAllInvariants) {
    const auto scene = under_test(small(test::shipped_scene(GetParam()), 16));
    ASSERT_TRUE(scene) << to_string(scene.error());
    for (const Invariant& invariant : invariants()) {
        const InvariantResult result = invariant.check(scene.value());
        EXPECT_NE(result.outcome, Outcome::fail) << invariant.name << ": " << result.violated << " of " << result.tested
                                                 << ", worst " << result.worst << " tolerances; " << result.note;
        EXPECT_EQ(result.outcome == Outcome::does_not_apply, result.tested == 0) << invariant.name;
    }
}

// A model without amplitudes still conserves energy, turns with the scene and keeps its bounds.
TEST(Invariants, HoldForTheUnpolarizedTwinWithoutReciprocity) {
    for (const char* name : {"paper-calcite-polarized", "pile-of-plates", "metal-spheres"}) {
        Scene scene = small(test::shipped_scene(name), 12);
        scene.render.unpolarized = true;
        const SceneUnderTest twin = under_test(scene).value();
        EXPECT_EQ(is_reciprocal(twin).outcome, Outcome::does_not_apply);
        for (const Invariant& invariant : invariants()) {
            const InvariantResult result = invariant.check(twin);
            EXPECT_NE(result.outcome, Outcome::fail) << name << ": " << invariant.name << "; " << result.note;
        }
    }
}

SceneUnderTest glass_ball() {
    return under_test(test::scene_of(R"(
camera: {position: [0, -6, 2], target: [0, 0, 0.1], fov: 30}
background: 0.5
render: {size: [8, 8]}
media: {glass: 1.5}
objects:
  - {name: ball, shape: {sphere: {radius: 1}}, medium: glass}
  - {name: lamp, shape: {rectangle: {size: 3}}, transform: [{translate: [0, 0, -1.2]}],
     emission: {radiance: 1, polarization: {dop: 0.8, azimuth: 20, ellipticity: 0.4, handedness: left}}}
)"))
        .value();
}

// Trees of most scenes of glass end: P = 0 within rounding then.
TEST_P(ShippedScene, OfGlassLeavesNoPolarizationInAFurnaceWhenFollowedToTheEnd) {
    Scene scene = small(test::shipped_scene(GetParam()), 8);
    scene.render.residual = 1e-12;
    scene.render.node_budget = 20000;
    const auto plan = test::plan_of(scene);
    if (what_loses_light(scene, *plan) || test::has_crystals(*plan)) GTEST_SKIP() << "not lossless glass";
    EXPECT_EQ(is_invisible_in_a_furnace(under_test(scene).value()).outcome, Outcome::pass);
}

TEST(Invariants, ApplyWhereTheyCanAndSayWhyWhereTheyCannot) {
    const SceneUnderTest scene = glass_ball();
    EXPECT_EQ(is_glass_with_equal_indices(scene).outcome, Outcome::does_not_apply);
    EXPECT_EQ(is_invisible_in_a_furnace(scene).outcome, Outcome::pass);
    EXPECT_EQ(is_reciprocal(scene).outcome, Outcome::pass);
    EXPECT_GE(is_reciprocal(scene).tested, 16U);
}

// A lamp inside the glass as bright as the surroundings is 2.25 times too dim for an equilibrium.
TEST(Invariants, DoNotTakeALampInGlassForAFurnace) {
    const auto scene = under_test(test::scene_of(R"(
camera: {position: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], fov: 20}
render: {size: [4, 4]}
media: {glass: 1.5}
objects:
  - {name: block, shape: {box: {size: 2}}, medium: glass}
  - {name: lamp, shape: {rectangle: {size: 1}}, emission: {radiance: 1}}
)"));
    const InvariantResult result = is_invisible_in_a_furnace(scene.value());
    EXPECT_EQ(result.outcome, Outcome::does_not_apply);
    EXPECT_NE(result.note.find("another medium"), std::string::npos);
}

// Lengths in the absorption coefficient grow with the scene.
TEST(Invariants, HoldForAbsorbingCrystalsAndSheets) {
    const auto scene = under_test(test::scene_of(R"(
camera: {position: [0.3, -6, 2.2], target: [0, 0, 0.1], fov: 26}
background: 0.3
render: {size: [8, 8], mode: area, spp: 2}
media:
  tourmaline: {ordinary: 1.64, extraordinary: 1.62, axis: [1, 0.3, 0.2], axis_space: world, absorption_o: 2, absorption_e: 0.3}
objects:
  - {name: stone, shape: {box: {size: [1.5, 1, 1.2]}}, medium: tourmaline}
  - {name: sheet, shape: {disk: {radius: 2}}, transform: [{rotate: {axis: [1, 0, 0], angle: 80}}, {translate: [0, -2, 0.5]}],
     sheet: {circular: {passes: left}}}
)"));
    ASSERT_TRUE(scene) << to_string(scene.error());
    for (const Invariant& invariant : invariants())
        EXPECT_NE(invariant.check(scene.value()).outcome, Outcome::fail) << invariant.name;
}

// Faces of complex index, entered, left and met from inside at every angle, total reflection included.
TEST(Invariants, HoldForDyedGlassAndForGoldWrittenAsAPlainMedium) {
    const auto scene = under_test(test::scene_of(R"(
camera: {position: [0.3, -6, 2.2], target: [0, 0, 0.1], fov: 26}
background: 0.3
render: {size: [8, 8], mode: area, spp: 2}
media: {dye: {index: [1.5, 3e-5]}, smoke: {index: 1.7, absorption: 0.4}, gold: gold}
objects:
  - {name: stone, shape: {prism: {apex_angle: 60, side: 1.5, height: 2}}, transform: [{translate: [-0.6, 0, 0]}], medium: dye}
  - {name: ball, shape: {sphere: {radius: 0.6}}, transform: [{translate: [1, 0, 0]}], medium: smoke}
  - {name: block, shape: {box: {size: [4, 4, 1]}}, transform: [{translate: [0, 0, -1.7]}], medium: gold}
)"));
    ASSERT_TRUE(scene) << to_string(scene.error());
    for (const Invariant& invariant : invariants())
        EXPECT_NE(invariant.check(scene.value()).outcome, Outcome::fail) << invariant.name;
}

TEST(Invariants, FindTheOnePixelOfAPictureThatIsWrong) {
    SceneUnderTest scene = glass_ball();
    Stokes<double>& s = scene.image.stokes[scene.image.pixel(5, 3)];
    const Stokes<double> right = s;
    const auto finds = [&](InvariantResult (*check)(const SceneUnderTest&)) {
        const InvariantResult result = check(scene);
        EXPECT_EQ(result.outcome, Outcome::fail);
        ASSERT_TRUE(result.worst_pixel);
        EXPECT_EQ(result.worst_pixel->x, 5);
        EXPECT_EQ(result.worst_pixel->y, 3);
    };
    s.s0 = std::nextafter(right.s0, 2.0);  // one bit
    finds(is_the_same_for_any_threads_and_tiles);
    finds(is_the_sum_of_its_leaves);
    s = {right.s0, right.s0, 0.0, 1e-4 * right.s0};
    finds(is_physical);
    s = {-1e-9, 0.0, 0.0, 0.0};
    finds(is_physical);
    s = right;
    s.s2 = std::numeric_limits<double>::quiet_NaN();
    finds(is_physical);
}

// All at every pixel; more than a pixel is looked at; more than there are pixels.
TEST(Invariants, LookAtTheTreesOfEveryWavelength) {
    for (const std::size_t wavelengths : {std::size_t{3}, std::size_t{8}, std::size_t{13}}) {
        Scene scene = glass_ball().scene;
        scene.render.width = scene.render.height = 3;
        scene.render.wavelengths_nm.clear();
        for (std::size_t w = 0; w < wavelengths; ++w)
            scene.render.wavelengths_nm.push_back(400.0 + 20.0 * static_cast<double>(w));
        const SceneUnderTest right = under_test(scene).value();
        EXPECT_EQ(is_the_sum_of_its_leaves(right).outcome, Outcome::pass);
        for (std::size_t w = 0; w < wavelengths; ++w) {
            SceneUnderTest wrong = right;
            for (std::size_t p = 0; p < wrong.image.pixel_count(); ++p)
                wrong.image.stokes[w * wrong.image.pixel_count() + p].s0 += 1e-9;
            const InvariantResult result = is_the_sum_of_its_leaves(wrong);
            EXPECT_EQ(result.outcome, Outcome::fail) << w << " of " << wavelengths;
            ASSERT_TRUE(result.worst_pixel);
            EXPECT_EQ(result.worst_pixel->wavelength_nm, scene.render.wavelengths_nm[w]);
        }
        EXPECT_LE(is_the_sum_of_its_leaves(right).tested, 5U * right.image.pixel_count());
    }
}

TEST(ErrorBars, ContradictEachOtherWhereThePictureIsOffByMoreThanItSays) {
    const SceneUnderTest scene = glass_ball();
    StokesImage other = scene.image;
    const std::size_t pixel = other.pixel(4, 4);
    EXPECT_FALSE(contradiction(scene.image, other, 0, pixel));
    const double bar = scene.image.plane_value(scene.image.residual, 0, pixel) * scene.image.brightest[0];
    other.stokes[pixel].s0 += 0.9 * bar;
    EXPECT_FALSE(contradiction(scene.image, other, 0, pixel));
    other.stokes[pixel].s0 += bar + 1e-9;
    ASSERT_TRUE(contradiction(scene.image, other, 0, pixel));
    EXPECT_NE(contradiction(scene.image, other, 0, pixel)->find("S0 in"), std::string::npos);
}

}  // namespace
}  // namespace pol::verify
