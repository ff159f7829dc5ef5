// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "viewer/document/edit_history.h"

namespace pol {
namespace {

Scene titled(const std::string& title) {
    Scene scene;
    scene.title = title;
    return scene;
}

TEST(EditHistory, ADragIsOneStepUntilItIsSealed) {
    EditHistory history(titled("file"));
    for (const char* index : {"1.51", "1.52", "1.53"}) history.push(titled(index), "index of glass");
    history.seal();
    history.push(titled("1.6"), "index of glass");
    history.push(titled("turned"), "axis of calcite");
    EXPECT_EQ(history.undo_label(), "axis of calcite");
    history.undo();
    EXPECT_EQ(history.scene().title, "1.6");
    history.undo();
    EXPECT_EQ(history.scene().title, "1.53");
    history.undo();
    EXPECT_EQ(history.scene().title, "file");
    EXPECT_FALSE(history.can_undo());
}

TEST(EditHistory, AnEditAfterUndoForgetsWhatWasUndone) {
    EditHistory history(titled("file"));
    history.push(titled("a"), "a");
    history.undo();
    EXPECT_EQ(history.redo_label(), "a");
    history.push(titled("b"), "b");
    EXPECT_FALSE(history.can_redo());
    history.undo();
    EXPECT_EQ(history.scene().title, "file");
}

// A step that was reached by undo is not a drag that goes on.
TEST(EditHistory, AnEditAfterUndoNeverJoinsTheStepItFinds) {
    EditHistory history(titled("file"));
    history.push(titled("1.5"), "index");
    history.push(titled("x"), "other");
    history.undo();
    history.push(titled("1.6"), "index");
    history.undo();
    EXPECT_EQ(history.scene().title, "1.5");
}

TEST(EditHistory, OnlyTheSavedStepIsClean) {
    EditHistory history(titled("file"));
    EXPECT_FALSE(history.dirty());
    history.push(titled("a"), "a");
    EXPECT_TRUE(history.dirty());
    history.mark_saved();
    EXPECT_FALSE(history.dirty());
    history.push(titled("b"), "a");
    EXPECT_TRUE(history.dirty());
    history.undo();
    EXPECT_FALSE(history.dirty());
    history.undo();
    EXPECT_TRUE(history.dirty());
    // Another step at the same depth is not the saved one.
    history.push(titled("c"), "c");
    EXPECT_TRUE(history.dirty());
}

TEST(EditHistory, TheOldestStepsAreForgotten) {
    EditHistory history(titled("file"));
    for (std::size_t i = 0; i < 2 * EditHistory::longest; ++i)
        history.push(titled(std::to_string(i)), std::to_string(i));
    std::size_t steps = 0;
    while (history.can_undo()) {
        history.undo();
        ++steps;
    }
    EXPECT_EQ(steps, EditHistory::longest - 1);
    EXPECT_TRUE(history.dirty());
}

}  // namespace
}  // namespace pol
