// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "core/result.h"

namespace pol {

/// Where the files that ship with the program are looked for, best first: $POLARISCOPE_ASSETS, and nowhere else, if it
/// is set; else share/polariscope beside the folder of the running program, as installed, or in that folder, as built,
/// so that both trees may be moved; last where they were to be installed, for programs elsewhere that use the library.
std::vector<std::filesystem::path> asset_folders();

/// Folder of the files that ship with the program (scenes, textures, index records): the first of asset_folders() that
/// is there, else the last one.
std::filesystem::path assets_dir();

/// What to say if assets_dir() is not there: where it was looked for.
Error missing_assets();

}  // namespace pol
