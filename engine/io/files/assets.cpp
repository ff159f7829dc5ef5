// SPDX-License-Identifier: Apache-2.0
#include "io/files/assets.h"

#include <cstdlib>
#include <system_error>

namespace pol {

std::filesystem::path assets_dir() {
    namespace fs = std::filesystem;
    if (const char* chosen = std::getenv("POLARISCOPE_ASSETS"); chosen != nullptr && *chosen != '\0') return chosen;
    std::error_code failed;
    const fs::path program = fs::read_symlink("/proc/self/exe", failed);
    if (!failed) {
        const fs::path beside = (program.parent_path() / "../../assets").lexically_normal();
        if (fs::is_directory(beside / "refractive_index", failed)) return beside;
    }
    return POL_SOURCE_ASSETS;
}

}  // namespace pol
