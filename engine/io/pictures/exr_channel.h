// SPDX-License-Identifier: Apache-2.0
// Names of spectral channels: "S0.580,000000nm". Grammar: Fichet, Pacanowski & Wilkie 2021, section 3.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pol {

/// "580,000000nm": six decimals, comma as decimal mark, whatever the locale.
std::string wavelength_suffix(double wavelength_nm);

/// Vacuum wavelength in nm of "580,0nm", "5,8e2nm", "0,58um" or "516,8THz". Empty if `text` is something else or the
/// wavelength is not positive and finite.
std::optional<double> parse_wavelength_suffix(std::string_view text);

}  // namespace pol
