// SPDX-License-Identifier: Apache-2.0
// The files that ship with the library: refractive indices, textures, scenes.
#pragma once

#include <filesystem>

#include "polariscope/result.h"

namespace polariscope {

/// The folder in use: the one of set_assets_folder(), else $POLARISCOPE_ASSETS, else the first that is there of
/// ../share/polariscope and share/polariscope as seen from the program, where find_package() found the library when the
/// program was built, and where the library was configured to be installed. Error (input): there is none.
Result<std::filesystem::path> assets_folder();

/// From now on this folder, in all threads. Error (usage): it is no folder of that kind.
Result<Done> set_assets_folder(const std::filesystem::path& folder);

/// A shipped scene by its name: "cube-calcite", "bench/g1". Error (input): there is none of that name.
Result<std::filesystem::path> shipped_scene(const std::string& name);

namespace detail {
/// Where to look when all else fails. True, for the initializer below.
bool know_assets(const char* folder);
}  // namespace detail

#ifdef POLARISCOPE_PACKAGE_ASSETS  // the exported target says where it was found
namespace detail {
inline const bool package_assets_are_known = know_assets(POLARISCOPE_PACKAGE_ASSETS);
}
#endif

}  // namespace polariscope
