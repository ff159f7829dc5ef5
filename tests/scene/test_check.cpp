// SPDX-License-Identifier: Apache-2.0
// Scenes that a program made or edited; those from files are in tests/io/test_scene_errors.cpp.
#include "scene/check.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "geometry/shapes.h"

namespace pol {
namespace {

Scene glass_box() {
    Scene scene;
    scene.camera.position = {0.0, -5.0, 2.0};
    scene.camera.target = {0.0, 0.0, 0.0};
    scene.camera.up = {0.0, 0.0, 1.0};
    scene.camera.horizontal_fov = 0.5;
    scene.media.push_back({"glass", IsotropicMedium{ConstantIndex{{1.5, 0.0}}, ConstantSpectrum{0.0}}, {}});
    Object box;
    box.name = "box";
    box.shape = BoxShape{};
    box.role = FilledWith{"glass"};
    scene.objects.push_back(box);
    return scene;
}

struct BadEdit {
    const char* field;
    std::function<void(Scene&)> edit;
};

TEST(SceneCheck, AcceptsAGlassBox) {
    EXPECT_FALSE(first_problem(glass_box()));
}

TEST(SceneCheck, NamesTheFieldThatAnEditBroke) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    const std::vector<BadEdit> edits{
        {"camera.position", [](Scene& s) { s.camera.position.y = nan; }},
        {"camera.target", [](Scene& s) { s.camera.target = s.camera.position; }},
        {"camera.up",
         [](Scene& s) {
             s.camera.up = {0.0, 5.0, -2.0};
         }},
        {"camera.fov", [](Scene& s) { s.camera.horizontal_fov = nan; }},
        {"camera.width", [](Scene& s) { s.camera.projection = Projection::orthographic; }},
        {"unit", [](Scene& s) { s.unit_nm = 0.0; }},
        {"background", [](Scene& s) { s.background.radiance = ConstantSpectrum{nan}; }},
        {"background",
         [](Scene& s) {
             s.background.radiance = TabulatedSpectrum{{400.0, 500.0}, {1.0}};
         }},
        {"render.wavelengths", [](Scene& s) { s.render.wavelengths_nm.clear(); }},
        {"render.wavelengths",
         [](Scene& s) {
             s.render.wavelengths_nm = {580.0, 580.0};
         }},
        {"render.size", [](Scene& s) { s.render.height = -1; }},
        {"render.residual", [](Scene& s) { s.render.residual = double(nan); }},
        {"media.glass.index",
         [](Scene& s) {
             std::get<IsotropicMedium>(s.media[0].matter).index = ConstantIndex{{nan, 0.0}};
         }},
        {"media.glass", [](Scene& s) { s.media.push_back(s.media[0]); }},
        {"objects[0].medium", [](Scene& s) { s.objects[0].role = FilledWith{"air"}; }},
        {"objects[1].name", [](Scene& s) { s.objects.push_back(s.objects[0]); }},
        {"objects[0].name", [](Scene& s) { s.objects[0].name.clear(); }},
        {"objects[0].black",
         [](Scene& s) {
             s.objects[0].role = FilledWith{"glass", {DVec3(0.0)}};
         }},
        // Only media are ranked: an absorber, a lamp and a sheet are where they are.
        {"objects[0].priority",
         [](Scene& s) {
             s.objects[0].role = Absorber{};
             s.objects[0].priority = 0;
         }},
        {"objects[0].priority",
         [](Scene& s) {
             s.objects[0].role = Emission{};
             s.objects[0].priority = 2;
         }},
        {"objects[0].transform", [](Scene& s) { s.objects[0].to_world[2][2] = inf; }},
        {"objects[0].transform", [](Scene& s) { s.objects[0].to_world[0][3] = 0.1; }},
        {"objects[0].transform", [](Scene& s) { s.objects[0].to_world[1] = s.objects[0].to_world[0]; }},
        {"objects[0].shape.mesh.file",
         [](Scene& s) {
             s.objects[0].shape = MeshShape{"none.ply", nullptr};
         }},
    };
    for (const BadEdit& bad : edits) {
        Scene scene = glass_box();
        bad.edit(scene);
        const std::optional<Error> problem = first_problem(scene);
        ASSERT_TRUE(problem) << bad.field;
        EXPECT_EQ(problem->field, bad.field) << to_string(*problem);
        EXPECT_EQ(problem->kind, ErrorKind::input);
        EXPECT_FALSE(problem->hint.empty());
    }
}

TEST(SceneCheck, AFilledMeshMustBeClosed) {
    Scene scene = glass_box();
    Mesh mesh = make_mesh(BoxShape{}).value();
    scene.objects[0].shape = MeshShape{"box.ply", std::make_shared<const Mesh>(mesh)};
    EXPECT_FALSE(first_problem(scene));
    mesh.triangles.pop_back();
    mesh.facet_of_triangle.pop_back();
    scene.objects[0].shape = MeshShape{"box.ply", std::make_shared<const Mesh>(mesh)};
    const std::optional<Error> problem = first_problem(scene);
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->field, "objects[0].shape.mesh.file");
    scene.objects[0].role = Absorber{};
    EXPECT_FALSE(first_problem(scene)) << "a screen may have holes";
}

TEST(SceneCheck, OnlyMediaInUseMustCoverTheWavelengths) {
    Scene scene = glass_box();
    DispersiveIndex narrow{"narrow", IndexTable{{400.0, 500.0}, {1.6, 1.5}}, {}};
    scene.media.push_back({"narrow", IsotropicMedium{narrow, ConstantSpectrum{0.0}}, {}});
    EXPECT_FALSE(first_problem(scene));
    scene.ambient = "narrow";
    const std::optional<Error> problem = first_problem(scene);
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->field, "media.narrow.index");
    scene.render.wavelengths_nm = {450.0};
    EXPECT_FALSE(first_problem(scene));
}

TEST(SceneCheck, AnExtinctionThatIsNotKnownIsSaidOnce) {
    Scene scene = glass_box();
    scene.render.wavelengths_nm = {450.0, 550.0, 650.0};
    EXPECT_TRUE(unknown_extinctions(scene).empty());
    const DispersiveIndex film{"film", IndexTable{{400.0, 700.0}, {1.6, 1.5}}, IndexTable{{600.0, 700.0}, {0.0, 0.0}}};
    scene.media.push_back({"film", IsotropicMedium{film, ConstantSpectrum{0.0}}, {}});
    scene.media.push_back({"pair", UniaxialMedium{film, film}, {}});
    EXPECT_TRUE(unknown_extinctions(scene).empty()) << "not in use";
    scene.objects[0].role = FilledWith{"pair"};
    scene.ambient = "film";
    EXPECT_EQ(unknown_extinctions(scene),
              std::vector<std::string>{
                  "k of 'film' is not known at 2 of 3 wavelengths, the first of them 450 nm: 0 is used"});
    scene.render.wavelengths_nm = {550.0};
    EXPECT_EQ(unknown_extinctions(scene), std::vector<std::string>{"k of 'film' is not known at 550 nm: 0 is used"});
}

}  // namespace
}  // namespace pol
