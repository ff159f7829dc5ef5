// SPDX-License-Identifier: Apache-2.0
#include "viewer/commands/commands.h"

#include <algorithm>

namespace pol {

std::string help_of(const Command& command, const Session& session) {
    return command.map ? session.view().convention.definition(*command.map) : std::string(command.help);
}

KeyChord chord_of(Quantity quantity) {
    const MapKey& key = info(quantity).key;
    return {letter(key.letter), false, key.shift};
}

const Command* command_for(const Session& session, const KeyChord& chord) {
    if (chord.key == Key::none) return nullptr;
    const auto all = commands();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Command& command) {
        const bool is_free = command.if_free == chord && !session.selection().pinned();
        return (command.chord == chord || command.also == chord || is_free) && is_enabled(command, session);
    });
    return found == all.end() ? nullptr : &*found;
}

void wish(Wishes& wishes, const Command& command) {
    wishes.add([&command](Session& session) {
        if (is_enabled(command, session)) command.run(session);
    });
}

void release_key(Session& session, Key key) {
    for (const Command& command : commands())
        if (command.released != nullptr && command.chord.key == key) command.released(session);
}

bool run_command(Session& session, const KeyChord& chord, bool held) {
    const Command* command = command_for(session, chord);
    if (command == nullptr) return false;
    if (held && !command->repeats) return true;
    command->run(session);
    return true;
}

}  // namespace pol
