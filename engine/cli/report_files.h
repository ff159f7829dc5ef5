// SPDX-License-Identifier: Apache-2.0
// Folders that reports are written into.
#pragma once

#include <filesystem>
#include <string>

#include "core/result.h"

namespace pol {

/// Writes a whole file, or leaves the old one (io/output_file.h).
Result<Done> write_text(const std::filesystem::path& path, const std::string& text);

/// Makes the folder and those above it, unless they are there. Error (kind output): it cannot be made.
Result<Done> make_folder(const std::filesystem::path& folder);

}  // namespace pol
