// SPDX-License-Identifier: Apache-2.0
#include "viewer/commands.h"

#include <algorithm>
#include <array>

namespace pol {

std::string name_of(const KeyChord& chord) {
    std::string text;
    if (chord.ctrl) text += "Ctrl+";
    if (chord.shift) text += "Shift+";
    const auto code = static_cast<int>(chord.key);
    if (chord.key == Key::space) return text + "Space";
    if (code > ' ' && code < 127) return text + static_cast<char>(code);
    switch (chord.key) {
        case Key::escape:
            return text + "Esc";
        case Key::enter:
            return text + "Enter";
        case Key::tab:
            return text + "Tab";
        case Key::del:
            return text + "Del";
        case Key::left:
            return text + "Left";
        case Key::right:
            return text + "Right";
        case Key::up:
            return text + "Up";
        case Key::down:
            return text + "Down";
        default:
            return text + "F" + std::to_string(code - static_cast<int>(Key::f1) + 1);
    }
}

namespace {

template <Quantity quantity>
void show_map(Session& session) {
    session.show(quantity);
}

constexpr std::array command_table{
    Command{"Map", "Color", {letter('1')}, "The picture as it looks.", show_map<Quantity::color>},
    Command{"Map", "Intensity", {letter('2')}, "S0 at one wavelength.", show_map<Quantity::intensity>},
    Command{"Map", "Degree of polarization", {letter('3')}, "DoP, 0 to 1.", show_map<Quantity::dop>},
    Command{"View",
            "Hide panels",
            {Key::tab},
            "Shows the picture alone.",
            [](Session& s) { s.panels_visible = !s.panels_visible; }},
    Command{"File", "Quit", {letter('Q'), true}, "Ends the program.", [](Session& s) { s.quit_requested = true; }},
};

}  // namespace

std::span<const Command> commands() {
    return command_table;
}

bool run_command(Session& session, const KeyChord& chord) {
    const auto found = std::find_if(command_table.begin(), command_table.end(),
                                    [&](const Command& command) { return command.chord == chord; });
    if (found == command_table.end() || chord.key == Key::none) return false;
    if (found->enabled != nullptr && !found->enabled(session)) return false;
    found->run(session);
    return true;
}

}  // namespace pol
