// SPDX-License-Identifier: Apache-2.0
// Folders that reports are written into.
#pragma once

#include <filesystem>

#include "core/result.h"

namespace pol {

/// Makes the folder and those above it, unless they are there. Error (kind output): it cannot be made.
Result<Done> make_folder(const std::filesystem::path& folder);

}  // namespace pol
