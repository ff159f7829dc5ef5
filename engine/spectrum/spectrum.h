// SPDX-License-Identifier: Apache-2.0
// A spectrum as the user writes it. Evaluation lives beside the tables it needs (illuminant.h).
#pragma once

#include <variant>
#include <vector>

namespace pol {

/// The same value at every wavelength.
struct ConstantSpectrum {
    double value = 0.0;
    friend bool operator==(const ConstantSpectrum&, const ConstantSpectrum&) = default;
};

/// Linear interpolation between nodes, wavelengths ascending in nm. Outside the nodes it is an error, not zero.
struct TabulatedSpectrum {
    std::vector<double> wavelength_nm;
    std::vector<double> value;
    friend bool operator==(const TabulatedSpectrum&, const TabulatedSpectrum&) = default;
};

/// `scale` times CIE illuminant D65 normalised to 1 at 560 nm.
struct D65Spectrum {
    double scale = 1.0;
    friend bool operator==(const D65Spectrum&, const D65Spectrum&) = default;
};

using Spectrum = std::variant<ConstantSpectrum, TabulatedSpectrum, D65Spectrum>;

}  // namespace pol
