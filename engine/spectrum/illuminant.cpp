// SPDX-License-Identifier: Apache-2.0
#include "spectrum/illuminant.h"

#include <algorithm>
#include <string>
#include <vector>

#include "core/number_text.h"
#include "core/overloaded.h"
#include "spectrum/color.h"
#include "spectrum/interpolation.h"
#include "spectrum/tables.h"

namespace pol {
namespace {

Error outside(const std::string& what, double nm, double first, double last) {
    return Error{
        ErrorKind::input,
        number_text(nm) + " nm is outside " + what + ", " + number_text(first) + " to " + number_text(last) + " nm",
        {},
        {},
        "render at wavelengths inside, or give a spectrum that covers them"};
}

Result<double> evaluate_table(const TabulatedSpectrum& table, double nm) {
    if (table.wavelength_nm.empty() || table.wavelength_nm.size() != table.value.size()) {
        return Error{ErrorKind::input, "a spectrum table needs as many values as wavelengths, at least one"};
    }
    const double first = table.wavelength_nm.front();
    const double last = table.wavelength_nm.back();
    if (!(nm >= first && nm <= last)) return outside("the table of the spectrum", nm, first, last);
    return interpolate(table.wavelength_nm, table.value, nm);
}

}  // namespace

bool d65_covers(double wavelength_nm) {
    return wavelength_nm >= tables::d65().front()[0] && wavelength_nm <= tables::d65().back()[0];
}

Result<double> d65_at(double wavelength_nm) {
    const auto table = tables::d65();
    if (!d65_covers(wavelength_nm))
        return outside("CIE illuminant D65", wavelength_nm, table.front()[0], table.back()[0]);
    return tables::row_at(table, wavelength_nm)[1] / 100.0;
}

Result<double> evaluate(const Spectrum& spectrum, double wavelength_nm) {
    return std::visit(Overloaded{
                          [](const ConstantSpectrum& s) -> Result<double> { return s.value; },
                          [&](const TabulatedSpectrum& s) { return evaluate_table(s, wavelength_nm); },
                          [&](const D65Spectrum& s) -> Result<double> {
                              const Result<double> d65 = d65_at(wavelength_nm);
                              if (!d65) return d65;
                              return s.scale * d65.value();
                          },
                      },
                      spectrum);
}

double luminance(const Spectrum& spectrum) {
    constexpr int first_nm = 380;
    constexpr int last_nm = 780;
    std::vector<double> grid;
    std::vector<double> values;
    for (int nm = first_nm; nm <= last_nm; ++nm) {
        const double nearest =
            std::visit(Overloaded{
                           [&](const ConstantSpectrum&) { return double(nm); },
                           [&](const TabulatedSpectrum& s) {
                               return std::clamp(double(nm), s.wavelength_nm.front(), s.wavelength_nm.back());
                           },
                           [&](const D65Spectrum&) { return double(nm); },
                       },
                       spectrum);
        grid.push_back(nm);
        values.push_back(evaluate(spectrum, nearest).value());
    }
    return to_xyz(weighted_color(values, color_weights(grid)))[1];
}

}  // namespace pol
