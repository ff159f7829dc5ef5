// SPDX-License-Identifier: Apache-2.0
// Scenes that have values in range but make no sense in space: an error that names who is in whose way.
#include <gtest/gtest.h>

#include <string>

#include "support/render_scene.h"

namespace pol {
namespace {

Error refusal(const std::string& objects,
              const std::string& camera = "{position: [0, -4, 2], target: [0, 0, 0], fov: 30}") {
    const Scene scene = test::scene_of("camera: " + camera + R"(
media: {glass: 1.5, dense glass: 1.7, calcite: {crystal: calcite}, gold: {conductor: gold}}
objects:
)" + objects);
    const auto plan = compile(scene);
    EXPECT_FALSE(plan) << "compiled";
    return plan ? Error{} : plan.error();
}

void expect_names(const Error& error, const std::string& field, std::initializer_list<const char*> names) {
    EXPECT_EQ(error.kind, ErrorKind::input);
    EXPECT_NE(error.field.find(field), std::string::npos) << to_string(error);
    EXPECT_FALSE(error.hint.empty()) << to_string(error);
    EXPECT_GT(error.place.line, 0) << to_string(error);
    for (const char* name : names) EXPECT_NE(error.what.find(name), std::string::npos) << to_string(error);
}

// Nobody has to ask first_problem() before: compiling such a scene used to end the process.
TEST(Refusals, WhatIsWrongWithTheValuesIsFoundWhenCompiling) {
    const Scene good = test::shipped_scene("cube-glass");
    const auto expect_refused = [](const Scene& scene, const std::string& field) {
        const auto plan = compile(scene);
        ASSERT_FALSE(plan) << field;
        EXPECT_EQ(plan.error().field, field);
        EXPECT_EQ(plan.error().kind, ErrorKind::input);
    };
    Scene blind = good;
    blind.render.wavelengths_nm.clear();
    expect_refused(blind, "render.wavelengths");
    Scene empty = good;
    empty.render.width = 0;
    expect_refused(empty, "render.size");
    Scene bodiless = good;
    bodiless.objects[0].shape = MeshShape{"gone.ply", nullptr};
    expect_refused(bodiless, "objects[0].shape.mesh.file");
    Scene unknown = good;
    unknown.objects[0].role = FilledWith{"unobtainium"};
    expect_refused(unknown, "objects[0].medium");
    Scene pale = good;
    auto image = std::make_shared<RgbImage>();
    image->width = image->height = 4;
    pale.objects[0].shape = RectangleShape{};
    pale.objects[0].role = Emission{TexturedRadiance{"pale.png", image, 1.0}, Unpolarized{}, false};
    expect_refused(pale, "objects[0].emission.radiance.texture");
}

TEST(Refusals, AnOverlapWithoutPriorityNamesBothSolids) {
    expect_names(refusal(R"(
  - {name: ruby, shape: {box: {size: 1}}, medium: glass}
  - {name: pearl, shape: {sphere: {radius: 0.5}}, transform: [{translate: [0.5, 0, 0]}], medium: dense glass}
)"),
                 "objects[1].priority", {"ruby", "pearl"});
}

TEST(Refusals, EqualPrioritiesDecideNothing) {
    expect_names(refusal(R"(
  - {name: ruby, shape: {box: {size: 1}}, medium: glass, priority: 3}
  - {name: pearl, shape: {box: {size: 1}}, transform: [{translate: [0.5, 0.5, 0]}], medium: dense glass, priority: 3}
)"),
                 "objects[1].priority", {"ruby", "pearl"});
}

TEST(Refusals, ASheetInTheFaceOfASolidNamesBoth) {
    expect_names(refusal(R"(
  - {name: window, shape: {box: {size: 1}}, medium: glass}
  - {name: foil, shape: {rectangle: {size: 0.5}}, transform: [{translate: [0, 0, 0.5]}], sheet: {polarizer: {axis: [1, 0, 0]}}}
)"),
                 "objects[1].transform", {"window", "foil"});
}

// From inside, the nearest crossing of a body that is seen from outside only would lie behind the camera.
TEST(Refusals, ACameraInALampOrAnAbsorberNamesIt) {
    for (const std::string body :
         {"shape: {sphere: {radius: 50}}, emission: {radiance: 1, two_sided: on}",
          "shape: {box: {size: 50}}, emission: {radiance: 1}", "shape: {box: {size: 50}}, absorber: on"}) {
        const std::string scene = "  - {name: dome, " + body + "}\n";
        expect_names(refusal(scene, "{position: [0, 0, 3], target: [0, 0, 0], up: [0, 1, 0], fov: 30}"),
                     "camera.position", {"dome"});
        expect_names(
            refusal(scene, "{type: orthographic, position: [0, 0, 3], target: [0, 0, 0], up: [0, 1, 0], width: 1}"),
            "camera.position", {"dome"});
    }
}

TEST(Refusals, ACameraInACrystalNamesIt) {
    const std::string stone = "  - {name: stone, shape: {box: {size: 1}}, medium: calcite}\n";
    expect_names(refusal(stone, "{position: [0, 0, 0.1], target: [0, 0, 1], up: [0, 1, 0], fov: 30}"),
                 "camera.position", {"stone"});
    // Wholly inside, and so wide that only the pixels in the middle start in the stone.
    for (const std::string width : {"0.5", "10"})
        expect_names(refusal(stone,
                             "{type: orthographic, position: [0, 0, 0.1], target: [0, 0, 1], up: [0, 1, 0], "
                             "width: " +
                                 width + "}"),
                     "camera.position", {"stone"});
    expect_names(refusal("  - {name: drop, shape: {sphere: {radius: 1}}, medium: gold}\n",
                         "{type: orthographic, position: [0, 0, 0.1], target: [0, 0, 1], up: [0, 1, 0], width: 1}"),
                 "camera.position", {"drop"});
}

// The plane of the picture may run through a crystal's neighborhood, and a camera may stand in glass.
TEST(Refusals, AnOrthographicCameraBesideACrystalIsNone) {
    for (const std::string object :
         {"{name: stone, shape: {sphere: {radius: 1}}, transform: [{translate: [2, 0, 0]}], medium: calcite}",
          "{name: block, shape: {box: {size: 9}}, medium: glass}"}) {
        const auto plan = compile(test::scene_of(
            "camera: {type: orthographic, position: [0, 0, 0], target: [0, 0, -1], up: [0, 1, 0], width: 1.5}\n"
            "media: {glass: 1.5, calcite: {crystal: calcite}}\nobjects:\n  - " +
            object + "\n"));
        EXPECT_TRUE(plan) << to_string(plan.error());
    }
}

TEST(Refusals, EqualSolidsOfTwoMediaNeedAPriority) {
    for (const std::string shape : {"{sphere: {radius: 1}}", "{box: {size: 1}}", "{brilliant: {diameter: 2}}"})
        expect_names(refusal("  - {name: ruby, shape: " + shape +
                             ", medium: glass}\n  - {name: pearl, shape: " + shape + ", medium: dense glass}\n"),
                     "objects[1].priority", {"ruby", "pearl"});
}

// The first one listed would win, or the one that rounding puts nearer.
TEST(Refusals, TwoSurfacesInOnePlaneNameBoth) {
    const std::string lamp = "  - {name: lamp, shape: {rectangle: {size: 1}}, emission: {radiance: 1}}\n";
    for (const std::string other :
         {"shape: {rectangle: {size: 1}}, transform: [{translate: [0.9, 0, 0]}], emission: {radiance: 2}",
          "shape: {rectangle: {size: 1}}, transform: [{rotate: {axis: [1, 0, 0], angle: 180}}], emission: {radiance: "
          "2}",
          "shape: {disk: {radius: 0.5}}, transform: [{translate: [0.9, 0, 0]}], absorber: on",
          "shape: {box: {size: 1}}, transform: [{translate: [0, 0, -0.5]}], absorber: on",
          "shape: {disk: {radius: 0.5}}, sheet: {polarizer: {axis: [1, 0, 0]}}"})
        expect_names(refusal(lamp + "  - {name: other, " + other + "}\n"), "objects[1].transform", {"lamp", "other"});
    expect_names(refusal("  - {name: lamp, shape: {sphere: {radius: 1}}, emission: {radiance: 1}}\n"
                         "  - {name: other, shape: {sphere: {radius: 1}}, absorber: on}\n"),
                 "objects[1].transform", {"lamp", "other"});
}

TEST(Refusals, SurfacesSideBySideOrBothBlackAreNoQuestion) {
    for (const std::string objects :
         {"  - {name: a, shape: {rectangle: {size: 1}}, emission: {radiance: 1}}\n"
          "  - {name: b, shape: {rectangle: {size: 1}}, transform: [{translate: [1, 0, 0]}], emission: {radiance: "
          "2}}\n",
          "  - {name: a, shape: {disk: {radius: 1}}, emission: {radiance: 1}}\n"
          "  - {name: b, shape: {disk: {radius: 1}}, transform: [{translate: [2, 0, 0]}], emission: {radiance: 2}}\n",
          "  - {name: a, shape: {rectangle: {size: 1}}, absorber: on}\n"
          "  - {name: b, shape: {box: {size: 1}}, transform: [{translate: [0, 0, 0.5]}], absorber: on}\n"}) {
        const auto plan =
            compile(test::scene_of("camera: {position: [0, -4, 2], target: [0, 0, 0], fov: 30}\nobjects:\n" + objects));
        EXPECT_TRUE(plan) << to_string(plan.error());
    }
}

TEST(Refusals, ASheetThatCoversAPartOfAFaceNamesBoth) {
    expect_names(refusal(R"(
  - {name: window, shape: {box: {size: 1}}, medium: glass}
  - {name: foil, shape: {rectangle: {size: 1}}, transform: [{translate: [0.9, 0, 0.5]}], sheet: {polarizer: {axis: [1, 0, 0]}}}
)"),
                 "objects[1].transform", {"window", "foil"});
}

TEST(Refusals, AnAxisAlongTheLightOfALampNamesTheLamp) {
    expect_names(refusal("  - {name: lamp, shape: {disk: {radius: 1}}, "
                         "emission: {radiance: 1, polarization: {dop: 1, azimuth: 0, x_axis: [0, 0, 2]}}}\n"),
                 "objects[0].emission.polarization.x_axis", {"lamp"});
}

TEST(Refusals, ABlackFaceThatNoFaceIsNamesTheNearest) {
    const Error error = refusal(
        "  - {name: stone, shape: {prism: {apex_angle: 60, side: 1, height: 1}}, medium: glass, "
        "black: [[0, -1, 0], [1, 0, 0]]}\n");
    expect_names(error, "objects[0].black", {"[1, 0, 0]"});
    EXPECT_NE(error.hint.find("[0.866025, 0.5, 0]"), std::string::npos) << error.hint;
    expect_names(refusal("  - {name: ball, shape: {sphere: {radius: 1}}, medium: glass, black: [[1, 0, 0]]}\n"),
                 "objects[0].black", {"sphere"});
}

// The check of values refuses it as well; a scene made by a program may come without one.
TEST(Refusals, ACrystalIsNoAmbientMedium) {
    Scene scene = test::shipped_scene("cube-calcite");
    scene.ambient = "calcite";
    const auto plan = compile(scene);
    ASSERT_FALSE(plan);
    EXPECT_EQ(plan.error().kind, ErrorKind::input);
    EXPECT_EQ(plan.error().field, "ambient");
}

// Modes of a crystal fix the field of the light in it; a lamp in it cannot choose.
TEST(Refusals, APolarizedLampInsideACrystalNamesTheLamp) {
    expect_names(refusal(R"(
  - {name: stone, shape: {box: {size: 2}}, medium: calcite}
  - {name: spark, shape: {sphere: {radius: 0.1}}, emission: {radiance: 1, polarization: {dop: 1, azimuth: 0}}}
)"),
                 "objects[1].emission.polarization", {"spark"});
}

TEST(Refusals, AClosedSheetNamesItsShape) {
    expect_names(refusal("  - {name: foil, shape: {sphere: {radius: 1}}, sheet: {polarizer: {axis: [1, 0, 0]}}}\n"),
                 "objects[0].shape", {"foil", "closed"});
}

TEST(Refusals, ThousandsOfOverlapsNameASolid) {
    std::string objects;
    for (int i = 0; i < 60; ++i)
        objects += "  - {name: plate " + std::to_string(i) + ", shape: {box: {size: 1}}, transform: [{translate: [" +
                   std::to_string(0.01 * i) + ", 0, 0]}], medium: glass, priority: " + std::to_string(i) + "}\n";
    expect_names(refusal(objects), "objects[", {"plate", "overlaps", "4096"});
}

}  // namespace
}  // namespace pol
