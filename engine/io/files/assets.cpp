// SPDX-License-Identifier: Apache-2.0
#include "io/files/assets.h"

#include <cstdlib>
#include <string>
#include <system_error>

namespace pol {

namespace fs = std::filesystem;

std::vector<fs::path> asset_folders() {
    if (const char* chosen = std::getenv("POLARISCOPE_ASSETS"); chosen != nullptr && *chosen != '\0') return {chosen};
    std::vector<fs::path> folders;
    std::error_code failed;
    const fs::path program = fs::read_symlink("/proc/self/exe", failed);
    if (!failed) {
        for (const char* above : {"..", "."})
            folders.push_back((program.parent_path() / above / "share/polariscope").lexically_normal());
    }
    folders.emplace_back(POL_INSTALLED_ASSETS);
    return folders;
}

fs::path assets_dir() {
    const std::vector<fs::path> folders = asset_folders();
    for (const fs::path& folder : folders) {
        std::error_code failed;
        // The one of a build tree is a link; files in it are named by where they are.
        if (fs::is_directory(folder, failed)) return fs::canonical(folder, failed);
    }
    return folders.back();
}

Error missing_assets() {
    std::string hint = "looked for in ";
    for (const fs::path& folder : asset_folders()) hint += folder.string() + ", ";
    return {ErrorKind::input,
            "the files that ship with polariscope are not there",
            {},
            {},
            hint + "and POLARISCOPE_ASSETS names another folder"};
}

}  // namespace pol
