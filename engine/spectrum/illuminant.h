// SPDX-License-Identifier: Apache-2.0
// Values of spectra: CIE D65, tables, constants.
#pragma once

#include "core/result.h"
#include "spectrum/spectrum.h"

namespace pol {

/// True if the CIE table of D65 has this wavelength: 300 to 830 nm.
bool d65_covers(double wavelength_nm);

/// CIE standard illuminant D65, 1 at 560 nm, linear between the 5 nm nodes of its definition.
/// Error (kind input) outside the table.
Result<double> d65_at(double wavelength_nm);

/// Value of a spectrum at a vacuum wavelength. Error (kind input) outside its table: nothing is extrapolated.
Result<double> evaluate(const Spectrum& spectrum, double wavelength_nm);

/// CIE 1931 luminance relative to that of D65 (1 at 560 nm), from 380 to 780 nm; a table's ends hold on beyond them. It
/// follows from the spectrum alone, whatever wavelengths a picture is made at.
double luminance(const Spectrum& spectrum);

}  // namespace pol
