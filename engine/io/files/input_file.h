// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/result.h"

namespace pol {

/// All bytes of a regular file of at most `max_bytes`. Error (kind input, with the file and a hint): missing, a
/// directory or device, too large, not readable.
Result<std::string> read_input_file(const std::filesystem::path& path, std::uintmax_t max_bytes);

}  // namespace pol
