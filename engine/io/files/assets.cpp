// SPDX-License-Identifier: Apache-2.0
#include "io/files/assets.h"

#include <cstdlib>
#include <mutex>
#include <string>
#include <system_error>

namespace pol {

namespace fs = std::filesystem;

namespace {

/// What a host of the library has said; the program says nothing.
struct FoldersOfHost {
    std::mutex mutex;
    fs::path chosen;
    fs::path last_resort;
};

FoldersOfHost& folders_of_host() {
    static FoldersOfHost folders;
    return folders;
}

}  // namespace

void choose_assets(const fs::path& folder) {
    const std::scoped_lock lock(folders_of_host().mutex);
    folders_of_host().chosen = folder;
}

void fall_back_on_assets(const fs::path& folder) {
    const std::scoped_lock lock(folders_of_host().mutex);
    folders_of_host().last_resort = folder;
}

std::vector<fs::path> asset_folders() {
    const std::scoped_lock lock(folders_of_host().mutex);
    if (!folders_of_host().chosen.empty()) return {folders_of_host().chosen};
    if (const char* chosen = std::getenv("POLARISCOPE_ASSETS"); chosen != nullptr && *chosen != '\0') return {chosen};
    std::vector<fs::path> folders;
    std::error_code failed;
    const fs::path program = fs::read_symlink("/proc/self/exe", failed);
    if (!failed) {
        for (const char* above : {"..", "."})
            folders.push_back((program.parent_path() / above / "share/polariscope").lexically_normal());
    }
    if (!folders_of_host().last_resort.empty()) folders.push_back(folders_of_host().last_resort);
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
