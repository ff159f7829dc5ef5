// SPDX-License-Identifier: Apache-2.0
// The coherence matrix J = <E E^H> of a beam, fully or partially polarized.
#pragma once

#include "core/complex.h"
#include "polarization/jones.h"
#include "polarization/stokes.h"

namespace pol {

/// Hermitian 2x2 matrix in a stated frame (x, y, k): J_xx = xx, J_yy = yy, J_xy = <E_x E_y^*> = xy, J_yx = conj(xy).
///
/// Light is positive semidefinite, and stays so when it is only ever summed from outer products and transformed.
/// Small S1..S3 beside a large S0 lose relative precision in xx and yy: keep finished pixels as Stokes vectors.
template <class Real>
struct CoherenceMatrix {
    Real xx{};
    Real yy{};
    Complex<Real> xy{};

    /// Unpolarized light of radiance `s0`: half of it in each of any two orthogonal states.
    static constexpr CoherenceMatrix unpolarized(const Real& s0) { return {s0 / Real(2), s0 / Real(2), Real(0)}; }

    /// v v^H: a fully polarized beam.
    static constexpr CoherenceMatrix outer(const JonesVector<Real>& v) {
        return {norm2(v.x), norm2(v.y), v.x * conj(v.y)};
    }

    constexpr CoherenceMatrix& operator+=(const CoherenceMatrix& b) {
        xx += b.xx;
        yy += b.yy;
        xy += b.xy;
        return *this;
    }
    /// Incoherent superposition.
    friend constexpr CoherenceMatrix operator+(CoherenceMatrix a, const CoherenceMatrix& b) { return a += b; }
    friend constexpr CoherenceMatrix operator*(const Real& f, const CoherenceMatrix& a) {
        return {f * a.xx, f * a.yy, f * a.xy};
    }
    friend constexpr bool operator==(const CoherenceMatrix&, const CoherenceMatrix&) = default;
};

/// S0, the radiance.
template <class Real>
constexpr Real trace(const CoherenceMatrix<Real>& j) {
    return j.xx + j.yy;
}

/// Cancels for nearly polarized light: good to epsilon * trace^2 only. See unpolarized_fraction in measures.h.
template <class Real>
constexpr Real determinant(const CoherenceMatrix<Real>& j) {
    return j.xx * j.yy - norm2(j.xy);
}

/// PHYSICS.md 1: s2 = 2 Re J_xy, s3 = 2 Im J_xy.
template <class Real>
constexpr Stokes<Real> to_stokes(const CoherenceMatrix<Real>& j) {
    return {j.xx + j.yy, j.xx - j.yy, Real(2) * j.xy.re, Real(2) * j.xy.im};
}

/// |C|_F^2 = (S0^2 + |(S1, S2, S3)|^2)/2 of the matrix with this Stokes vector: the same in every frame.
template <class Real>
constexpr Real frobenius_square(const Stokes<Real>& s) {
    return (s.s0 * s.s0 + s.s1 * s.s1 + s.s2 * s.s2 + s.s3 * s.s3) / Real(2);
}

template <class Real>
constexpr CoherenceMatrix<Real> to_coherence(const Stokes<Real>& s) {
    return {(s.s0 + s.s1) / Real(2), (s.s0 - s.s1) / Real(2), {s.s2 / Real(2), s.s3 / Real(2)}};
}

/// A J A^H: the beam behind an element with Jones matrix A.
template <class Real>
constexpr CoherenceMatrix<Real> transform(const JonesMatrix<Real>& a, const CoherenceMatrix<Real>& j) {
    const Complex<Real> yx = conj(j.xy);
    // B = A J, then the rows of A again.
    const Complex<Real> b_xx = a[0][0] * j.xx + a[0][1] * yx;
    const Complex<Real> b_xy = a[0][0] * j.xy + a[0][1] * j.yy;
    const Complex<Real> b_yx = a[1][0] * j.xx + a[1][1] * yx;
    const Complex<Real> b_yy = a[1][0] * j.xy + a[1][1] * j.yy;
    return {(b_xx * conj(a[0][0]) + b_xy * conj(a[0][1])).re, (b_yx * conj(a[1][0]) + b_yy * conj(a[1][1])).re,
            b_xx * conj(a[1][0]) + b_xy * conj(a[1][1])};
}

/// The same light in a frame turned by `angle` radians counter-clockwise (x towards y):
/// s1' = s1 cos 2a + s2 sin 2a, s2' = -s1 sin 2a + s2 cos 2a, s0 and s3 as they were.
template <class Real>
Stokes<Real> rotate_basis(const Stokes<Real>& s, const Real& angle) {
    using std::cos;
    using std::sin;
    const Real c = cos(Real(2) * angle);
    const Real d = sin(Real(2) * angle);
    return {s.s0, c * s.s1 + d * s.s2, c * s.s2 - d * s.s1, s.s3};
}

}  // namespace pol
