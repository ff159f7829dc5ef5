// SPDX-License-Identifier: Apache-2.0
#include "spectrum/refractive_index.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/number_text.h"
#include "core/overloaded.h"
#include "core/result.h"
#include "spectrum/interpolation.h"

namespace pol {
namespace {

/// One coefficient, 0 where the record stops.
double coefficient(const std::vector<double>& c, std::size_t i) {
    return i < c.size() ? c[i] : 0.0;
}

bool gives_square(int formula) {
    return formula <= 4 || formula >= 8;
}

/// n of formulas 5 to 7, n^2 of the others, wavelength in micrometres. Numbering and order of the coefficients as in
/// the documentation of the refractiveindex.info database ("Dispersion formulas").
double formula_value(const DispersionFormula& formula, double um) {
    const std::vector<double>& c = formula.coefficients;
    const double um2 = um * um;
    const double first = coefficient(c, 0);
    double sum = 0.0;
    switch (formula.number) {
        case 1:  // Sellmeier
            for (std::size_t i = 1; i < c.size(); i += 2) {
                const double pole = coefficient(c, i + 1);
                sum += c[i] * um2 / ((um - pole) * (um + pole));
            }
            return 1.0 + first + sum;
        case 2:  // Sellmeier-2
            for (std::size_t i = 1; i < c.size(); i += 2) sum += c[i] * um2 / (um2 - coefficient(c, i + 1));
            return 1.0 + first + sum;
        case 3:  // polynomial, n^2
        case 5:  // Cauchy, n
            for (std::size_t i = 1; i < c.size(); i += 2) sum += c[i] * std::pow(um, coefficient(c, i + 1));
            return first + sum;
        case 4:  // two poles of four coefficients each, then a polynomial
            for (std::size_t i = 1; i < c.size() && i < 9; i += 4) {
                const double pole = std::pow(coefficient(c, i + 2), coefficient(c, i + 3));
                sum += c[i] * std::pow(um, coefficient(c, i + 1)) / (um2 - pole);
            }
            for (std::size_t i = 9; i < c.size(); i += 2) sum += c[i] * std::pow(um, coefficient(c, i + 1));
            return first + sum;
        case 6:  // gases
            for (std::size_t i = 1; i < c.size(); i += 2) sum += c[i] / (coefficient(c, i + 1) - 1.0 / um2);
            return 1.0 + first + sum;
        case 7: {  // Herzberger, n
            const double pole = 1.0 / (um2 - 0.028);
            return first + coefficient(c, 1) * pole + coefficient(c, 2) * pole * pole +
                   um2 * (coefficient(c, 3) + um2 * (coefficient(c, 4) + um2 * coefficient(c, 5)));
        }
        case 8: {  // retro: (n^2 - 1)/(n^2 + 2)
            sum = first + coefficient(c, 1) * um2 / (um2 - coefficient(c, 2)) + coefficient(c, 3) * um2;
            return (1.0 + 2.0 * sum) / (1.0 - sum);
        }
        case 9: {  // exotic
            const double shifted = um - coefficient(c, 4);
            return first + coefficient(c, 1) / (um2 - coefficient(c, 2)) +
                   coefficient(c, 3) * shifted / (shifted * shifted + coefficient(c, 5));
        }
        default:
            return std::nan("");
    }
}

Error outside(const std::string& name, const std::string& what, double nm, double first, double last) {
    return Error{ErrorKind::input,
                 number_text(nm) + " nm is outside the range of " + what + " in '" + name + "', " + number_text(first) +
                     " to " + number_text(last) + " nm",
                 {},
                 {},
                 "render at wavelengths inside this range, or use another record; nothing is extrapolated"};
}

Error no_index(const std::string& name, const std::string& quantity, double nm, double value) {
    return Error{
        ErrorKind::input,
        "'" + name + "' gives " + quantity + " = " + number_text(value) + " at " + number_text(nm) + " nm",
        {},
        {},
        "an index must be positive and finite, an extinction not negative: check the coefficients of the record"};
}

Error bad_row(const std::string& name, const std::string& what, const std::string& rule) {
    return Error{ErrorKind::input,
                 "'" + name + "' has " + what,
                 {},
                 {},
                 rule + ": mend this in a copy of the record, or use a wavelength that does not need it"};
}

bool covers(const IndexTable& table, double nm) {
    return !table.wavelength_nm.empty() && nm >= table.wavelength_nm.front() && nm <= table.wavelength_nm.back();
}

bool covers(const IndexBlock& block, double nm) {
    if (const auto* table = std::get_if<IndexTable>(&block)) return covers(*table, nm);
    const auto& formula = std::get<DispersionFormula>(block);
    return nm >= formula.min_nm && nm <= formula.max_nm;
}

Result<double> table_value(const IndexTable& table, const std::string& name, const std::string& what, double nm) {
    const std::vector<double>& nodes = table.wavelength_nm;
    if (!covers(table, nm)) return outside(name, what, nm, nodes.front(), nodes.back());
    // The rows that the value depends on: a node alone, else all rows of both neighbors.
    auto first = std::lower_bound(nodes.begin(), nodes.end(), nm);
    if (*first != nm) first = std::lower_bound(nodes.begin(), first, *(first - 1));
    const auto last = std::upper_bound(first, nodes.end(), *std::lower_bound(first, nodes.end(), nm));
    for (auto row = first; row != last; ++row) {
        const double value = table.value[static_cast<std::size_t>(row - nodes.begin())];
        const std::string at = what + " = " + number_text(value) + " at " + number_text(*row) + " nm";
        if (value < 0.0 || (value == 0.0 && what == "n"))
            return bad_row(name, at, "an index must be positive, an extinction not negative");
        if (row != first && *row == *(row - 1)) {
            const double other = table.value[static_cast<std::size_t>(row - nodes.begin()) - 1];
            return bad_row(name, at + " and " + number_text(other) + " in another row", "only one can be right");
        }
    }
    return interpolate(nodes, table.value, nm);
}

Result<double> block_value(const IndexBlock& block, const std::string& name, double nm) {
    if (const auto* table = std::get_if<IndexTable>(&block)) return table_value(*table, name, "n", nm);
    const auto& formula = std::get<DispersionFormula>(block);
    if (!covers(block, nm)) return outside(name, "the dispersion formula", nm, formula.min_nm, formula.max_nm);
    const double value = formula_value(formula, nm / 1000.0);
    if (!gives_square(formula.number)) return value;
    if (!(value > 0.0) || !std::isfinite(value)) return no_index(name, "n^2", nm, value);
    return std::sqrt(value);
}

/// The value of the block that reaches `nm`, the first or one of `more`; several that do must agree.
template <class Block, class Value>
Result<double> value_of_blocks(const std::string& name, const std::string& what, const Block& first,
                               const std::vector<Block>& more, double nm, const Value& value) {
    std::vector<const Block*> reaching;
    if (covers(first, nm)) reaching.push_back(&first);
    for (const Block& block : more)
        if (covers(block, nm)) reaching.push_back(&block);
    if (reaching.empty()) return value(first);
    const Result<double> found = value(*reaching.front());
    for (const Block* block : reaching) {
        if (!found) break;
        POL_TRY(const auto other, value(*block));
        if (other != found.value())
            return bad_row(name,
                           what + " = " + number_text(found.value()) + " in one block and " + number_text(other) +
                               " in another at " + number_text(nm) + " nm",
                           "only one can be right");
    }
    return found;
}

bool has_extinction(const DispersiveIndex& index, double nm) {
    const auto reaches = [nm](const IndexTable& table) { return covers(table, nm); };
    return reaches(index.k) || std::any_of(index.more_k.begin(), index.more_k.end(), reaches);
}

Result<ComplexIndex> dispersive_index(const DispersiveIndex& index, double nm) {
    const Result<double> n = value_of_blocks(index.name, "n", index.n, index.more_n, nm, [&](const IndexBlock& block) {
        return block_value(block, index.name, nm);
    });
    if (!n) return n.error();
    if (!(n.value() > 0.0) || !std::isfinite(n.value())) return no_index(index.name, "n", nm, n.value());
    if (!has_extinction(index, nm)) return ComplexIndex{n.value(), 0.0};
    const Result<double> k = value_of_blocks(index.name, "k", index.k, index.more_k, nm, [&](const IndexTable& table) {
        return table_value(table, index.name, "k", nm);
    });
    if (!k) return k.error();
    return ComplexIndex{n.value(), k.value()};
}

}  // namespace

std::string coefficient_problem(int number, std::size_t count) {
    constexpr std::size_t most_pairs = 63;
    const auto at_most = [&](std::size_t most) {
        return count >= 1 && count <= most ? "" : "one to " + std::to_string(most) + " coefficients";
    };
    if (number == 7 || number == 9) return at_most(6);
    if (number == 8) return at_most(4);
    if (count % 2 == 0 || count > most_pairs)
        return "a constant and then pairs: an odd number, at most " + std::to_string(most_pairs);
    if (number == 4 && (count == 3 || count == 7)) return "a constant, then up to two groups of four, then pairs";
    return {};
}

IndexTable index_table(std::vector<std::pair<double, double>> rows) {
    std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    IndexTable table;
    for (const auto& [nm, value] : rows) {
        const bool is_repeated =
            !table.value.empty() && table.wavelength_nm.back() == nm && table.value.back() == value;
        if (is_repeated) continue;
        table.wavelength_nm.push_back(nm);
        table.value.push_back(value);
    }
    return table;
}

Result<ComplexIndex> index_at(const RefractiveIndex& index, double wavelength_nm) {
    return std::visit(Overloaded{
                          [](const ConstantIndex& i) -> Result<ComplexIndex> { return i.value; },
                          [&](const DispersiveIndex& i) { return dispersive_index(i, wavelength_nm); },
                      },
                      index);
}

bool extinction_is_unknown(const RefractiveIndex& index, double wavelength_nm) {
    const auto* dispersive = std::get_if<DispersiveIndex>(&index);
    return dispersive != nullptr && !dispersive->k.wavelength_nm.empty() && !has_extinction(*dispersive, wavelength_nm);
}

bool is_constant(const RefractiveIndex& index) {
    return std::holds_alternative<ConstantIndex>(index);
}

}  // namespace pol
