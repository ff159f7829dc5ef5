// SPDX-License-Identifier: Apache-2.0
// Everything that a key, a menu entry or the help sheet can name: one table.
#pragma once

#include <span>
#include <string_view>

#include "viewer/keys.h"
#include "viewer/session.h"

namespace pol {

struct Command {
    std::string_view group;  ///< heading in the help sheet and name of the menu: "Map", "View", "Pixel", "File", ...
    std::string_view title;  ///< as in the menu
    KeyChord chord;          ///< none: menu only
    std::string_view help;   ///< one sentence for the help sheet and the tooltip
    void (*run)(Session&);
    bool (*enabled)(const Session&) = nullptr;  ///< null: always
};

/// All commands, in the order of the help sheet.
std::span<const Command> commands();

/// Runs the command bound to `chord`; false if there is none or it is not enabled.
bool run_command(Session& session, const KeyChord& chord);

}  // namespace pol
