// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "viewer/commands/commands.h"
#include "viewer/widgets/widget_map.h"
#include "viewer/window_without_gl.h"

namespace pol {
namespace {

/// `is_free`: no pixel is pinned.
std::vector<KeyChord> chords_of(const Command& command, bool is_free = true) {
    std::vector<KeyChord> chords;
    for (const KeyChord& chord : {command.chord, command.also, is_free ? command.if_free : KeyChord{}})
        if (chord.key != Key::none) chords.push_back(chord);
    return chords;
}

/// Sessions in every state that `enabled` asks about.
std::vector<std::unique_ptr<Session>> states() {
    const std::string scene = std::string(POL_ASSETS) + "/scenes/cube-glass.yaml";
    std::vector<std::unique_ptr<Session>> all;
    for (const int files : {0, 1, 2})
        for (const bool pinned : {false, true}) {
            if (files == 0 && pinned) continue;
            all.push_back(std::make_unique<Session>());
            for (int i = 0; i < files; ++i) EXPECT_TRUE(all.back()->open(scene));
            if (pinned) all.back()->pin({3, 4});
        }
    return all;
}

TEST(Commands, NoChordMeansTwoThingsAtOnce) {
    for (const auto& session : states()) {
        std::map<std::string, std::string_view> taken;
        for (const Command& command : commands()) {
            if (!is_enabled(command, *session)) continue;
            for (const KeyChord& chord : chords_of(command, !session->selection().pinned())) {
                const auto [other, is_new] = taken.emplace(name_of(chord), command.title);
                EXPECT_TRUE(is_new) << name_of(chord) << " is " << other->second << " and " << command.title << " with "
                                    << session->documents().size() << " documents";
            }
        }
    }
}

TEST(Commands, EveryCommandSaysWhatItDoes) {
    std::set<std::string_view> titles;
    for (const Command& command : commands()) {
        EXPECT_FALSE(command.title.empty());
        EXPECT_TRUE(command.help.ends_with('.') || command.map) << command.title;
        EXPECT_TRUE(titles.insert(command.title).second) << command.title << " is there twice";
        EXPECT_NE(command.run, nullptr) << command.title;
    }
}

TEST(Commands, RowsOfAGroupFollowEachOther) {
    std::set<std::string_view> seen;
    std::string_view last;
    for (const Command& command : commands()) {
        EXPECT_TRUE(command.group == last || seen.insert(command.group).second) << command.group;
        last = command.group;
    }
}

TEST(Commands, KeysThatTheReadmePromisesExist) {
    std::set<std::string> bound;
    for (const Command& command : commands())
        for (const KeyChord& chord : chords_of(command)) bound.insert(name_of(chord));
    for (const char* promised : {"PgDn",    "PgUp",   "Ctrl+Tab", "Ctrl+Shift+Tab",
                                 "Ctrl+1",  "Ctrl+9", "H",        "X",
                                 "Shift+X", "1",      "9",        "0",
                                 "Shift+3", "E",      "Shift+E",  "O",
                                 "G",       "R",      "F",        "Ctrl+0",
                                 "C",       "F11",    "[",        "]",
                                 "Left",    "Right",  "Up",       "Down",
                                 "Space",   "Tab",    "Esc",      "F1",
                                 "?",       "Ctrl+O", "Ctrl+Q",   "Ctrl+Shift+P"})
        EXPECT_TRUE(bound.contains(promised)) << promised;
}

TEST(Commands, EveryMapHasACommandThatSaysOfItWhatItsRowSays) {
    Session session;
    for (const QuantityInfo& about : quantities()) {
        SCOPED_TRACE(about.name);
        const auto all = commands();
        const auto is_this = [&](const Command& command) { return command.map == about.quantity; };
        ASSERT_EQ(std::count_if(all.begin(), all.end(), is_this), 1);
        const Command& command = *std::find_if(all.begin(), all.end(), is_this);
        EXPECT_EQ(command.group, "Map");
        EXPECT_EQ(command.title, about.title);
        EXPECT_EQ(command.chord, chord_of(about.quantity));
        EXPECT_EQ(command.chord.key == Key::none, about.key == MapKey{});
        EXPECT_EQ(help_of(command, session), about.definition);
        command.run(session);
        EXPECT_TRUE(command.checked(session));
        EXPECT_EQ(session.view().quantity, about.quantity);
    }
}

TEST(Commands, HelpOfAMapFollowsTheShownConvention) {
    Session session;
    session.change_view().convention = {Viewpoint::source, PositiveS3::left, TimeSign::minus};
    for (const Command& command : commands()) {
        const std::string expected =
            command.map ? session.view().convention.definition(*command.map) : std::string(command.help);
        EXPECT_EQ(help_of(command, session), expected) << command.title;
    }
}

TEST(Commands, ArrowsStepThroughMapsUntilAPixelIsPinned) {
    Session session;
    ASSERT_TRUE(session.open(std::string(POL_ASSETS) + "/scenes/cube-glass.yaml"));
    EXPECT_TRUE(run_command(session, {Key::right}));
    EXPECT_EQ(session.view().quantity, Quantity::intensity);
    session.pin({10, 20});
    EXPECT_TRUE(run_command(session, {Key::right}));
    EXPECT_EQ(session.view().quantity, Quantity::intensity);
    EXPECT_EQ(session.selection().pinned(), (PixelAddress{11, 20}));
    EXPECT_TRUE(run_command(session, {Key::escape}));
    EXPECT_FALSE(session.selection().pinned());
}

TEST(Commands, AHeldKeyTogglesOnce) {
    Session session;
    EXPECT_TRUE(run_command(session, {Key::tab}));
    EXPECT_TRUE(run_command(session, {Key::tab}, true));
    EXPECT_FALSE(session.window().panels_visible);
    EXPECT_TRUE(run_command(session, {letter('E')}));
    EXPECT_TRUE(run_command(session, {letter('E')}, true));
    EXPECT_EQ(session.view().exposure, 1.0);
}

/// Clicks on a named widget as it was drawn last.
void click(WindowWithoutGl& window, const WidgetMap& map, const std::string& name) {
    window.draw(3);
    ASSERT_TRUE(map.rects.contains(name)) << name;
    const ViewRect& rect = map.rects.at(name);
    window.click(rect.origin + 0.5 * rect.size);
    window.draw(2);
}

TEST(Commands, EscClosesAMenuOrAComboBeforeItTakesAwayThePin) {
    WindowWithoutGl window(1280.0F, 1400.0F);
    Session& session = window.session;
    WidgetMap map;
    map.text_log = "/dev/null";
    ImGui::GetIO().UserData = &map;
    ASSERT_TRUE(session.open(std::string(POL_ASSETS) + "/scenes/cube-glass.yaml"));
    session.pin({10, 20});
    click(window, map, "tab Scene");
    for (const char* opens : {"menu Facts", "menu File", "field mode", "button analyzer"}) {
        SCOPED_TRACE(opens);
        ASSERT_NO_FATAL_FAILURE(click(window, map, opens));
        EXPECT_TRUE(session.window().popup_open);
        EXPECT_TRUE(run_command(session, {Key::escape}));
        window.draw();
        EXPECT_FALSE(session.window().popup_open);
        EXPECT_TRUE(session.selection().pinned());
    }
    session.change_window().help_visible = true;
    ASSERT_NO_FATAL_FAILURE(click(window, map, "menu Map"));
    EXPECT_TRUE(run_command(session, {Key::escape}));
    window.draw();
    EXPECT_TRUE(session.window().help_visible);
    EXPECT_TRUE(run_command(session, {Key::escape}));
    EXPECT_FALSE(session.window().help_visible);
    EXPECT_TRUE(run_command(session, {Key::escape}));
    EXPECT_FALSE(session.selection().pinned());
}

TEST(Keys, HaveTheNamesThatAreOnThem) {
    EXPECT_EQ(name_of({letter('S'), true, true}), "Ctrl+Shift+S");
    EXPECT_EQ(name_of({Key::slash, false, true}), "?");
    EXPECT_EQ(name_of({Key::f11}), "F11");
    EXPECT_EQ(name_of({Key::page_down}), "PgDn");
    EXPECT_EQ(name_of({Key::down}), "Down");
    EXPECT_EQ(name_of(KeyChord{}), "");
}

TEST(Keys, ATextFieldKeepsWhatItEdits) {
    EXPECT_TRUE(edits_text({letter('E')}));
    EXPECT_TRUE(edits_text({Key::tab}));
    EXPECT_TRUE(edits_text({letter('V'), true}));
    EXPECT_FALSE(edits_text({letter('Q'), true}));
    EXPECT_FALSE(edits_text({Key::f1}));
}

}  // namespace
}  // namespace pol
