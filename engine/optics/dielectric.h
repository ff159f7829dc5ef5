// SPDX-License-Identifier: Apache-2.0
// A medium as a plane wave sees it at one wavelength.
#pragma once

#include <cstdint>

#include "core/vec.h"

namespace pol {

enum class MediumKind : std::uint8_t {
    isotropic,  ///< one 2x2 state per wave vector; a complex index if it absorbs
    uniaxial,   ///< ordinary and extraordinary modes, real indices
    conductor,  ///< complex index; nothing is followed into it
};

/// Optical constants of a medium at one wavelength, world frame.
///
/// Invariant: n > 0, n_e > 0, kappa >= 0, |axis| = 1. A uniaxial medium has n != n_e: equal indices are
/// made isotropic by `make_uniaxial`, so that glass and its crystal twin run the same arithmetic
/// (PHYSICS.md 4, case 14).
template <class Real>
struct Dielectric {
    MediumKind kind = MediumKind::isotropic;
    Real n{};      ///< ordinary index (uniaxial), else the index or its real part
    Real n_e{};    ///< extraordinary principal index; equals n unless uniaxial
    Real kappa{};  ///< imaginary part of the index n + i kappa, exp(-i omega t); 0 for uniaxial
    Vec3<Real> axis{Real(0), Real(0), Real(1)};  ///< optic axis, unit; its sign has no meaning

    /// Its surface needs the complex index.
    [[nodiscard]] bool is_complex() const { return kind == MediumKind::conductor || kappa != Real(0); }

    friend bool operator==(const Dielectric&, const Dielectric&) = default;
};

/// `kappa` is that of all its absorption: alpha = 4 pi kappa / lambda.
template <class Real>
Dielectric<Real> make_isotropic(const Real& n, const Real& kappa = Real(0)) {
    return {MediumKind::isotropic, n, n, kappa, {Real(0), Real(0), Real(1)}};
}

/// Requires: `axis` is not zero.
template <class Real>
Dielectric<Real> make_uniaxial(const Real& n_o, const Real& n_e, const Vec3<Real>& axis) {
    if (n_o == n_e) return make_isotropic(n_o);
    return {MediumKind::uniaxial, n_o, n_e, Real(0), unit(axis)};
}

template <class Real>
Dielectric<Real> make_conductor(const Real& n, const Real& kappa) {
    return {MediumKind::conductor, n, n, kappa, {Real(0), Real(0), Real(1)}};
}

}  // namespace pol
