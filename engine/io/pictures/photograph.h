// SPDX-License-Identifier: Apache-2.0
// Pictures of cameras as they lie in PNG files: whole numbers, of gray or of R, G and B.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "film/band.h"
#include "io/pictures/picture_file.h"

namespace pol {

struct Photograph {
    int width = 0;
    int height = 0;
    std::size_t channels = 1;          ///< 1: gray; 3: R, G, B
    std::uint32_t most = 255;          ///< the number that stands for all light
    std::vector<std::uint16_t> codes;  ///< by row, column, channel; empty if only the header was read
    /// The file says that its numbers are not in proportion to light.
    bool says_encoded = false;
    bool says_linear = false;  ///< or that they are
    double gamma = 0.0;        ///< of the file's gAMA chunk; 0: sRGB, or nothing said
    bool has_alpha = false;
    std::optional<double> scale;  ///< light that `most` stands for, if polariscope convert wrote it

    [[nodiscard]] std::vector<Band> bands(StokesComponents known) const;
    /// Place of a code.
    [[nodiscard]] std::size_t at(std::size_t pixel, std::size_t channel) const { return pixel * channels + channel; }
};

/// Keyword of the text that has Photograph::scale.
inline constexpr const char* scale_keyword = "polariscope.scale";

/// Error (kind input, with the file): no PNG, damaged, or more pixels than it can hold or than max_picture_bytes.
Result<Photograph> read_photograph(const std::filesystem::path& path, bool with_pixels);

/// Largest power of two of which every code is a multiple: 16 if numbers of 12 bits sit in the high bits of 16. 1 if
/// all are 0.
std::uint32_t common_power_of_two(const std::vector<std::uint16_t>& codes);

}  // namespace pol
