// SPDX-License-Identifier: Apache-2.0
// Jones calculus: fully polarized fields and what acts on them. Fields vary as exp(i(k.r - omega t)).
#pragma once

#include "core/complex.h"

namespace pol {

/// Complex field amplitudes along x and y of a stated frame; |x|^2 + |y|^2 is the power.
template <class Real>
struct JonesVector {
    Complex<Real> x{};
    Complex<Real> y{};
    friend constexpr bool operator==(const JonesVector&, const JonesVector&) = default;
};

/// 2x2 complex matrix between two stated frames, rows first: out.x = xx in.x + xy in.y.
template <class Real>
struct JonesMatrix {
    Complex<Real> xx{};
    Complex<Real> xy{};
    Complex<Real> yx{};
    Complex<Real> yy{};

    static constexpr JonesMatrix identity() { return {Real(1), Real(0), Real(0), Real(1)}; }

    friend constexpr JonesMatrix operator*(const JonesMatrix& a, const JonesMatrix& b) {
        return {a.xx * b.xx + a.xy * b.yx, a.xx * b.xy + a.xy * b.yy, a.yx * b.xx + a.yy * b.yx,
                a.yx * b.xy + a.yy * b.yy};
    }
    friend constexpr JonesVector<Real> operator*(const JonesMatrix& a, const JonesVector<Real>& v) {
        return {a.xx * v.x + a.xy * v.y, a.yx * v.x + a.yy * v.y};
    }
    friend constexpr bool operator==(const JonesMatrix&, const JonesMatrix&) = default;
};

/// The same path walked the other way, with the same field vectors (PHYSICS.md 2.8).
template <class Real>
constexpr JonesMatrix<Real> transpose(const JonesMatrix<Real>& a) {
    return {a.xx, a.yx, a.xy, a.yy};
}

template <class Real>
constexpr JonesMatrix<Real> adjoint(const JonesMatrix<Real>& a) {
    return {conj(a.xx), conj(a.yx), conj(a.xy), conj(a.yy)};
}

/// tr(A^H A)/2: the share of unpolarized light that A passes. The weight of a tree node (CUTTING.md 1.1).
template <class Real>
constexpr Real mean_transmittance(const JonesMatrix<Real>& a) {
    return (norm2(a.xx) + norm2(a.xy) + norm2(a.yx) + norm2(a.yy)) / Real(2);
}

/// Rewrites fields in a frame turned by `angle` radians counter-clockwise (x towards y, seen by the receiver):
/// R = [[c, s], [-s, c]].
template <class Real>
JonesMatrix<Real> basis_rotation(const Real& angle) {
    using std::cos;
    using std::sin;
    const Real c = cos(angle);
    const Real s = sin(angle);
    return {c, s, -s, c};
}

}  // namespace pol
