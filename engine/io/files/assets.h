// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace pol {

/// Folder of the files that ship with the program (scenes, textures, index records): $POLARISCOPE_ASSETS if it is set,
/// else
/// ../../assets beside the program (build/release/polariscope), else the folder of the source tree it was built from.
std::filesystem::path assets_dir();

}  // namespace pol
