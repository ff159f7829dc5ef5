// SPDX-License-Identifier: Apache-2.0
#include "polariscope/assets.h"

#include <system_error>

#include "io/files/assets.h"
#include "polariscope/inside.h"

namespace polariscope {

namespace fs = std::filesystem;

namespace {

bool has_assets(const fs::path& folder) {
    std::error_code failed;
    return fs::is_directory(folder / "refractive_index", failed);
}

}  // namespace

Result<fs::path> assets_folder() {
    return detail::guarded([]() -> Result<fs::path> {
        const fs::path folder = pol::assets_dir();
        if (has_assets(folder)) return folder;
        return detail::outer(pol::missing_assets());
    });
}

Result<Done> set_assets_folder(const fs::path& folder) {
    return detail::guarded([&]() -> Result<Done> {
        if (!has_assets(folder))
            return detail::usage("folder", "'" + folder.string() + "' has no assets",
                                 "the folder with refractive_index, scenes and textures in it");
        pol::choose_assets(fs::absolute(folder));
        return Done{};
    });
}

Result<fs::path> shipped_scene(const std::string& name) {
    return detail::guarded([&]() -> Result<fs::path> {
        const Result<fs::path> folder = assets_folder();
        if (!folder) return folder.error();
        const fs::path file = folder.value() / "scenes" / (name + ".yaml");
        std::error_code failed;
        if (fs::is_regular_file(file, failed)) return file;
        return Error{ErrorKind::input,
                     "no scene called '" + name + "' ships with polariscope",
                     file.string(),
                     0,
                     0,
                     {},
                     "the folder has them: cube-calcite, paper-glass-unpolarized ..."};
    });
}

namespace detail {

bool know_assets(const char* folder) {
    return static_cast<bool>(guarded([&]() -> Result<Done> {
        pol::fall_back_on_assets(folder);
        return Done{};
    }));
}

}  // namespace detail
}  // namespace polariscope
