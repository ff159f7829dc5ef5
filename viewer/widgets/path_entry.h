// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace pol {

/// A path as people type it: "~/" is the home folder, as in a shell.
inline std::filesystem::path typed_path(const std::string& typed) {
    const char* home = std::getenv("HOME");
    if (home != nullptr && typed.starts_with("~/")) return std::filesystem::path(home) / typed.substr(2);
    return typed;
}

}  // namespace pol
