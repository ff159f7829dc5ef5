// SPDX-License-Identifier: Apache-2.0
// What a scene does not need is left out, and the plan says so.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/units.h"
#include "geometry/mesh_check.h"
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
    for (const char* name : {"dispersion",
                             "crystals (o and e rays)",
                             "metals",
                             "absorption along rays",
                             "extinction taken as 0",
                             "polarizers and retarders",
                             "analytic spheres",
                             "Embree scene",
                             "shared faces",
                             "faces nearly in one plane",
                             "nested or overlapping media",
                             "textured emission",
                             "polarized emission",
                             "background light",
                             "pixel area sampling",
                             "halves of the samples",
                             "lamps or absorbers in faces",
                             "start of every ray",
                             "surfaces in every region",
                             "depth limit"})
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
    EXPECT_TRUE(crystal->kernel().anisotropic);
    EXPECT_FALSE(crystal->kernel().absorbing);
    EXPECT_EQ(crystal->groups.size(), 2U);

    names(box_of("{conductor: gold}", "580"), "metals", "thing");

    const auto smoky = box_of("{index: 1.5, absorption: 2}", "580");
    names(smoky, "absorption along rays", "thing");
    EXPECT_TRUE(smoky->kernel().absorbing);
    EXPECT_FALSE(smoky->kernel().anisotropic);

    const auto busy = box_of("1.5", "580", R"(
  - {name: foil, shape: {disk: {radius: 1}}, transform: [{translate: [0, 0, 2]}], sheet: {polarizer: {axis: [1, 0, 0]}}}
  - {name: neighbor, shape: {box: {size: 1}}, transform: [{translate: [1, 0, 0]}], medium: matter}
  - {name: bubble, shape: {sphere: {radius: 0.1}}, medium: matter}
)");
    names(busy, "polarizers and retarders", "foil");
    names(busy, "shared faces", "neighbor");
    names(busy, "nested or overlapping media", "bubble");
    names(busy, "analytic spheres", "bubble");

    // A lamp in a face, and rays that start on both sides of one.
    names(
        box_of("1.5", "580",
               "  - {name: seal, shape: {disk: {radius: 0.2}}, transform: [{translate: [0, 0, 0.5]}], absorber: on}\n"),
        "lamps or absorbers in faces", "thing");
    Scene wide = test::shipped_scene("cube-glass");
    wide.camera.projection = Projection::orthographic;
    wide.camera.position = {0.0, 0.0, 0.0};
    wide.camera.target = {0.0, 1.0, 0.0};
    wide.camera.up = {0.0, 0.0, 1.0};
    wide.camera.width = 4.0;
    const auto inside_and_out = test::plan_of(wide);
    names(inside_and_out, "start of every ray", "cube");
    names(inside_and_out, "start of every ray", "the surroundings");

    Scene noisy = wide;
    noisy.render.mode = SampleMode::area;
    noisy.render.samples_per_pixel = 1;
    EXPECT_FALSE(feature(*test::plan_of(noisy), "halves of the samples").needed);
    noisy.render.samples_per_pixel = 2;
    names(test::plan_of(noisy), "halves of the samples", "error of sampling");
}

// Only code that would run can be kept, and only what is left out has some to keep.
TEST(Features, WhatIsNeededHasNothingToKeep) {
    for (const char* matter : {"1.5", "{crystal: calcite}", "{index: 1.5, absorption: 2}"}) {
        const auto plan = box_of(matter, "[450, 650]");
        for (const Feature& f : plan->features.list)
            EXPECT_TRUE(!f.needed || f.spare == nullptr) << matter << ": " << f.name;
    }
    const auto glass = box_of("1.5", "[450, 650]");
    EXPECT_EQ(feature(*glass, "dispersion").spare, &SpareParts::tree_per_wavelength);
    EXPECT_EQ(feature(*box_of("1.5", "580"), "dispersion").spare, nullptr);
    EXPECT_EQ(feature(*glass, "metals").spare, nullptr);
    EXPECT_EQ(feature(*glass, "surfaces in every region").spare, &SpareParts::every_surface);
    // Who comes out of a face that a lamp lies in must not meet the lamp first.
    const auto lamp_in_face = box_of("1.5", "580",
                                     "  - {name: seal, shape: {disk: {radius: 0.2}}, transform: [{translate: [0, 0, "
                                     "0.5]}], emission: {radiance: 1}}\n");
    EXPECT_EQ(feature(*lamp_in_face, "surfaces in every region").spare, nullptr);
    // Outside, where a sheet is looked for, no branch ends when it is born (Region::is_open).
    const auto sheet_inside = box_of(
        "1.5", "580", "  - {name: foil, shape: {rectangle: {size: 0.4}}, sheet: {polarizer: {axis: [1, 0, 0]}}}\n");
    EXPECT_FALSE(feature(*sheet_inside, "surfaces in every region").needed);
    EXPECT_EQ(feature(*sheet_inside, "surfaces in every region").spare, nullptr);
}

// Equal indices make a crystal glass: no anisotropic code, and the picture is that of glass to the bit.
TEST(Features, ACrystalWithEqualIndicesIsGlass) {
    const auto twin = box_of("{ordinary: 1.5, extraordinary: 1.5, axis: [1, 2, 3]}", "580");
    EXPECT_FALSE(twin->kernel().anisotropic);
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

// Wavelengths share a tree if all constants are equal there; the index of an absorbing medium, n + i alpha lambda / 4
// pi, is not. Where an index may depend on the wavelength they never do: each has sample positions of its own.
TEST(Features, WavelengthsWithEqualConstantsShareOneTree) {
    const auto plan = box_of("1.5", "[400, 450, 500]");
    EXPECT_EQ(plan->group_of_wavelength, (std::vector<int>{0, 0, 0}));
    EXPECT_EQ(plan->groups[0].wavelengths, (std::vector<int>{0, 1, 2}));
    EXPECT_FALSE(feature(*plan, "dispersion").needed);
    EXPECT_EQ(box_of("{index: 1.5, absorption: 1}", "[400, 500]")->groups.size(), 2U);
    const auto flat = box_of("{index: {table: [[400, 1.5], [700, 1.5]]}}", "[400, 500]");
    EXPECT_EQ(flat->group_of_wavelength, (std::vector<int>{0, 1}));
    EXPECT_NE(feature(*flat, "dispersion").reason.find("an index that is a function of the wavelength"),
              std::string::npos);
    EXPECT_FALSE(feature(*box_of("n-bk7", "580"), "dispersion").needed);
}

/// What the plan of solids over a lamp doubts; lengths are in mm.
std::vector<std::string> doubts(const std::string& media, const std::string& solids,
                                const std::string& wavelengths = "580") {
    return test::plan_of(test::scene_of("camera: {position: [0, -90, 90], target: [0, 0, 0], fov: 30}\n"
                                        "render: {wavelengths: " +
                                        wavelengths + "}\nmedia: {" + media + "}\nobjects:\n" + solids))
        ->features.doubts;
}

std::string slab(const std::string& thickness, const std::string& medium, const std::string& z = "0") {
    return "  - {name: slab at " + z + ", shape: {box: {size: [20, 20, " + thickness + "]}}, medium: " + medium +
           ", transform: [{rotate: {axis: [1, 1, 0], angle: 20}}, {translate: [0, 0, " + z + "]}]}\n";
}

const std::string quartz = "quartz: {ordinary: 1.5442, extraordinary: 1.5533, axis: [1, 1, 0]}";

// 580 nm taken as 10 nm wide stays coherent over 580^2/10 nm = 33.6 um. Quartz of 0.0091 reaches that at 3.7 mm, glass
// of 1.5 at 33.64/3 um = 11.2 um.
TEST(Coherence, PlatesThinnerThanLightStaysCoherentAreNamedWithTheirNumbers) {
    const auto film = doubts(quartz, slab("0.0001", "quartz"));
    ASSERT_EQ(film.size(), 1U);
    for (const char* words : {"'slab at 0' is 100 nm thick", "optical path of 0.91 nm", "coherent over 33.6 um",
                              "between polarizers this plate would show interference"})
        EXPECT_NE(film[0].find(words), std::string::npos) << film[0];
    for (const char* thin : {"0.03", "1", "3.6"}) EXPECT_EQ(doubts(quartz, slab(thin, "quartz")).size(), 1U) << thin;
    EXPECT_TRUE(doubts(quartz, slab("3.8", "quartz")).empty());
    EXPECT_EQ(doubts("glass: 1.5", slab("0.011", "glass")).size(), 1U);
    EXPECT_TRUE(doubts("glass: 1.5", slab("0.0115", "glass")).empty());
    EXPECT_TRUE(doubts("calcite: {crystal: calcite}", slab("1", "calcite")).empty());
}

// A wavelength of a list stands for the distance to its neighbor: 600^2/20 nm = 18 um, quartz up to 1.98 mm.
TEST(Coherence, ShrinksWithTheBandThatAWavelengthStandsFor) {
    EXPECT_EQ(doubts(quartz, slab("1.9", "quartz"), "560:600:20").size(), 1U);
    EXPECT_TRUE(doubts(quartz, slab("2.1", "quartz"), "560:600:20").empty());
}

TEST(Coherence, LooksIntoGapsShellsAndMeshesToo) {
    const auto gap = doubts("glass: 1.5", slab("1", "glass", "0") + slab("1", "glass", "1.07"));
    // Faces tilted by 20 degrees, 1.07 apart along z: the gap is 1.07 cos 20 - 1 = 5.47 um.
    ASSERT_EQ(gap.size(), 1U);
    EXPECT_NE(gap[0].find("the gap between 'slab at 0' and 'slab at 1.07' is 5.47 um thick"), std::string::npos)
        << gap[0];
    const auto ball = [](const char* name, const char* medium, double radius) {
        return std::string("  - {name: ") + name + ", shape: {sphere: {radius: " + std::to_string(radius) +
               "}}, medium: " + medium + ", priority: " + (name[0] == 'b' ? "0" : "1") + "}\n";
    };
    const auto bubble = doubts("water: 1.33, air: 1", ball("bubble", "water", 5.0) + ball("inside", "air", 4.9995));
    ASSERT_EQ(bubble.size(), 1U);
    EXPECT_NE(bubble[0].find("'bubble' is 500 nm thick"), std::string::npos) << bubble[0];
    Scene scene = test::shipped_scene("cube-glass");
    const Mesh sheet = make_mesh(BoxShape{{1.0, 1.0, 0.001}}).value();
    const Mesh away = transformed(sheet, DMat4{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {3, 0, 0, 1}}).value();
    scene.objects[0].shape = MeshShape{"", std::make_shared<const Mesh>(test::joined(sheet, away))};
    EXPECT_EQ(test::plan_of(scene)->features.doubts.size(), 1U);
}

TEST(Coherence, LeavesOutWhatLetsNoLightThroughAndWhatTouches) {
    EXPECT_TRUE(doubts("gold: {conductor: gold}", slab("0.001", "gold")).empty());
    EXPECT_TRUE(doubts("gold: gold", slab("0.001", "gold")).empty());
    EXPECT_EQ(doubts("gold: gold", slab("0.00002", "gold")).size(), 1U);
    EXPECT_TRUE(doubts("glass: 1.5, flint: 1.7",
                       "  - {name: one, shape: {box: {size: 1}}, medium: glass}\n"
                       "  - {name: two, shape: {box: {size: 1}}, medium: flint, transform: [{translate: [1, 0, 0]}]}\n")
                    .empty());
}

// exp(-4 pi 2.84 100/580) = 0.2 % of the light comes through 100 nm of gold.
TEST(Coherence, MetalThatLightGoesThroughIsNamed) {
    const auto found = doubts("gold: {conductor: gold}", slab("0.0001", "gold"));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NE(found[0].find("'slab at 0' is 100 nm of metal"), std::string::npos) << found[0];
}

// A ball of quartz of 1 mm: 2 mm times 0.0091 is less than 33.6 um. Of calcite it is 0.34 mm.
TEST(Coherence, LooksIntoBallsOfCrystal) {
    const std::string ball = "  - {name: ball, shape: {sphere: {radius: 1}}, medium: ";
    EXPECT_EQ(doubts(quartz, ball + "quartz}\n").size(), 1U);
    EXPECT_TRUE(doubts("calcite: {crystal: calcite}", ball + "calcite}\n").empty());
}

// A gap is one however large the lamp behind it is.
TEST(Coherence, DoesNotDependOnTheSizeOfOtherThings) {
    const std::string far =
        "  - {name: lamp, shape: {rectangle: {size: 1e6}}, transform: [{translate: [0, 0, -1e6]}], "
        "emission: {radiance: 1}}\n";
    EXPECT_EQ(doubts("glass: 1.5", slab("0.0005", "glass") + far).size(), 1U);
    const std::string halves =
        "  - {name: left, shape: {box: {size: 2}}, medium: glass}\n"
        "  - {name: right, shape: {box: {size: 2}}, medium: glass, transform: [{translate: "
        "[2.000000001, 0, 0]}]}\n";
    EXPECT_EQ(doubts("glass: 1.5", halves).size(), 1U);
}

// A heptagonal prism in six digits (1.00065), its faces cut into triangles that rounding bends by some 1e-6: no gap.
TEST(Coherence, TrianglesOfAFaceThatRoundingBentAreNoFilm) {
    const DVec3 axis = unit(DVec3(1.0, 2.0, 3.0));
    const auto turned = [&axis](const DVec3& p) {  // by 1 rad, Rodrigues
        return std::cos(1.0) * p + std::sin(1.0) * cross(axis, p) + (1.0 - std::cos(1.0)) * dot(axis, p) * axis;
    };
    const auto rounded = [](double x) { return std::round(x * 1e5) / 1e5; };
    std::vector<DVec3> vertices;
    for (const double z : {-0.5, 0.5})
        for (int i = 0; i < 7; ++i) {
            const double angle = 2.0 * pi * i / 7.0;
            const DVec3 p = turned({std::cos(angle), std::sin(angle), z});
            vertices.emplace_back(rounded(p.x), rounded(p.y), rounded(p.z));
        }
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::uint32_t i = 1; i + 1 < 7; ++i) {
        triangles.push_back({7, 7 + i, 8 + i});
        triangles.push_back({0, i + 1, i});
    }
    for (std::uint32_t i = 0; i < 7; ++i) {
        const std::uint32_t next = (i + 1) % 7;
        triangles.push_back({i, next, 7 + next});
        triangles.push_back({i, 7 + next, 7 + i});
    }
    Scene scene = test::shipped_scene("cube-glass");
    scene.objects[0].shape =
        MeshShape{"", std::make_shared<const Mesh>(mesh_from_triangles(vertices, triangles).value())};
    EXPECT_TRUE(test::plan_of(scene)->features.doubts.empty());
}

// Of the shipped scenes one has such a film: 0.02 mm along x is 15.7 um across the air gap of the Glan prism.
TEST(Coherence, OfTheShippedScenesOnlyTheAirGapIsDoubted) {
    for (const std::string& name : test::shipped_scene_names()) {
        const auto found = test::plan_of(test::shipped_scene(name))->features.doubts;
        ASSERT_EQ(found.size(), name == "glan-air" ? 1U : 0U) << name;
        for (const std::string& gap : found) EXPECT_NE(gap.find("is 15.7 um thick"), std::string::npos) << gap;
    }
}

// 4 n k^2/(n + 1)^4 with n = 1.5, k = 0.005: 3.84e-6.
TEST(Features, CrystalsWhoseFacesShouldShowTheirAbsorptionAreDoubted) {
    const auto found = doubts("dye: {ordinary: [1.5, 0.005], extraordinary: 1.6}", slab("4", "dye"));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NE(found[0].find("'dye'"), std::string::npos);
    EXPECT_NE(found[0].find("3.84"), std::string::npos) << found[0];
    EXPECT_TRUE(doubts("dye: {ordinary: [1.5, 0.002], extraordinary: 1.6}", slab("4", "dye")).empty());
}

// 20 k with k = 0.005; a plate has sides that are not parallel to its faces, a ball has none.
TEST(Features, GlassThatAbsorbsBetweenFacesThatAreNotParallelIsDoubted) {
    const auto found = doubts("dye: {index: [1.5, 0.005]}", slab("4", "dye"));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NE(found[0].find("'dye' absorbs, up to k = 0.005"), std::string::npos) << found[0];
    EXPECT_NE(found[0].find("off by up to about 0.1"), std::string::npos) << found[0];
    EXPECT_TRUE(
        doubts("dye: {index: [1.5, 0.005]}", "  - {name: ball, shape: {sphere: {radius: 1}}, medium: dye}\n").empty());
    EXPECT_TRUE(doubts("dye: {index: [1.5, 1e-8]}", slab("4", "dye")).empty());
}

}  // namespace
}  // namespace pol
