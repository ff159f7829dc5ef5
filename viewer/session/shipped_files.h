// SPDX-License-Identifier: Apache-2.0
// What comes with the program, by name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pol {

struct ShippedFiles {
    std::vector<std::filesystem::path> scenes;
    std::vector<std::string> index_records;  ///< of refractive indices, as scenes name them
};

/// Looks into the assets folder. What cannot be read is not there.
ShippedFiles find_shipped_files();

}  // namespace pol
