// SPDX-License-Identifier: Apache-2.0
#include "spectrum/refractive_index.h"

#include <cmath>
#include <cstddef>

#include "core/number_text.h"
#include "core/overloaded.h"
#include "spectrum/interpolation.h"

namespace pol {
namespace {

/// One coefficient, 0 where the record stops.
double coefficient(const std::vector<double>& c, std::size_t i) {
    return i < c.size() ? c[i] : 0.0;
}

/// n^2 of formulas 1 to 4, n of formulas 5 and 6, wavelength in micrometres. Numbering and order of the coefficients as
/// in the documentation of the refractiveindex.info database ("Dispersion formulas").
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
        default:
            return std::nan("");
    }
}

Error outside(const std::string& name, const char* what, double nm, double first, double last) {
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

Result<double> table_value(const IndexTable& table, const std::string& name, const char* what, double nm) {
    const double first = table.wavelength_nm.front();
    const double last = table.wavelength_nm.back();
    if (!(nm >= first && nm <= last)) return outside(name, what, nm, first, last);
    return interpolate(table.wavelength_nm, table.value, nm);
}

Result<double> real_index(const DispersiveIndex& index, double nm) {
    if (const auto* table = std::get_if<IndexTable>(&index.n)) return table_value(*table, index.name, "n", nm);
    const auto& formula = std::get<DispersionFormula>(index.n);
    if (!(nm >= formula.min_nm && nm <= formula.max_nm)) {
        return outside(index.name, "the dispersion formula", nm, formula.min_nm, formula.max_nm);
    }
    const double value = formula_value(formula, nm / 1000.0);
    if (formula.number >= 5) return value;
    if (!(value > 0.0) || !std::isfinite(value)) return no_index(index.name, "n^2", nm, value);
    return std::sqrt(value);
}

Result<ComplexIndex> dispersive_index(const DispersiveIndex& index, double nm) {
    const Result<double> n = real_index(index, nm);
    if (!n) return n.error();
    if (!(n.value() > 0.0) || !std::isfinite(n.value())) return no_index(index.name, "n", nm, n.value());
    if (index.k.wavelength_nm.empty()) return ComplexIndex{n.value(), 0.0};
    const Result<double> k = table_value(index.k, index.name, "k", nm);
    if (!k) return k.error();
    if (!(k.value() >= 0.0) || !std::isfinite(k.value())) return no_index(index.name, "k", nm, k.value());
    return ComplexIndex{n.value(), k.value()};
}

}  // namespace

Result<ComplexIndex> index_at(const RefractiveIndex& index, double wavelength_nm) {
    return std::visit(Overloaded{
                          [](const ConstantIndex& i) -> Result<ComplexIndex> { return i.value; },
                          [&](const DispersiveIndex& i) { return dispersive_index(i, wavelength_nm); },
                      },
                      index);
}

bool is_constant(const RefractiveIndex& index) {
    return std::holds_alternative<ConstantIndex>(index);
}

}  // namespace pol
