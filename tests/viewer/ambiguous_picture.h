// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace pol::test {

/// Writes an EXR file of 4 x 4 pixels with the channels of two layouts: S0 to S3 of 580 nm ("spectral") and without a
/// wavelength ("bare").
void write_ambiguous_picture(const std::filesystem::path& path);

}  // namespace pol::test
