// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "support/render_scene.h"
#include "viewer/session/session.h"
#include "viewer/shown/polarimeter.h"
#include "viewer/shown/view_transform.h"
#include "viewer/viewer_files.h"

namespace pol {
namespace {

// Malus: a polarizer at theta passes cos^2 theta of light that is linear along x (T13).
TEST(Polarimeter, APolarizerPassesCosineSquaredOfLinearLight) {
    for (int degree = 0; degree <= 180; degree += 15) {
        const double theta = degree * 3.141592653589793 / 180.0;
        Polarimeter polarimeter;
        polarimeter.elements.push_back({PolarimeterElementKind::polarizer, true, theta, 0.0});
        const Stokes<double> out = polarimeter.mueller() * Stokes<double>{1.0, 1.0, 0.0, 0.0};
        EXPECT_NEAR(out.s0, std::pow(std::cos(theta), 2), 4e-16) << degree;
    }
}

TEST(ViewTransform, ThePointUnderTheCursorStaysWhileZooming) {
    ViewTransform view{3.0, {10.0, -20.0}};
    const DVec2 cursor(200.0, 150.0);
    const DVec2 before = view.picture_from_view(cursor);
    view.zoom_at(cursor, 1.7);
    const DVec2 after = view.picture_from_view(cursor);
    EXPECT_NEAR(before.x, after.x, 1e-12);
    EXPECT_NEAR(before.y, after.y, 1e-12);
}

/// An empty scene rendered at these wavelengths.
Scene scene_at(const std::string& wavelengths) {
    return test::scene_of(
        "camera: {position: [0, 0, 5], target: [0, 0, 0], fov: 30, up: [0, 1, 0]}\n"
        "render: {size: [2, 2], wavelengths: " +
        wavelengths + "}\nbackground: 1\nobjects: []\n");
}

double shown_nm(const Session& session) {
    return *session.current()->picture().bands[session.view().band].wavelength_nm;
}

TEST(Session, OpensASpectralPictureAtThePlaneNearestTo580AsTheCommandLineDoes) {
    Session session;
    ASSERT_TRUE(session.open_scene(scene_at("380:780:20"), "spectral"));
    EXPECT_EQ(shown_nm(session), 580.0);
    session.update();
    EXPECT_EQ(shown_nm(session), 580.0);
}

TEST(Session, KeepsTheWavelengthAndNotItsNumberWhenAnotherPictureIsShown) {
    Session session;
    ASSERT_TRUE(session.open_scene(scene_at("380:780:20"), "spectral"));
    ASSERT_TRUE(session.open_scene(scene_at("[450, 550, 650]"), "three"));
    EXPECT_EQ(shown_nm(session), 550.0) << "nearest to 580";
    session.step_document(-1);
    EXPECT_EQ(shown_nm(session), 580.0) << "550 was not chosen";
    session.step_document(1);
    session.change_view().band = 2;
    session.update();
    EXPECT_EQ(shown_nm(session), 650.0);
    session.step_document(-1);
    EXPECT_EQ(shown_nm(session), 640.0) << "the first of two that are equally near to 650";
    session.close_document();
    session.update();
    EXPECT_EQ(shown_nm(session), 650.0);
    // An edit of the list counts the planes anew.
    ASSERT_TRUE(session.current()->edit(scene_at("[450, 500, 550, 600, 650]"), "wavelengths"));
    session.update();
    EXPECT_EQ(shown_nm(session), 650.0);
}

TEST(Session, AsksBeforeAFileIsWrittenAnew) {
    const test::WorkingFolder folder;
    const std::string source = test::plate_scene(4, 4, "\n    # mine\n    {index: [1.5, # n\n      0.0]}");
    test::write_text("plate.yaml", source);
    Session session;
    ASSERT_TRUE(session.open("plate.yaml"));
    Scene scene = session.current()->scene();
    scene.media[0].matter = ConductorMedium{ConstantIndex{{0.2, 3.0}}};
    ASSERT_TRUE(session.current()->edit(std::move(scene), "metal"));
    EXPECT_FALSE(session.save(session.current()->path()));
    EXPECT_EQ(session.window().question, Question::rewrite);
    EXPECT_TRUE(session.window().modal());
    EXPECT_TRUE(session.save(session.current()->path(), Document::Rewrite::keep_backup));
    EXPECT_EQ(session.window().question, Question::none);
    EXPECT_EQ(std::filesystem::file_size("plate.yaml.bak"), source.size());
}

TEST(Session, LooksForWhatShipsWithTheProgramAtItsFirstFrameAndWheneverAFileIsOpened) {
    const test::WorkingFolder folder;
    const std::filesystem::path records = folder / "refractive_index";
    std::filesystem::create_directory(records);
    test::write_text(records / "water.yml", "");
    test::write_text(records / "notes.txt", "");
    test::write_text("plate.yaml", test::plate_scene(4, 4));
    const char* chosen = std::getenv("POLARISCOPE_ASSETS");
    const std::string before = chosen == nullptr ? "" : chosen;
    ASSERT_EQ(::setenv("POLARISCOPE_ASSETS", (folder / ".").c_str(), 1), 0);
    Session session;
    EXPECT_TRUE(session.shipped_files().index_records.empty());
    session.update();
    EXPECT_EQ(session.shipped_files().index_records, std::vector<std::string>{"water"});
    EXPECT_TRUE(session.shipped_files().scenes.empty()) << "no such folder";
    test::write_text(records / "ice.yml", "");
    session.update();
    EXPECT_EQ(session.shipped_files().index_records.size(), 1U) << "not in every frame";
    ASSERT_TRUE(session.open("plate.yaml"));
    EXPECT_EQ(session.shipped_files().index_records, (std::vector<std::string>{"ice", "water"}));
    ::setenv("POLARISCOPE_ASSETS", before.c_str(), 1);  // empty is as if it were not set
}

TEST(Session, ATwinIsNotEditedAndIsShownOnce) {
    const test::TemporaryFolder folder;
    test::write_text(folder / "plate.yaml", test::plate_scene(4, 4));
    Session session;
    ASSERT_TRUE(session.open(folder / "plate.yaml"));
    ASSERT_TRUE(session.open_unpolarized_twin());
    const Document* twin = session.current();
    EXPECT_FALSE(twin->dirty());
    EXPECT_FALSE(session.has_unsaved_edits());
    session.step_document(1);
    ASSERT_TRUE(session.open_unpolarized_twin());
    EXPECT_EQ(session.documents().size(), 2U);
    EXPECT_EQ(session.current(), twin);
    EXPECT_TRUE(session.comparison());
    // An edited twin is another scene, and so is the twin of an edited scene.
    Scene scene = twin->scene();
    scene.camera.horizontal_fov *= 0.5;
    ASSERT_TRUE(session.current()->edit(std::move(scene), "fov"));
    EXPECT_TRUE(session.has_unsaved_edits());
    session.step_document(1);
    ASSERT_TRUE(session.open_unpolarized_twin());
    EXPECT_EQ(session.documents().size(), 3U);
    session.step_document(1);
    scene = session.current()->scene();
    scene.render.wavelengths_nm = {550.0};
    ASSERT_TRUE(session.current()->edit(std::move(scene), "wavelengths"));
    ASSERT_TRUE(session.open_unpolarized_twin());
    EXPECT_EQ(session.documents().size(), 4U);
}

}  // namespace
}  // namespace pol
