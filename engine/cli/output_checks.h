// SPDX-License-Identifier: Apache-2.0
// Where results may be written.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace pol {

/// Makes the folder and those above it, unless they are there. Error (kind output): it cannot be made.
Result<Done> make_folder(const std::filesystem::path& folder);

/// What speaks against writing a result to `output`: its name does not end in `ending` (in any case; "" allows every
/// name), or it is one of `others`, by this or another name.
std::optional<Error> output_problem(const std::filesystem::path& output, std::string_view ending,
                                    const std::vector<std::filesystem::path>& others);

}  // namespace pol
