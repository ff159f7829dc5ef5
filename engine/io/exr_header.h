// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace pol {

/// What is wrong with the header of an EXR file; empty: OpenEXR's C++ library may read it. That library takes as much
/// memory as an attribute claims, up to 2 GiB, before it looks. Requires: the file begins like an EXR file.
std::string exr_header_complaint(const std::filesystem::path& path);

}  // namespace pol
