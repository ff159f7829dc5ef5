// SPDX-License-Identifier: Apache-2.0
#include "viewer/session/shipped_files.h"

#include <algorithm>
#include <system_error>

#include "io/files/assets.h"

namespace pol {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& folder, const std::string& ending) {
    std::vector<fs::path> files;
    std::error_code failed;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
        if (entry.path().extension() == ending) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

ShippedFiles find_shipped_files() {
    ShippedFiles found;
    found.scenes = files_in(assets_dir() / "scenes", ".yaml");
    for (const fs::path& record : files_in(assets_dir() / "refractive_index", ".yml"))
        found.index_records.push_back(record.stem().string());
    return found;
}

}  // namespace pol
