// SPDX-License-Identifier: Apache-2.0
// Refractive index as a function of vacuum wavelength: a literal, one of the refractiveindex.info dispersion formulas,
// or a table of n and k. Never extrapolates.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
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

/// Formula 1 to 9 of the refractiveindex.info database, wavelength in micrometres.
struct DispersionFormula {
    int number = 1;
    std::vector<double> coefficients;
    double min_nm = 0.0;
    double max_nm = 0.0;
    friend bool operator==(const DispersionFormula&, const DispersionFormula&) = default;
};

/// Linear interpolation of one column between nodes. Wavelengths ascend; a node stands twice if the source gives two
/// values for it, and negative values are kept: index_at refuses where it would need such a node.
struct IndexTable {
    std::vector<double> wavelength_nm;
    std::vector<double> value;
    friend bool operator==(const IndexTable&, const IndexTable&) = default;
};

using IndexBlock = std::variant<DispersionFormula, IndexTable>;

/// n from a formula or a table; k from a table, or zero where there is none. A record may have more blocks of either,
/// for other wavelengths.
struct DispersiveIndex {
    std::string name;  ///< file or record, for messages
    IndexBlock n;
    IndexTable k;  ///< empty: k = 0
    std::vector<IndexBlock> more_n{};
    std::vector<IndexTable> more_k{};
    friend bool operator==(const DispersiveIndex&, const DispersiveIndex&) = default;
};

using RefractiveIndex = std::variant<ConstantIndex, DispersiveIndex>;

/// Highest number of a dispersion formula.
inline constexpr int last_formula = 9;

/// What is wrong with this number of coefficients in formula `number` (1 to last_formula); empty: nothing.
std::string coefficient_problem(int number, std::size_t count);

/// The rows in ascending order, each once: the order of rows, or their repetition, is no content of a table. Rows of
/// one wavelength with different values stay, in their order.
IndexTable index_table(std::vector<std::pair<double, double>> rows);

/// Index at a vacuum wavelength; k is 0 where it is not known (extinction_is_unknown). Error (kind input) if the
/// wavelength lies outside the range of n, or n^2 is not a positive finite number there, or a row of a table that is
/// needed is negative or contradicted by another, or so is a block.
Result<ComplexIndex> index_at(const RefractiveIndex& index, double wavelength_nm);

/// True if the record has k, but not at this wavelength.
bool extinction_is_unknown(const RefractiveIndex& index, double wavelength_nm);

/// True if the index is the same at all wavelengths.
bool is_constant(const RefractiveIndex& index);

}  // namespace pol
