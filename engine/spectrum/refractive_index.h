// SPDX-License-Identifier: Apache-2.0
// Refractive index as a function of vacuum wavelength: a literal, one of the refractiveindex.info dispersion formulas,
// or a table of n and k. Never extrapolates.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/result.h"

namespace pol {

/// n + i k (exp(-i omega t)); k >= 0 absorbs.
struct ComplexIndex {
    double n = 1.0;
    double k = 0.0;
    friend bool operator==(const ComplexIndex&, const ComplexIndex&) = default;
};

struct ConstantIndex {
    ComplexIndex value{};
    friend bool operator==(const ConstantIndex&, const ConstantIndex&) = default;
};

/// Formula 1 to 6 of the refractiveindex.info database, wavelength in micrometres.
struct DispersionFormula {
    int number = 1;
    std::vector<double> coefficients;
    double min_nm = 0.0;
    double max_nm = 0.0;
    friend bool operator==(const DispersionFormula&, const DispersionFormula&) = default;
};

/// Linear interpolation of one column between nodes, wavelengths ascending.
struct IndexTable {
    std::vector<double> wavelength_nm;
    std::vector<double> value;
    friend bool operator==(const IndexTable&, const IndexTable&) = default;
};

/// n from a formula or a table; k from a table, or zero where there is none.
struct DispersiveIndex {
    std::string name;  ///< file or record, for messages
    std::variant<DispersionFormula, IndexTable> n;
    IndexTable k;  ///< empty: k = 0
    friend bool operator==(const DispersiveIndex&, const DispersiveIndex&) = default;
};

using RefractiveIndex = std::variant<ConstantIndex, DispersiveIndex>;

/// Index at a vacuum wavelength. Error (kind input) if the wavelength lies outside the range of the data or n^2 is not
/// a positive finite number there.
Result<ComplexIndex> index_at(const RefractiveIndex& index, double wavelength_nm);

/// True if the index is the same at all wavelengths.
bool is_constant(const RefractiveIndex& index);

}  // namespace pol
