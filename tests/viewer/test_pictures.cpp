// SPDX-License-Identifier: Apache-2.0
// Several open pictures: stepping and flipping at the same place, pins that stay, parts where they lie in the whole.
#include <gtest/gtest.h>

#include "known_picture.h"
#include "viewer/commands/commands.h"
#include "viewer/pages/thumbnail.h"
#include "viewer/shown/picture_place.h"
#include "viewer/widgets/widget_map.h"
#include "window_without_gl.h"

namespace pol {
namespace {

/// A part of known_picture(): `width` x 6 pixels from 4,3 on. It reaches the right edge if `width` is 12.
StokesImage part_of_known_picture(int width = 12) {
    const StokesImage whole = known_picture();
    StokesImage part = whole;
    part.left = 4;
    part.top = 3;
    part.width = width;
    part.height = 9;
    part.stokes.clear();
    for (std::size_t b = 0; b < whole.bands.size(); ++b)
        for (int y = 0; y < part.height; ++y)
            for (int x = 0; x < part.width; ++x) part.stokes.push_back(whole.at(b, whole.pixel(x + 4, y + 3)));
    part.residual.assign(part.pixel_count(), 0.01);
    part.samples.assign(part.pixel_count(), 4);
    return part;
}

TEST(Pictures, KeysFlipBetweenThemWhileAPixelIsPinned) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    const auto open = session.documents();
    session.pin({3, 7});
    EXPECT_TRUE(run_command(session, {Key::page_up}));
    EXPECT_EQ(session.current(), open[1]);
    EXPECT_TRUE(run_command(session, {Key::tab, true, true}));
    EXPECT_EQ(session.current(), open[0]);
    EXPECT_TRUE(run_command(session, {Key::tab, true}));
    EXPECT_EQ(session.current(), open[1]);
    EXPECT_TRUE(run_command(session, {letter('3'), true}));
    EXPECT_EQ(session.current(), open[2]);
    EXPECT_FALSE(run_command(session, {letter('4'), true})) << "there is none";
    EXPECT_EQ(session.selection().pinned(), (PixelAddress{3, 7}));
    EXPECT_TRUE(run_command(session, {Key::up}));
    EXPECT_EQ(session.current(), open[2]) << "arrows move the pin";
    EXPECT_EQ(session.selection().pinned(), (PixelAddress{3, 6}));
    session.unpin();
    EXPECT_TRUE(run_command(session, {Key::up}));
    EXPECT_EQ(session.current(), open[1]);
}

TEST(Pictures, TheReferenceIsShownAsLongAsTheKeyIsHeld) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    EXPECT_FALSE(run_command(session, {letter('H')})) << "no reference";
    session.set_reference();
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    const Document* second = session.current();
    EXPECT_TRUE(run_command(session, {letter('H')}));
    EXPECT_TRUE(run_command(session, {letter('H')}, true)) << "the key repeats";
    EXPECT_EQ(session.current(), session.reference());
    release_key(session, letter('J'));
    EXPECT_EQ(session.current(), session.reference()) << "another key";
    release_key(session, letter('H'));
    EXPECT_EQ(session.current(), second);
    release_key(session, letter('H'));
    EXPECT_EQ(session.current(), second) << "once";
}

TEST(Pictures, AnotherChoiceEndsTheFlip) {
    Session session;
    for (int i = 0; i < 3; ++i) ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    session.set_reference();
    session.step_document(1);
    session.flip_to_reference();
    session.step_document(-1);
    const Document* chosen = session.current();
    session.flip_back();
    EXPECT_EQ(session.current(), chosen);
    session.step_document(-1);
    const Document* from = session.current();
    session.flip_to_reference();
    session.close_document(from);
    session.flip_back();
    EXPECT_EQ(session.current(), session.reference()) << "what it came from is closed";
}

TEST(Pictures, ClosingAnotherOneLeavesTheOneOnScreen) {
    Session session;
    for (int i = 0; i < 3; ++i) ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    const auto open = session.documents();
    session.show_document(open[1]);
    session.close_document(open[0]);
    EXPECT_EQ(session.current(), open[1]);
    session.close_document(open[2]);
    EXPECT_EQ(session.current(), open[1]);
    session.close_document(nullptr);
    ASSERT_EQ(session.documents().size(), 1U);
    session.close_document(open[1]);
    EXPECT_EQ(session.current(), nullptr);
}

TEST(Pictures, PinsAndRegionStayAtTheirPlaceInTheWholePicture) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    session.pin({1, 1});
    session.pin({9, 5});
    session.select_region(TileRect{5, 4, 9, 7});
    ASSERT_NO_FATAL_FAILURE(open_picture(session, part_of_known_picture()));
    EXPECT_EQ(session.selection().pins, (std::vector<PixelAddress>{{5, 2}})) << "9,5 less 4,3; it has no 1,1";
    EXPECT_EQ(session.selection().pinned(), (PixelAddress{5, 2}));
    ASSERT_TRUE(session.selection().region);
    EXPECT_EQ(session.selection().region->x0, 1);
    EXPECT_EQ(session.selection().region->y1, 4);
    const StokesImage& part = session.current()->picture();
    const StokesImage& whole = session.documents()[0]->picture();
    EXPECT_EQ(part.at(0, part.pixel(5, 2)).s1, whole.at(0, whole.pixel(9, 5)).s1);
    session.nudge(1, 0);
    session.step_document(1);
    EXPECT_EQ(session.selection().pins, (std::vector<PixelAddress>{{1, 1}, {10, 5}}));
    EXPECT_EQ(session.selection().pinned(), (PixelAddress{10, 5}));
    EXPECT_EQ(session.selection().region->x0, 5);
    session.unpin();
    EXPECT_EQ(session.selection().pinned(), (PixelAddress{1, 1}));
}

TEST(Pictures, ARegionThatAPartHasNotIsGone) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    session.select_region(TileRect{3, 4, 9, 7});
    ASSERT_NO_FATAL_FAILURE(open_picture(session, part_of_known_picture()));
    EXPECT_FALSE(session.selection().region) << "column 3 is not in it";
}

TEST(Pictures, OfOneSizeKeepZoomAndPan) {
    WindowWithoutGl window;
    Session& session = window.session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    window.draw();
    window.move(window.place_of({3, 7}));
    window.turn_wheel(3.0F);
    const ViewTransform zoomed = session.transform();
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    window.draw();
    EXPECT_EQ(session.transform(), zoomed);
    ASSERT_NO_FATAL_FAILURE(open_picture(session, part_of_known_picture()));
    window.draw();
    EXPECT_EQ(session.transform(), zoomed) << "a part of a picture of that size";
    window.move(window.place_of({5, 2}));
    EXPECT_EQ(session.selection().hovered, (PixelAddress{5, 2}));
    session.step_document(1);
    window.draw();
    EXPECT_EQ(session.selection().hovered, (PixelAddress{9, 5})) << "the same place under the cursor";
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture(20, 12)));
    window.draw();
    EXPECT_NE(session.transform(), zoomed) << "another size is fitted";
}

TEST(Pictures, TheWholePictureHasWhatLiesOutsideIt) {
    StokesImage picture;
    picture.width = 10;
    picture.height = 4;
    EXPECT_EQ(whole_of(picture), (WholePicture{{0.0, 0.0}, {10.0, 4.0}}));
    picture.whole_width = 8;
    picture.whole_height = 6;
    picture.left = -1;
    picture.top = 1;
    EXPECT_EQ(whole_of(picture), (WholePicture{{-1.0, 0.0}, {10.0, 6.0}})) << "columns -1 to 8, rows 0 to 5";
    ViewTransform transform;
    fit(transform, whole_of(picture), {100.0, 60.0});
    EXPECT_EQ(transform.view_from_picture({-1.0, 0.0}), DVec2(0.0, 0.0));
    EXPECT_EQ(transform.view_from_picture({9.0, 6.0}), DVec2(100.0, 60.0));
}

class PictureList : public testing::Test {
protected:
    void SetUp() override {
        map.text_log = "/dev/null";
        ImGui::GetIO().UserData = &map;
        ASSERT_NO_FATAL_FAILURE(open_picture(window.session, known_picture()));
        window.session.set_reference();
        window.draw();
    }
    void click(const std::string& name) {
        window.draw();
        ASSERT_TRUE(map.rects.contains(name)) << name;
        const ViewRect& rect = map.rects.at(name);
        window.click(rect.origin + DVec2(0.5 * rect.size.x, 0.5 * rect.size.y));
    }
    WindowWithoutGl window;
    WidgetMap map;
};

TEST_F(PictureList, ShowsAndClosesWhatIsClicked) {
    EXPECT_FALSE(map.rects.contains("picture 1")) << "one picture is no choice";
    ASSERT_NO_FATAL_FAILURE(open_picture(window.session, part_of_known_picture()));
    const auto open = window.session.documents();
    ASSERT_NO_FATAL_FAILURE(click("picture 1"));
    EXPECT_EQ(window.session.current(), open[0]);
    ASSERT_NO_FATAL_FAILURE(click("close picture 2"));
    EXPECT_EQ(window.session.documents(), (std::vector<const Document*>{open[0]}));
}

TEST_F(PictureList, SaysSizePlaceAndBandsAndMarksTheReference) {
    ASSERT_NO_FATAL_FAILURE(open_picture(window.session, part_of_known_picture()));
    PicturesPanel panel;
    const std::string text = window.text_of([&] { panel.draw(window.session, window.wishes); });
    EXPECT_NE(text.find("reference, 16 x 12 pixels, 2 bands"), std::string::npos) << text;
    EXPECT_NE(text.find("12 x 9 pixels from 4,3 of 16 x 12, 2 bands"), std::string::npos) << text;
}

/// Two pictures, the first one the reference, in a window.
class TwoPictures : public testing::Test {
protected:
    void SetUp() override {
        map.text_log = "/dev/null";
        ImGui::GetIO().UserData = &map;
        ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
        session.set_reference();
        ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
        window.draw();
    }
    WindowWithoutGl window;
    Session& session = window.session;
    WidgetMap map;
};

TEST_F(TwoPictures, AWipeHasALineThatFollowsTheMouse) {
    EXPECT_EQ(window.frame.reference_viewport.size.x, 0.0) << "not asked for";
    EXPECT_TRUE(run_command(session, {letter('W')}));
    window.draw(3);
    ASSERT_TRUE(map.rects.contains("wipe"));
    EXPECT_EQ(window.frame.reference_viewport.origin, window.frame.viewport.origin);
    EXPECT_EQ(window.frame.reference_viewport.size, window.frame.viewport.size);
    const ViewTransform before = session.transform();
    const ViewRect& line = map.rects.at("wipe");
    const DVec2 from = glm::floor(line.origin + 0.5 * line.size);
    const DVec2 to = from + DVec2(120.0, 30.0);
    window.drag(from, to);
    const double width = window.frame.viewport.size.x;
    EXPECT_NEAR(session.view().wipe, (to.x - window.frame.viewport.origin.x) / width, 1e-6);
    EXPECT_EQ(session.transform(), before) << "the picture was not dragged";
    EXPECT_FALSE(session.selection().pinned());
    window.drag(to, to + DVec2(5000.0, 0.0));
    EXPECT_EQ(session.view().wipe, 1.0) << "it stays in the picture";
    EXPECT_TRUE(run_command(session, {letter('W')}));
    window.draw();
    EXPECT_EQ(window.frame.reference_viewport.size.x, 0.0);
}

TEST_F(TwoPictures, SideBySideTheMouseDoesTheSameOnBoth) {
    EXPECT_TRUE(run_command(session, {letter('W'), false, true}));
    window.draw(3);
    const ViewRect& left = window.frame.reference_viewport;
    const ViewRect& right = window.frame.viewport;
    EXPECT_EQ(left.size, right.size);
    EXPECT_LE(left.origin.x + left.size.x, right.origin.x);
    EXPECT_EQ(session.view_size(), right.size);
    EXPECT_NEAR(session.transform().scale, std::min(right.size.x / 16.0, right.size.y / 12.0), 1e-9) << "fitted anew";
    const auto on_the_left = [&](PixelAddress pixel) {
        return left.origin + session.transform().view_from_picture({pixel.x + 0.5, pixel.y + 0.5});
    };
    window.move(on_the_left({5, 4}));
    EXPECT_EQ(session.selection().hovered, (PixelAddress{5, 4}));
    window.move(window.place_of({6, 7}));
    EXPECT_EQ(session.selection().hovered, (PixelAddress{6, 7}));
    window.click(on_the_left({3, 7}));
    EXPECT_EQ(session.selection().pinned(), (PixelAddress{3, 7}));
    const double scale = session.transform().scale;
    const DVec2 at = glm::floor(on_the_left({3, 7}));
    window.move(at);
    const DVec2 fixed = session.transform().picture_from_view(at - left.origin);
    window.turn_wheel(2.0F);
    EXPECT_NEAR(session.transform().scale / scale, 1.44, 1e-6);
    EXPECT_NEAR(session.transform().picture_from_view(at - left.origin).x, fixed.x, 1e-9);
    const DVec2 offset = session.transform().offset;
    window.drag(on_the_left({3, 7}), on_the_left({3, 7}) + DVec2(20.0, -15.0));
    EXPECT_NEAR(session.transform().offset.x - offset.x, 20.0, 1e-6);
    EXPECT_NEAR(session.transform().offset.y - offset.y, -15.0, 1e-6);
}

TEST_F(TwoPictures, ATypedPixelIsPinned) {
    EXPECT_TRUE(run_command(session, {letter('G'), true}));
    EXPECT_TRUE(session.window().modal());
    window.draw(3);
    EXPECT_TRUE(map.rects.contains("entry Go"));
    ImGui::GetIO().AddInputCharactersUTF8("12,7");
    window.draw(3);
    const ViewRect& go = map.rects.at("entry Go");
    window.click(go.origin + 0.5 * go.size);
    window.draw(3);
    EXPECT_EQ(session.selection().pinned(), (PixelAddress{12, 7}));
    EXPECT_FALSE(session.window().go_to_visible);
}

TEST(Thumbnail, IsTheMeanOfThePixelsUnderEachOfItsOwn) {
    StokesImage picture;
    picture.width = 4;
    picture.height = 2;
    picture.bands = {named_band("mono")};
    for (const double s0 : {1.0, 3.0, 4.0, 4.0, 2.0, 2.0, 4.0, 4.0}) picture.stokes.push_back({s0, 0.0, 0.0, 0.0});
    const Thumbnail small = thumbnail_of(picture, 2);
    ASSERT_EQ(small.width, 2);
    ASSERT_EQ(small.height, 1);
    // Means 2 and 4. White is the brightest but for a hundredth: of two, the darker one.
    EXPECT_EQ(small.pixels[0], small.pixels[1]);
    const Thumbnail whole = thumbnail_of(picture, 100);
    EXPECT_EQ(whole.width, 4) << "never larger than the picture";
    EXPECT_EQ(whole.pixels.size(), 8U);
}

}  // namespace
}  // namespace pol
