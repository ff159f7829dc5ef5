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
media: {glass: 1.5, dense glass: 1.7, calcite: {crystal: calcite}}
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

TEST(Refusals, ACameraInACrystalNamesIt) {
    expect_names(refusal("  - {name: stone, shape: {box: {size: 1}}, medium: calcite}\n",
                         "{position: [0, 0, 0.1], target: [0, 0, 1], up: [0, 1, 0], fov: 30}"),
                 "camera.position", {"stone"});
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
