// SPDX-License-Identifier: Apache-2.0
// Textbook formulas that facts are held to. Written from the books, in the books' form, and apart from those of
// optics/: the one checks the other.
#pragma once

#include <cmath>

#include "core/complex.h"
#include "core/units.h"
#include "polarization/stokes.h"
#include "verify/facts/literal_calcite.h"

namespace pol::verify {

/// Fresnel's formulas as Born & Wolf write them (7th ed., 1.5.2 and 14.4.1), signs after Verdet, for any complex index
/// n = n2/n1 and the angle of incidence i.
struct ClosedFresnel {
    Complex<double> r_s, r_p;
    ClosedFresnel(Complex<double> n, double i) {
        const Complex<double> c(std::cos(i));
        const Complex<double> cos_t = sqrt_decaying(Complex<double>(1.0) - std::sin(i) * std::sin(i) / (n * n));
        r_s = (c - n * cos_t) / (c + n * cos_t);
        r_p = (n * c - cos_t) / (n * c + cos_t);
    }
    [[nodiscard]] double R_s() const { return norm2(r_s); }
    [[nodiscard]] double R_p() const { return norm2(r_p); }
    /// Stokes vector of reflected light of unit power that was linear at +45 degrees between s and p.
    [[nodiscard]] Stokes<double> of_diagonal_light() const {
        const Complex<double> xy = r_s * conj(r_p);
        return {0.5 * (R_s() + R_p()), 0.5 * (R_s() - R_p()), xy.re, xy.im};
    }
};

/// Fresnel at normal incidence between air and the index n.
inline double normal_reflectance(double n) {
    return std::pow((n - 1.0) / (n + 1.0), 2);
}

/// Transmittance of a pile of `count` plates with the reflectance R of a face, all incoherent passes: Stokes 1862.
inline double pile_transmittance(int count, double reflectance) {
    return (1.0 - reflectance) / (1.0 + (2.0 * count - 1.0) * reflectance);
}

/// Of one plate of index n at normal incidence: 2n/(n^2 + 1).
inline double plate_transmittance(double n) {
    return 2.0 * n / (n * n + 1.0);
}

/// delta_p - delta_s of one total reflection in a medium of relative index n at the angle `i` (PHYSICS.md 2.1).
inline double retardance(double n, double i) {
    const double sin2 = std::pow(std::sin(i), 2);
    return -2.0 * std::atan(std::cos(i) * std::sqrt(sin2 - 1.0 / (n * n)) / sin2);
}

constexpr double n_o = calcite_n_o;
constexpr double n_e = calcite_n_e;
constexpr double eps_o = n_o * n_o;
constexpr double eps_e = n_e * n_e;

/// Index of the e wave at the angle theta between wave normal and axis.
inline double e_index(double theta) {
    return 1.0 / std::sqrt(std::pow(std::cos(theta) / n_o, 2) + std::pow(std::sin(theta) / n_e, 2));
}

/// Degree of polarization of light whose two orthogonal linear parts have these powers.
inline double dop_of(double a, double b) {
    return std::abs(a - b) / (a + b);
}

}  // namespace pol::verify
