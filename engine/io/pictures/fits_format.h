// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace pol::fits {

inline constexpr std::size_t block_size = 2880;
inline constexpr std::size_t card_size = 80;
/// Cards of ours: StokesConvention::text(), and Band::label() of each place on the axis of the bands (POLB1, ...).
inline constexpr const char* convention_keyword = "POLCONV";
inline constexpr const char* band_keyword = "POLB";

}  // namespace pol::fits
