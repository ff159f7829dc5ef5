// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "core/result.h"

namespace pol {

/// Where the files that ship with the program are looked for, best first: the folder of choose_assets(), and nowhere
/// else, if there is one, or $POLARISCOPE_ASSETS, likewise; else share/polariscope beside the folder of the running
/// program, as installed, or in that folder, as built, so that both trees may be moved; then the folder of
/// fall_back_on_assets(); last where they were to be installed.
std::vector<std::filesystem::path> asset_folders();

/// Folder of the files that ship with the program (scenes, textures, index records): the first of asset_folders() that
/// is there, else the last one.
std::filesystem::path assets_dir();

/// For a program elsewhere that uses the library. Both from any thread.
void choose_assets(const std::filesystem::path& folder);
void fall_back_on_assets(const std::filesystem::path& folder);

/// What to say if assets_dir() is not there: where it was looked for.
Error missing_assets();

}  // namespace pol
