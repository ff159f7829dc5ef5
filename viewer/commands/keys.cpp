// SPDX-License-Identifier: Apache-2.0
#include "viewer/commands/keys.h"

#include <array>
#include <string_view>

namespace pol {

namespace {

constexpr std::array<std::string_view, 13> named_keys{"Esc",  "Enter", "Tab",  "Backspace", "Del", "Home", "End",
                                                      "PgUp", "PgDn",  "Left", "Right",     "Up",  "Down"};

std::string name_of(Key key) {
    if (key == Key::space) return "Space";
    if (key < Key::escape) return {static_cast<char>(key)};
    const auto index = static_cast<std::size_t>(key) - static_cast<std::size_t>(Key::escape);
    if (index < named_keys.size()) return std::string(named_keys[index]);
    return "F" + std::to_string(static_cast<int>(key) - static_cast<int>(Key::f1) + 1);
}

}  // namespace

std::string name_of(const KeyChord& chord) {
    if (chord.key == Key::none) return {};
    if (chord == KeyChord{Key::slash, false, true}) return "?";
    return std::string(chord.ctrl ? "Ctrl+" : "") + (chord.shift ? "Shift+" : "") + name_of(chord.key);
}

bool edits_text(const KeyChord& chord) {
    if (chord.key >= Key::f1) return false;
    if (!chord.ctrl || chord.key >= Key::escape) return true;
    return std::string_view("ACVXYZ").find(static_cast<char>(chord.key)) != std::string_view::npos;
}

}  // namespace pol
