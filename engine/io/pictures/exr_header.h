// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "core/result.h"

namespace pol {

/// What keeps OpenEXR's C++ library from reading the header of an EXR file (kind input, without a place): damage, or a
/// feature that is younger than the library. None: it may. That library takes as much memory as an attribute claims, up
/// to 2 GiB, before it looks. Requires: the file begins like an EXR file.
std::optional<Error> exr_header_problem(const std::filesystem::path& path);

}  // namespace pol
