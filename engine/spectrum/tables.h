// SPDX-License-Identifier: Apache-2.0
// The tables of assets/observer, compiled in. Sources: assets/observer/README.md.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace pol::tables {

/// Wavelength in nm, then the columns of the table. Wavelengths ascend in equal steps.
template <std::size_t columns>
using Row = std::array<double, columns>;

/// CIE 1931 color matching functions x, y, z: 360-830 nm, 1 nm.
std::span<const Row<4>> observer();
/// CIE D65, 100 at 560 nm: 300-830 nm, 5 nm.
std::span<const Row<2>> d65();
/// Basis spectra r, g, b of linear sRGB under D65: 380-780 nm, 5 nm.
std::span<const Row<4>> srgb_basis();

/// Row at `nm`, linear between nodes; on a node, the node to the bit.
/// Requires: `nm` lies within the table.
template <std::size_t columns>
Row<columns> row_at(std::span<const Row<columns>> table, double nm) {
    const double step = table[1][0] - table[0][0];
    const double position = (nm - table[0][0]) / step;
    const double node = std::floor(position);
    const double t = position - node;
    const auto index = static_cast<std::size_t>(node);
    if (t == 0.0) return table[index];
    Row<columns> row{};
    for (std::size_t i = 0; i < columns; ++i) row[i] = (1.0 - t) * table[index][i] + t * table[index + 1][i];
    return row;
}

}  // namespace pol::tables
