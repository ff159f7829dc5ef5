// SPDX-License-Identifier: Apache-2.0
// Keys by name, without a window library.
#pragma once

#include <cstdint>
#include <string>

namespace pol {

/// Letters and digits have their ASCII codes (letters upper case), punctuation that of the US layout without Shift.
enum class Key : std::uint16_t {
    none = 0,
    space = ' ',
    slash = '/',
    escape = 256,
    enter,
    tab,
    backspace,
    del,
    home,
    end,
    page_up,
    page_down,
    left,
    right,
    up,
    down,
    f1,
    f2,
    f3,
    f4,
    f5,
    f6,
    f7,
    f8,
    f9,
    f10,
    f11,
    f12,
};

/// The key of a printable ASCII character: letters in upper case.
constexpr Key letter(char upper_case) {
    return static_cast<Key>(upper_case);
}

struct KeyChord {
    Key key = Key::none;
    bool ctrl = false;
    bool shift = false;
    friend bool operator==(const KeyChord&, const KeyChord&) = default;
};

/// "Ctrl+Shift+S", "?", "F5": as the help and the menus print it. Empty for no key.
std::string name_of(const KeyChord& chord);

/// True if a text field that has the keyboard needs this chord itself: plain characters, editing and clipboard keys.
bool edits_text(const KeyChord& chord);

}  // namespace pol
