// SPDX-License-Identifier: Apache-2.0
// What a scene does not need is left out, and the plan says so.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "geometry/shapes.h"
#include "support/shipped_scenes.h"

namespace pol {
namespace {

Feature feature(const Plan& plan, const std::string& name) {
    const auto& list = plan.features.list;
    const auto found = std::find_if(list.begin(), list.end(), [&](const Feature& f) { return f.name == name; });
    if (found == list.end()) {
        ADD_FAILURE() << "the plan does not speak of '" << name << "'";
        return {};
    }
    EXPECT_FALSE(found->reason.empty()) << name;
    return *found;
}

/// A box of `medium` over a lamp, at `wavelengths`.
std::shared_ptr<const Plan> box_of(const std::string& medium, const std::string& wavelengths,
                                   const std::string& more = "") {
    return test::plan_of(test::scene_of(
        "camera: {position: [0, -4, 2], target: [0, 0, 0], fov: 30}\nrender: {wavelengths: " + wavelengths +
        "}\nmedia: {matter: " + medium + R"(}
objects:
  - {name: thing, shape: {box: {size: 1}}, medium: matter}
  - {name: lamp, shape: {rectangle: {size: 2}}, transform: [{translate: [0, 0, -0.6]}], emission: {radiance: 1}}
)" + more));
}

TEST(Features, AFlatConvexSolidOfGlassNeedsNothingButItsPlanes) {
    const auto plan = box_of("1.5", "380:780:20");
    for (const char* name :
         {"dispersion", "crystals (o and e rays)", "metals", "absorption along rays", "extinction taken as 0",
          "polarizers and retarders", "analytic spheres", "Embree scene", "shared faces", "faces nearly in one plane",
          "nested or overlapping media", "textured emission", "polarized emission", "background light",
          "pixel area sampling", "depth limit"})
        EXPECT_FALSE(feature(*plan, name).needed) << name;
    EXPECT_TRUE(feature(*plan, "half-space solids").needed);
    EXPECT_NE(feature(*plan, "half-space solids").reason.find("thing"), std::string::npos);
    EXPECT_FALSE(plan->features.meshes);
    EXPECT_EQ(plan->features.kernel, "isotropic, lossless");
    for (const Region& region : plan->regions) EXPECT_EQ(region.caster, nullptr);
    EXPECT_EQ(plan->groups.size(), 1U);  // one tree serves 21 wavelengths
    EXPECT_EQ(plan->groups[0].wavelengths.size(), 21U);
}

// A gap of 1e-7 is traced as one, but hardly meant; one of 0.1 is, and contact is none.
TEST(Features, FacesThatNearlyTouchAreNamed) {
    const auto with = [](const std::string& object) {
        return feature(*box_of("1.5", "580", "  - {name: second, " + object + "}\n"), "faces nearly in one plane");
    };
    for (const std::string object :
         {"shape: {box: {size: 1}}, transform: [{translate: [1.0000001, 0, 0]}], medium: matter",
          "shape: {rectangle: {size: 1}}, transform: [{translate: [0, 0, 0.5000001]}], absorber: on"}) {
        EXPECT_TRUE(with(object).needed);
        EXPECT_NE(with(object).reason.find("'thing' and 'second'"), std::string::npos) << with(object).reason;
    }
    for (const std::string object :
         {"shape: {box: {size: 1}}, transform: [{translate: [1, 0, 0]}], medium: matter",
          "shape: {rectangle: {size: 1}}, transform: [{translate: [0, 0, 0.6]}], absorber: on"})
        EXPECT_FALSE(with(object).needed);
}

TEST(Features, NeededOnesNameWhoNeedsThem) {
    const auto names = [](const std::shared_ptr<const Plan>& plan, const std::string& name, const std::string& user) {
        const Feature f = feature(*plan, name);
        EXPECT_TRUE(f.needed) << name;
        EXPECT_NE(f.reason.find(user), std::string::npos) << f.reason;
    };
    names(box_of("{index: {name: film, table: [[400, 1.5], [700, 1.5]], k: [[600, 0], [700, 0]]}}", "580"),
          "extinction taken as 0", "k of 'film' is not known at 580 nm");
    const auto crystal = box_of("{crystal: calcite}", "[450, 550]");
    names(crystal, "crystals (o and e rays)", "thing");
    names(crystal, "dispersion", "thing");
    EXPECT_TRUE(crystal->features.anisotropic);
    EXPECT_FALSE(crystal->features.absorbing);
    EXPECT_EQ(crystal->groups.size(), 2U);

    names(box_of("{conductor: gold}", "580"), "metals", "thing");

    const auto smoky = box_of("{index: 1.5, absorption: 2}", "580");
    names(smoky, "absorption along rays", "thing");
    EXPECT_TRUE(smoky->features.absorbing);
    EXPECT_FALSE(smoky->features.anisotropic);

    const auto busy = box_of("1.5", "580", R"(
  - {name: foil, shape: {disk: {radius: 1}}, transform: [{translate: [0, 0, 2]}], sheet: {polarizer: {axis: [1, 0, 0]}}}
  - {name: neighbor, shape: {box: {size: 1}}, transform: [{translate: [1, 0, 0]}], medium: matter}
  - {name: bubble, shape: {sphere: {radius: 0.1}}, medium: matter}
)");
    names(busy, "polarizers and retarders", "foil");
    names(busy, "shared faces", "neighbor");
    names(busy, "nested or overlapping media", "bubble");
    names(busy, "analytic spheres", "bubble");
}

// Equal indices make a crystal glass: no anisotropic code, and the picture is that of glass to the bit.
TEST(Features, ACrystalWithEqualIndicesIsGlass) {
    const auto twin = box_of("{ordinary: 1.5, extraordinary: 1.5, axis: [1, 2, 3]}", "580");
    EXPECT_FALSE(twin->features.anisotropic);
    EXPECT_FALSE(feature(*twin, "crystals (o and e rays)").needed);
}

TEST(Features, ANonConvexMeshIsBuiltForEmbreeAndAConvexOneIsNot) {
    const Mesh box = make_mesh(BoxShape{}).value();
    Mesh moved = transformed(box, DMat4{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {3, 0, 0, 1}}).value();
    Scene scene = test::shipped_scene("cube-glass");
    scene.objects[0].shape = MeshShape{"", std::make_shared<const Mesh>(box)};
    EXPECT_FALSE(test::plan_of(scene)->features.meshes);
    scene.objects[0].shape = MeshShape{"", std::make_shared<const Mesh>(test::joined(box, moved))};
    const auto plan = test::plan_of(scene);
    EXPECT_TRUE(plan->features.meshes);
    EXPECT_NE(feature(*plan, "Embree scene").reason.find("cube"), std::string::npos);
}

TEST(Features, AConvexSolidOfManyFacetsIsBuiltForEmbree) {
    for (const int corners : {4000, 5000}) {
        ExtrusionShape column;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2.0 * pi * i / corners;
            column.polygon.push_back({std::cos(angle), std::sin(angle)});
        }
        Scene scene = test::shipped_scene("cube-glass");
        scene.objects[0].shape = column;
        EXPECT_EQ(test::plan_of(scene)->features.meshes, corners > 4096) << corners;
    }
}

// Wavelengths share a tree exactly if all constants are equal there: flat from 400 to 500, then rising.
TEST(Features, WavelengthsWithEqualConstantsShareOneTree) {
    const auto plan = box_of("{index: {table: [[400, 1.5], [500, 1.5], [700, 1.6]]}}", "[400, 450, 500, 600, 700]");
    EXPECT_EQ(plan->group_of_wavelength, (std::vector<int>{0, 0, 0, 1, 2}));
    EXPECT_EQ(plan->groups[0].wavelengths, (std::vector<int>{0, 1, 2}));
    EXPECT_TRUE(feature(*plan, "dispersion").needed);
    EXPECT_FALSE(feature(*box_of("n-bk7", "580"), "dispersion").needed);
}

}  // namespace
}  // namespace pol
