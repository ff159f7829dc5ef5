// SPDX-License-Identifier: Apache-2.0
// Keys by name, without a window library.
#pragma once

#include <cstdint>
#include <string>

namespace pol {

/// Letters and digits have their ASCII codes (letters upper case), punctuation too.
enum class Key : std::uint16_t {
    none = 0,
    space = ' ',
    slash = '/',
    escape = 256,
    enter,
    tab,
    del,
    left,
    right,
    up,
    down,
    f1,
    f5 = f1 + 4,
    f11 = f1 + 10,
    f12,
};

constexpr Key letter(char upper_case) {
    return static_cast<Key>(upper_case);
}

struct KeyChord {
    Key key = Key::none;
    bool ctrl = false;
    bool shift = false;
    friend bool operator==(const KeyChord&, const KeyChord&) = default;
};

/// "Ctrl+Shift+S", "?", "F5": as the help sheet and the menus print it.
std::string name_of(const KeyChord& chord);

}  // namespace pol
