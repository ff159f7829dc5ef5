// SPDX-License-Identifier: Apache-2.0
// Panels change nothing while they draw; what they wish is done afterwards, and nothing is wished while nothing
// happens.
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <map>
#include <string>

#include "known_picture.h"
#include "viewer/commands/unsaved_edits.h"
#include "viewer/viewer_files.h"
#include "viewer/widgets/widget_map.h"
#include "window_without_gl.h"

namespace pol {
namespace {

/// One frame whose wishes nobody fulfils.
Wishes wishes_of_a_frame(WindowWithoutGl& window) {
    window.session.update();
    window.frame.redraw_in = std::numeric_limits<double>::infinity();
    ImGui::NewFrame();
    Wishes wishes = window.interface.draw(window.session, window.frame);
    ImGui::Render();
    return wishes;
}

Scene with_field_of_view(const Document& document, double factor) {
    Scene scene = document.scene();
    scene.camera.horizontal_fov *= factor;
    return scene;
}

TEST(Wishes, AWindowThatNobodyTouchesWishesNothing) {
    WindowWithoutGl window;
    window.draw(4);
    EXPECT_TRUE(wishes_of_a_frame(window).empty()) << "the welcome page";
    ASSERT_NO_FATAL_FAILURE(open_picture(window.session, known_picture()));
    window.session.pin({3, 7});
    window.move(window.place_of({5, 5}));
    window.draw(4);
    EXPECT_TRUE(wishes_of_a_frame(window).empty()) << "the cursor rests on the picture";
    WidgetMap map;
    map.text_log = "/dev/null";
    ImGui::GetIO().UserData = &map;
    window.draw(1);
    for (const auto& [name, rect] : std::map(map.rects)) {
        if (!name.starts_with("tab ") && !name.starts_with("menu ")) continue;
        window.click(rect.origin + 0.5 * rect.size);
        window.draw(4);
        EXPECT_TRUE(wishes_of_a_frame(window).empty()) << name;
    }
}

TEST(Wishes, AClickChangesNothingUntilItsWishIsFulfilled) {
    WindowWithoutGl window;
    ASSERT_NO_FATAL_FAILURE(open_picture(window.session, known_picture()));
    window.draw(3);
    window.move(window.place_of({3, 7}));
    window.press();
    test::hold_button(0, false);
    Wishes wishes = wishes_of_a_frame(window);
    EXPECT_FALSE(wishes.empty());
    EXPECT_FALSE(window.session.selection().pinned());
    EXPECT_EQ(window.frame.redraw_in, 0.0) << "the next frame shows what became of it";
    wishes.fulfil(window.session);
    EXPECT_EQ(window.session.selection().pinned(), (PixelAddress{3, 7}));
    EXPECT_TRUE(wishes.empty()) << "once";
}

TEST(Wishes, OfOneFrameDoNotUndoEachOther) {
    Session session;
    Wishes wishes;
    wishes.set(&ViewSettings::exposure, 2.0);
    wishes.set(&ViewSettings::quantity, Quantity::dop);
    wishes.set(&WindowState::log_visible, true);
    wishes.fulfil(session);
    EXPECT_EQ(session.view().exposure, 2.0);
    EXPECT_EQ(session.view().quantity, Quantity::dop);
    EXPECT_TRUE(session.window().log_visible);
}

TEST(Wishes, AnEditNeverReachesAnotherDocument) {
    const test::WorkingFolder folder;
    test::write_text("plate.yaml", test::plate_scene(4, 4));
    Session session;
    ASSERT_TRUE(session.open("plate.yaml"));
    ASSERT_TRUE(session.open("plate.yaml"));
    const Document* second = session.current();
    session.step_document(1);
    ASSERT_NE(session.current(), second);
    EXPECT_FALSE(session.edit(second, with_field_of_view(*second, 0.5), "field of view"));
    EXPECT_FALSE(session.move_camera(second, second->scene().camera, "camera orbit"));
    session.refuse_edit(second, "field of view", Error{ErrorKind::input, "no number", {}, {}, {}});
    EXPECT_FALSE(session.has_unsaved_edits());
    EXPECT_FALSE(session.current()->refused());
    session.step_document(1);
    EXPECT_TRUE(session.edit(second, with_field_of_view(*second, 0.5), "field of view"));
    EXPECT_TRUE(second->dirty());
}

class UnsavedEdits : public testing::Test {
protected:
    void SetUp() override {
        test::write_text("plate.yaml", test::plate_scene(4, 4));
        ASSERT_TRUE(session.open("plate.yaml"));
        ASSERT_TRUE(session.edit(session.current(), with_field_of_view(*session.current(), 0.5), "field of view"));
    }
    [[nodiscard]] Question question() const { return session.window().question; }

    test::WorkingFolder folder;
    Session session;
};

TEST_F(UnsavedEdits, AreAskedAboutAndNothingElseIs) {
    close_or_ask(session);
    EXPECT_EQ(question(), Question::unsaved_at_close);
    EXPECT_TRUE(session.window().modal());
    stay(session);
    EXPECT_EQ(question(), Question::none);
    end_or_ask(session);
    EXPECT_EQ(question(), Question::unsaved_at_end);
    EXPECT_FALSE(session.window().ended);
    stay(session);
    ASSERT_TRUE(session.undo());
    end_or_ask(session);
    EXPECT_TRUE(session.window().ended);
    close_or_ask(session);
    EXPECT_EQ(session.current(), nullptr);
    close_or_ask(session);
    go_on_without_saving(session);
    EXPECT_EQ(question(), Question::none);
}

TEST_F(UnsavedEdits, OfAllDocumentsAreSavedBeforeTheEnd) {
    test::write_text("other.yaml", test::plate_scene(4, 4));
    ASSERT_TRUE(session.open("other.yaml"));
    end_or_ask(session);
    EXPECT_EQ(question(), Question::unsaved_at_end) << "of the document that is not on screen";
    save_and_go_on(session);
    EXPECT_TRUE(session.window().ended);
    EXPECT_FALSE(session.has_unsaved_edits());
    Session again;
    ASSERT_TRUE(again.open("plate.yaml"));
    EXPECT_EQ(again.current()->scene().camera.horizontal_fov, session.documents()[0]->scene().camera.horizontal_fov);
}

TEST_F(UnsavedEdits, ThatTheFileCannotTakeAreAskedAboutInstead) {
    test::write_text("plate.yaml", "# of another program\n" + test::plate_scene(8, 8));
    end_or_ask(session);
    save_and_go_on(session);
    EXPECT_FALSE(session.window().ended);
    EXPECT_EQ(question(), Question::rewrite);
    write_anew(session);
    EXPECT_EQ(question(), Question::none);
    EXPECT_FALSE(session.current()->dirty());
    EXPECT_TRUE(std::filesystem::exists("plate.yaml.bak"));
}

TEST_F(UnsavedEdits, AQuestionAboutADocumentGoesWithIt) {
    close_or_ask(session);
    ASSERT_TRUE(session.open("plate.yaml")) << "dropped on the window";
    EXPECT_EQ(question(), Question::none) << "the answer would be about the wrong one";
    end_or_ask(session);
    session.step_document(1);
    EXPECT_EQ(question(), Question::unsaved_at_end);
}

TEST_F(UnsavedEdits, TheDialogClosesWithItsQuestion) {
    WindowWithoutGl window;
    ASSERT_TRUE(window.session.open("plate.yaml"));
    const Document* document = window.session.current();
    ASSERT_TRUE(window.session.edit(document, with_field_of_view(*document, 0.5), "field of view"));
    end_or_ask(window.session);
    WidgetMap map;
    map.text_log = "/dev/null";
    ImGui::GetIO().UserData = &map;
    window.draw(3);
    ASSERT_TRUE(map.rects.contains("button Save and quit"));
    EXPECT_TRUE(window.session.window().popup_open);
    const ViewRect& cancel = map.rects.at("button Cancel");
    window.click(cancel.origin + 0.5 * cancel.size);
    window.draw(2);
    EXPECT_EQ(window.session.window().question, Question::none);
    EXPECT_FALSE(window.session.window().popup_open);
    EXPECT_FALSE(window.session.window().ended);
    close_or_ask(window.session);
    window.draw(3);
    ASSERT_TRUE(map.rects.contains("button Close without saving"));
    const ViewRect& without = map.rects.at("button Close without saving");
    window.click(without.origin + 0.5 * without.size);
    window.draw(2);
    EXPECT_EQ(window.session.current(), nullptr);
    EXPECT_FALSE(window.session.window().popup_open);
}

}  // namespace
}  // namespace pol
