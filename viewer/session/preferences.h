// SPDX-License-Identifier: Apache-2.0
// What the window remembers from one run to the next.
#pragma once

#include <filesystem>
#include <vector>

#include "core/result.h"
#include "maps/colorize.h"
#include "maps/quantity.h"
#include "viewer/session/session.h"
#include "viewer/session/window_state.h"

namespace pol {

struct Preferences {
    Theme theme = Theme::dark;
    double ui_scale = 0.0;
    Layout layout;
    Quantity quantity = Quantity::color;
    MapStyle style = MapStyle::scientific;
    std::vector<std::filesystem::path> recent_files;  ///< newest first
    std::vector<Session::ChosenConvention> chosen_conventions;
};

/// `preferences.json` in $XDG_CONFIG_HOME/polariscope or ~/.config/polariscope; empty if there is no home.
std::filesystem::path preferences_path();

/// Defaults if there is no such file. Error (kind input): the file is not what write_preferences writes; a key that is
/// not known is passed over, so that an older program reads the file of a newer one.
Result<Preferences> read_preferences(const std::filesystem::path& path);

/// Makes the folder and writes the file, whole or not at all. Error: kind output.
Result<Done> write_preferences(const Preferences& preferences, const std::filesystem::path& path);

Preferences preferences_of(const Session& session);
void apply(const Preferences& preferences, Session& session);

}  // namespace pol
