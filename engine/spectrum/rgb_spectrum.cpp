// SPDX-License-Identifier: Apache-2.0
#include "spectrum/rgb_spectrum.h"

#include <algorithm>

#include "core/result.h"
#include "spectrum/illuminant.h"
#include "spectrum/tables.h"

namespace pol {

Result<std::array<double, 3>> rgb_basis_at(double wavelength_nm) {
    POL_TRY(const auto d65, d65_at(wavelength_nm));
    const auto table = tables::srgb_basis();
    const auto row = tables::row_at(table, std::clamp(wavelength_nm, table.front()[0], table.back()[0]));
    return std::array<double, 3>{row[1] * d65, row[2] * d65, row[3] * d65};
}

}  // namespace pol
