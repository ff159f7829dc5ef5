// SPDX-License-Identifier: Apache-2.0
// The mouse in the picture, and what stands under it.
#include <gtest/gtest.h>

#include "core/units.h"
#include "known_picture.h"
#include "maps/evaluate.h"
#include "plan/camera_model.h"
#include "viewer/pages/pixel_page.h"
#include "viewer/pages/readout_text.h"
#include "viewer/panels/color_bar.h"
#include "viewer/panels/hover_readout.h"
#include "viewer/session/map_look.h"
#include "viewer/space/camera_moves.h"
#include "viewer/viewer_files.h"
#include "viewer/widgets/ink.h"
#include "window_without_gl.h"

namespace pol {
namespace {

class PicturePanelTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(open_picture(window.session, known_picture()));
        window.draw();
    }
    WindowWithoutGl window;
};

TEST_F(PicturePanelTest, OpensFittedAndCentered) {
    const DVec2 view = window.frame.viewport.size;
    const double scale = window.session.transform().scale;
    EXPECT_NEAR(scale, std::min(view.x / 16.0, view.y / 12.0), 1e-9);
    EXPECT_NEAR(window.session.transform().view_from_picture({8.0, 6.0}).x, 0.5 * view.x, 1.0);
    EXPECT_GT(view.x, 550.0);
    EXPECT_GT(view.y, 550.0);
}

TEST_F(PicturePanelTest, AClickPinsThePixelUnderTheCursor) {
    window.click(window.place_of({3, 7}));
    ASSERT_TRUE(window.session.selection().pinned());
    EXPECT_EQ(*window.session.selection().pinned(), (PixelAddress{3, 7}));
}

TEST_F(PicturePanelTest, ADragPansAndDoesNotPin) {
    const DVec2 from = window.place_of({3, 7});
    const DVec2 before = window.session.transform().offset;
    window.drag(from, from + DVec2(40.0, -25.0));
    EXPECT_FALSE(window.session.selection().pinned());
    EXPECT_NEAR(window.session.transform().offset.x - before.x, 40.0, 1e-6);
    EXPECT_NEAR(window.session.transform().offset.y - before.y, -25.0, 1e-6);
    window.move(from + DVec2(40.0, -25.0));
    EXPECT_EQ(window.session.selection().hovered, (PixelAddress{3, 7})) << "the pixel went with the cursor";
}

TEST_F(PicturePanelTest, TheWheelZoomsAtTheCursor) {
    const DVec2 at = glm::floor(window.place_of({3, 7}));
    window.move(at);
    const ViewTransform before = window.session.transform();
    window.turn_wheel(2.0F);
    const ViewTransform& after = window.session.transform();
    EXPECT_NEAR(after.scale / before.scale, 1.44, 1e-6);
    const DVec2 cursor = at - window.frame.viewport.origin;
    EXPECT_NEAR(after.picture_from_view(cursor).x, before.picture_from_view(cursor).x, 1e-9);
    EXPECT_NEAR(after.picture_from_view(cursor).y, before.picture_from_view(cursor).y, 1e-9);
}

/// Whether the frame has a stroke in the color of pins there.
bool has_pin_at(const DVec2& at) {
    const ImDrawData& drawn = *ImGui::GetDrawData();
    for (int i = 0; i < drawn.CmdListsCount; ++i)
        for (const ImDrawVert& vertex : drawn.CmdLists[i]->VtxBuffer)
            if (vertex.col == pin_ink && std::hypot(vertex.pos.x - at.x, vertex.pos.y - at.y) < 40.0) return true;
    return false;
}

TEST_F(PicturePanelTest, WhatIsDrawnOverThePictureMovesWithItInTheSameFrame) {
    window.session.pin({1, 1});
    window.move(window.place_of({15, 11}));
    const DVec2 before = window.place_of({1, 1});
    ASSERT_TRUE(has_pin_at(before));
    test::turn_wheel(-3.0F);
    window.draw(1);
    const DVec2 after = window.place_of({1, 1});
    ASSERT_GT(glm::length(after - before), 100.0);
    EXPECT_TRUE(has_pin_at(after));
    EXPECT_FALSE(has_pin_at(before));
}

TEST_F(PicturePanelTest, ShiftAndDragDrawsARegion) {
    test::hold_shift(true);
    const DVec2 before = window.session.transform().offset;
    window.drag(window.place_of({6, 8}), window.place_of({2, 3}));
    const auto& region = window.session.selection().region;
    ASSERT_TRUE(region);
    EXPECT_EQ(region->x0, 2);
    EXPECT_EQ(region->y0, 3);
    EXPECT_EQ(region->x1, 7);
    EXPECT_EQ(region->y1, 9);
    EXPECT_EQ(window.session.transform().offset, before);
    window.click(window.place_of({1, 1}));
    EXPECT_FALSE(region) << "Shift and click takes it away";
    EXPECT_FALSE(window.session.selection().pinned());
}

TEST_F(PicturePanelTest, HoverSaysWhatEvaluateSays) {
    const StokesImage& picture = window.session.current()->picture();
    for (const QuantityInfo& about : quantities()) {
        if (about.quantity == Quantity::color) continue;
        window.session.show(about.quantity);
        for (const PixelAddress at : {PixelAddress{3, 7}, PixelAddress{9, 0}, PixelAddress{15, 11}}) {
            window.move(window.place_of(at));
            EXPECT_EQ(window.session.selection().hovered, at);
            const std::string text = window.text_of([&] { draw_hover_readout(window.session); });
            const auto map = evaluate(picture, about.quantity, 0);
            const MapPixel& value = map.value().pixels[picture.pixel(at.x, at.y)];
            const std::string title = std::string(about.title) + " ";
            const std::size_t place = text.find(title);
            ASSERT_NE(place, std::string::npos) << text;
            const std::string shown = text.substr(place + title.size());
            if (value.state == PixelState::defined) {
                // Digits end where a bar begins; the least of these bars is 0.01, none is wider than half a range.
                const double size = about.kind == ScaleKind::cyclic ? 90.0 : 1.0;
                EXPECT_NEAR(std::stod(shown), value.value, 0.05 * size) << text;
            } else {
                EXPECT_EQ(shown.find(state_text(value.state)), 0u) << text;
            }
            EXPECT_NE(text.find("x " + std::to_string(at.x) + "  y " + std::to_string(at.y)), std::string::npos);
            const double s3 = picture.at(0, picture.pixel(at.x, at.y)).s3;
            const std::size_t of_s3 = text.rfind("S3 ");
            ASSERT_NE(of_s3, std::string::npos);
            EXPECT_NEAR(std::stod(text.substr(of_s3 + 3)), s3, 5e-4) << "1 % is missing: digits down to 1e-3";
        }
    }
}

TEST_F(PicturePanelTest, HoverIsLabeledInTheShownConvention) {
    window.move(window.place_of({9, 11}));
    const double s3 = window.session.current()->picture().at(0, window.session.current()->picture().pixel(9, 11)).s3;
    const auto hover = [&] { return window.text_of([&] { draw_hover_readout(window.session); }); };
    const auto s3_in = [](const std::string& text) { return std::stod(text.substr(text.rfind("S3 ") + 3)); };
    EXPECT_EQ(hover().find("receiver"), std::string::npos) << "the usual one is not named";
    window.session.change_view().convention.positive_s3 = PositiveS3::left;
    std::string text = hover();
    EXPECT_NE(text.find("receiver's view, S3 > 0 left"), std::string::npos) << text;
    EXPECT_NEAR(s3_in(text.substr(0, text.find("receiver"))), -s3, 5e-4) << text;
    window.session.change_view().convention.viewpoint = Viewpoint::source;
    text = hover();
    EXPECT_NEAR(s3_in(text.substr(0, text.find("source"))), s3, 5e-4) << text;
    window.session.set_page({FrameChoice::own_angle});
    EXPECT_NE(hover().find("camera frame"), std::string::npos) << "the inspector has another one";
}

// What +1 is called stands at the end of the bar, and the title says whose words these are.
TEST_F(PicturePanelTest, TheColorBarNamesTheSignsOfTheShownConvention) {
    ColorBar bar;
    for (const Quantity quantity : {Quantity::s3, Quantity::handedness}) {
        window.session.show(quantity);
        EXPECT_EQ(map_options(window.session).words.high, "right");
        EXPECT_EQ(window.text_of([&] { bar.draw(window.session, window.wishes, 300.0F); }).find("view"),
                  std::string::npos);
        window.session.change_view().convention.viewpoint = Viewpoint::source;
        EXPECT_EQ(map_options(window.session).words.high, "right") << "of the opposite light";
        window.session.change_view().convention.positive_s3 = PositiveS3::left;
        EXPECT_EQ(map_options(window.session).words.high, "left");
        const std::string text = window.text_of([&] { bar.draw(window.session, window.wishes, 300.0F); });
        EXPECT_NE(text.find("source's view, S3 > 0 left"), std::string::npos) << text;
        window.session.change_view().convention = {};
    }
    window.session.change_view().convention.viewpoint = Viewpoint::source;
    window.session.show(Quantity::dop);
    EXPECT_EQ(window.text_of([&] { bar.draw(window.session, window.wishes, 300.0F); }).find("source"),
              std::string::npos);
}

// x is right for who looks: from behind the picture it points to its left.
TEST_F(PicturePanelTest, TheAxesAtThePinAreThoseOfTheShownFrameAndConvention) {
    window.session.pin({3, 7});
    window.session.set_page({FrameChoice::own_angle, radians(30.0)});
    for (const Viewpoint viewpoint : {Viewpoint::receiver, Viewpoint::source}) {
        window.session.change_view().convention.viewpoint = viewpoint;
        const PageAxes axes = page_axes(window.session);
        const double right = viewpoint == Viewpoint::receiver ? 1.0 : -1.0;
        EXPECT_NEAR(axes.x.x, right * std::cos(radians(30.0)), 1e-15);
        EXPECT_NEAR(axes.x.y, -right * 0.5, 1e-15) << "up on screen is negative y";
        EXPECT_NEAR(axes.y.x, -0.5, 1e-15);
        EXPECT_NEAR(axes.y.y, -std::cos(radians(30.0)), 1e-15);
        // Light along the x axis, as the page writes it, lies along the arrow.
        const double psi = make_pixel_page(window.session).measures.azimuth;
        const DVec2 along = std::cos(psi) * axes.x + std::sin(psi) * axes.y;
        const double on_picture =
            measure(window.session.current()->picture().at(0, window.session.current()->picture().pixel(3, 7))).azimuth;
        EXPECT_NEAR(std::abs(along.x * std::cos(on_picture) - along.y * std::sin(on_picture)), 1.0, 1e-12);
    }
}

TEST_F(PicturePanelTest, HoverCountsThePixelsOfTheWholePicture) {
    StokesImage part = known_picture();
    part.left = 60;
    part.top = 40;
    ASSERT_NO_FATAL_FAILURE(open_picture(window.session, part));
    window.draw();
    window.move(window.place_of({3, 2}));
    const std::string text = window.text_of([&] { draw_hover_readout(window.session); });
    EXPECT_NE(text.find("x 63  y 42"), std::string::npos) << text;
}

TEST_F(PicturePanelTest, TheLegendCountsPixelsWithoutAValue) {
    window.session.show(Quantity::azimuth);
    window.session.finish_shown_map();
    ColorBar bar;
    const std::string text = window.text_of([&] { bar.draw(window.session, window.wishes, 300.0F); });
    EXPECT_NE(text.find("undefined 8.3 %"), std::string::npos) << "the top row of 12 is unpolarized\n" << text;
    EXPECT_NE(text.find("Azimuth, 500 nm"), std::string::npos) << text;
}

TEST_F(PicturePanelTest, TheEndsOfTheColorBarCanBeDraggedAndGivenBack) {
    window.session.show(Quantity::dop);
    window.draw();
    const double bar_width = window.frame.viewport.size.x - 12.0;
    const double y = window.frame.viewport.origin.y + window.frame.viewport.size.y + 6.0 +
                     ImGui::GetTextLineHeightWithSpacing() + 6.0;
    const double left = window.frame.viewport.origin.x + 6.0;
    window.drag({left + 0.95 * bar_width, y}, {left + 0.7 * bar_width, y});
    EXPECT_NEAR(map_look(window.session).range.high, 0.75, 0.01);
    EXPECT_EQ(map_look(window.session).range.low, 0.0);
    window.move({left + 0.5 * bar_width, y});
    for (int i = 0; i < 2; ++i) {
        test::hold_button(0, true);
        window.draw(1);
        test::hold_button(0, false);
        window.draw(1);
    }
    EXPECT_EQ(map_look(window.session).range.high, 1.0);
}

TEST_F(PicturePanelTest, FollowsTheWindowWhileFitted) {
    ImGui::GetIO().DisplaySize = {1000.0F, 600.0F};
    window.draw();
    const DVec2 view = window.frame.viewport.size;
    EXPECT_NEAR(window.session.transform().scale, std::min(view.x / 16.0, view.y / 12.0), 1e-9);
    window.move(window.place_of({3, 7}));
    window.turn_wheel(1.0F);
    const double zoomed = window.session.transform().scale;
    ImGui::GetIO().DisplaySize = {1280.0F, 800.0F};
    window.draw();
    EXPECT_EQ(window.session.transform().scale, zoomed) << "the user's zoom stays";
}

class CameraDragTest : public testing::Test {
protected:
    void SetUp() override {
        test::write_text(folder / "plate.yaml", test::plate_scene(16, 12));
        ASSERT_TRUE(window.session.open(folder / "plate.yaml"));
        window.draw();
        from = window.frame.viewport.origin + 0.5 * window.frame.viewport.size;
        before = camera();
    }
    [[nodiscard]] const Camera& camera() const { return window.session.current()->scene().camera; }
    static double distance(const Camera& camera) { return glm::length(camera.position - camera.target); }
    /// The last edit was one step, and the only one.
    void expect_one_step(const std::string& label) {
        const EditHistory& history = window.session.current()->history();
        ASSERT_TRUE(history.can_undo());
        EXPECT_EQ(history.undo_label(), label);
        window.session.undo();
        EXPECT_FALSE(history.can_undo());
        EXPECT_EQ(camera().position, before.position);
        EXPECT_EQ(camera().target, before.target);
    }

    test::TemporaryFolder folder;
    WindowWithoutGl window;
    DVec2 from{};
    Camera before;
};

TEST_F(CameraDragTest, AltAndDragOrbitsInOneStep) {
    test::hold_alt(true);
    const DVec2 offset = window.session.transform().offset;
    window.drag(from, from + DVec2(100.0, 0.0));
    EXPECT_EQ(window.session.transform().offset, offset) << "the picture stays where it is";
    EXPECT_FALSE(window.session.selection().pinned());
    EXPECT_EQ(camera().target, before.target);
    EXPECT_NEAR(distance(camera()), distance(before), 1e-12);
    const double turned = dot(before.position, camera().position) / std::pow(distance(before), 2);
    EXPECT_NEAR(degrees(std::acos(turned)), 30.0, 1e-6) << "half a turn per 600 points, about up";
    EXPECT_LT(camera().position.x, before.position.x) << "what is in front goes with the mouse, to the right";
    expect_one_step("camera orbit");
}

TEST_F(CameraDragTest, DragsAreStepsOfTheirOwn) {
    test::hold_alt(true);
    window.drag(from, from + DVec2(100.0, 0.0));
    const DVec3 first = camera().position;
    window.drag(from, from + DVec2(0.0, 40.0));
    EXPECT_GT(camera().position.y, 0.1) << "dragging down looks from above";
    window.session.undo();
    EXPECT_EQ(camera().position, first);
    expect_one_step("camera orbit");
}

TEST_F(CameraDragTest, AnOrbitStopsBeforeThePole) {
    test::hold_alt(true);
    window.drag(from, from + DVec2(0.0, 350.0));
    EXPECT_NEAR(camera().position.y / distance(before), std::sin(radians(89.0)), 1e-9);
    EXPECT_NEAR(distance(camera()), distance(before), 1e-12);
}

TEST_F(CameraDragTest, AltShiftAndDragKeepsTheTargetsPlaneUnderTheCursor) {
    test::hold_alt(true);
    test::hold_shift(true);
    const DVec2 moved(60.0, -36.0);
    window.drag(from, from + moved);
    EXPECT_FALSE(window.session.selection().region);
    EXPECT_NEAR(glm::length((camera().position - camera().target) - (before.position - before.target)), 0.0, 1e-12);
    // The old target is now seen through the point to which it was dragged.
    const DVec2 pixel = DVec2(8.0, 6.0) + moved / window.session.transform().scale;
    const CameraRay ray = CameraModel(camera(), 16, 12).ray(pixel.x, pixel.y);
    EXPECT_NEAR(glm::length(cross(before.target - ray.origin, ray.direction)), 0.0, 1e-9);
    expect_one_step("camera pan");
}

TEST_F(CameraDragTest, AltAndWheelDolliesInOneStepUntilAltIsLetGo) {
    window.move(from);
    test::hold_alt(true);
    const double scale = window.session.transform().scale;
    window.turn_wheel(1.0F);
    window.turn_wheel(1.0F);
    EXPECT_NEAR(distance(before) / distance(camera()), 1.44, 1e-9);
    EXPECT_EQ(window.session.transform().scale, scale);
    test::hold_alt(false);
    window.draw();
    const DVec3 first = camera().position;
    test::hold_alt(true);
    window.turn_wheel(-3.0F);
    window.session.undo();
    EXPECT_EQ(camera().position, first);
    expect_one_step("camera dolly");
}

TEST_F(CameraDragTest, WithoutAltTheViewMovesAndTheCameraStays) {
    const DVec2 offset = window.session.transform().offset;
    window.drag(from, from + DVec2(40.0, -25.0));
    EXPECT_NEAR(window.session.transform().offset.x - offset.x, 40.0, 1e-6);
    EXPECT_EQ(camera().position, before.position);
    EXPECT_FALSE(window.session.current()->history().can_undo());
}

TEST_F(PicturePanelTest, APictureHasNoCameraToMove) {
    test::hold_alt(true);
    const DVec2 from = window.place_of({3, 7});
    const DVec2 offset = window.session.transform().offset;
    window.drag(from, from + DVec2(40.0, 0.0));
    EXPECT_NEAR(window.session.transform().offset.x - offset.x, 40.0, 1e-6);
}

TEST(CameraMoves, AnOrthographicCameraDolliesByItsWidth) {
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.position = {0.0, 0.0, 4.0};
    camera.width = 3.0;
    const Camera nearer = dollied(camera, 1.5);
    EXPECT_EQ(nearer.width, 2.0);
    EXPECT_EQ(nearer.position, camera.position);
}

TEST(MapLook, TheBarOfThePhotographIsMovedByExposureAndOffset) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    session.show(Quantity::intensity);
    set_bar_range(session, {0.1, 0.6});
    EXPECT_NEAR(session.view().exposure, 1.0, 1e-12);
    EXPECT_NEAR(session.view().offset, -0.2, 1e-12);
    EXPECT_NEAR(bar_range(session).low, 0.1, 1e-12);
    EXPECT_NEAR(bar_range(session).high, 0.6, 1e-12);
    session.finish_shown_map();
    fit_bar_range(session);
    EXPECT_NEAR(bar_range(session).high - bar_range(session).low, 0.5, 1e-12) << "a flat picture keeps its range";
    set_bar_range(session, {0.6, 0.1});
    EXPECT_NEAR(bar_range(session).low, 0.1, 1e-12) << "a range the wrong way round is refused";
}

}  // namespace
}  // namespace pol
