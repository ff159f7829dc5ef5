// SPDX-License-Identifier: Apache-2.0
// Keys of an .npz that a StokesImage is written to: `stokes` and what belongs to it.
#pragma once

#include <string>
#include <string_view>

namespace pol::npz {

inline constexpr std::string_view stokes = "stokes";                  ///< (n, H, W, 4), or 3 without S3
inline constexpr std::string_view wavelengths = "wavelengths_nm";     ///< (n,)
inline constexpr std::string_view bands = "bands";                    ///< (n,) text, where there is no wavelength
inline constexpr std::string_view residual = "residual";              ///< (H, W) or (n, H, W)
inline constexpr std::string_view tail = "tail";                      ///< likewise
inline constexpr std::string_view sampling_error = "sampling_error";  ///< as stokes
inline constexpr std::string_view convention = "convention";          ///< text, StokesConvention::text()

}  // namespace pol::npz
