// SPDX-License-Identifier: Apache-2.0
// Everything that a key, a menu entry or the help can name: one table.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "viewer/commands/keys.h"
#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// A row of the table, which lives as long as the program.
struct Command {
    std::string_view group;  ///< name of the menu and heading in the help
    std::string_view title;  ///< as in the menu
    KeyChord chord;          ///< none: menu only
    std::string_view help;   ///< one sentence for the help and the tooltip; of a map as help_of() has it
    void (*run)(Session&);
    bool (*enabled)(const Session&) = nullptr;  ///< null: always
    KeyChord also{};                            ///< a second chord
    bool repeats = false;                       ///< while the key is held
    bool (*checked)(const Session&) = nullptr;  ///< null: no check mark in the menu
    std::optional<Quantity> map{};              ///< the one that it shows
    KeyChord if_free{};                         ///< a third chord, which is its own only while no pixel is pinned
    void (*released)(Session&) = nullptr;       ///< ends what lasts while the key is held; null: nothing does
    bool is_listed = true;                      ///< false: another row of the menu and the help names its key, too
};

/// All commands, in the order of menus and help: rows of a group follow each other. Maps are rows of quantities().
std::span<const Command> commands();

/// What it does: `help`, or what the map is in the shown convention.
std::string help_of(const Command& command, const Session& session);

/// The key that shows a map; none if it has none.
KeyChord chord_of(Quantity quantity);

/// The command that the chord means now, or null. Two commands may share a chord if they are never enabled together
/// (arrow keys with and without a pinned pixel).
const Command* command_for(const Session& session, const KeyChord& chord);

[[nodiscard]] inline bool is_enabled(const Command& command, const Session& session) {
    return command.enabled == nullptr || command.enabled(session);
}

/// The command is to be run, if it is still enabled then.
void wish(Wishes& wishes, const Command& command);

/// Ends what lasts as long as this key is held, whatever modifiers it was pressed with.
void release_key(Session& session, Key key);

/// Runs what `chord` means; false if that is nothing. `held`: the key repeats.
bool run_command(Session& session, const KeyChord& chord, bool held = false);

}  // namespace pol
