// SPDX-License-Identifier: Apache-2.0
// Fresnel's formulas for isotropic media, transparent, absorbing or metals (PHYSICS.md 2.1, 2.2).
//
// Everything follows from q1 = n1 cos(theta1), the normal component of the incident wave vector in units of omega/c: so
// that grazing incidence keeps its relative accuracy. With kappa^2 = k_t^2 = n1^2 - q1^2, which both media share,
//     n2^2 q1 + n1^2 q2 = (q1 + q2)(q1 q2 + kappa^2),
// so r_p = -r_s (q1 q2 - kappa^2)/(q1 q2 + kappa^2) (Fresnel's tangent law), and no difference of nearly equal indices
// is ever formed but n1 - n2 itself. Verdet signs: r_p = -r_s at normal incidence.
#pragma once

#include <cmath>

#include "core/complex.h"
#include "core/lanes.h"

namespace pol {

/// Amplitudes of a dielectric boundary. t_s, t_p are flux-normalised: t^2 is the transmittance, and the
/// same in both directions. Their phase is zero (they are zero beyond the critical angle: nothing is transmitted).
template <class Real>
struct Fresnel {
    Complex<Real> r_s{};
    Complex<Real> r_p{};
    Real t_s{};
    Real t_p{};
    Real q2{};             ///< n2 cos(theta2); if `total`, the decay rate Im q2 >= 0 of the field behind
    MaskOf<Real> total{};  ///< at or beyond the critical angle: T = 0
};

/// Requires: n1 > 0, n2 > 0, 0 < q1 <= n1. Both sides of the critical angle share the roots and the divisions, so that
/// lanes need not part (core/lanes.h).
template <class Real>
Fresnel<Real> fresnel(Real n1, Real n2, Real q1) {
    using std::sqrt;
    const Real contrast = (n1 - n2) * (n1 + n2);  // n1^2 - n2^2 = q1^2 - q2^2
    const Real q2_squared = q1 * q1 - contrast;
    const Real k_t2 = (n1 - q1) * (n1 + q1);
    const auto goes_on = q2_squared > Real(0);
    const Real q2 = sqrt(select(goes_on, q2_squared, -q2_squared));
    const Real product = q1 * q2;
    // Beyond: q2 = i decay: r = (q1 - q2)/(q1 + q2) = (q1 - i decay)^2/(q1^2 + decay^2), and likewise for r_p/r_s.
    const Complex<Real> half_s(q1, -q2);
    const Complex<Real> half_p(k_t2, -product);
    const Real per_s = Real(1) / select(goes_on, q1 + q2, norm2(half_s));
    const Real per_p = Real(1) / select(goes_on, product + k_t2, norm2(half_p));
    const Real r_s = contrast * per_s * per_s;
    const Real r_p = r_s * (k_t2 - product) * per_p;
    const Real t_s = Real(2) * sqrt(product) * per_s;
    const Complex<Real> total_s = half_s * half_s * per_s;
    const Complex<Real> total_p = total_s * (half_p * half_p * per_p);
    return {{select(goes_on, r_s, total_s.re), select(goes_on, Real(0), total_s.im)},
            {select(goes_on, r_p, total_p.re), select(goes_on, Real(0), total_p.im)},
            select(goes_on, t_s, Real(0)),
            select(goes_on, t_s * n1 * n2 * per_p, Real(0)),
            q2,
            !goes_on};
}

/// Normal component of the wave vector in a medium n2 + i kappa2: Im q2 > 0 where it absorbs. `n1` is the |k| of a wave
/// at the same boundary, real part, and `q1` the normal component of that.
template <class Real>
Complex<Real> conductor_q(Real n1, Real n2, Real kappa2, Real q1) {
    return sqrt_decaying(Complex<Real>((n2 - n1) * (n2 + n1) - kappa2 * kappa2 + q1 * q1, Real(2) * n2 * kappa2));
}

/// Amplitudes of a boundary with an absorbing medium on either side or both: Fresnel's formulas with complex indices.
/// What flows into medium 2 comes from the field inside, so it and r check each other: |r|^2 + into + mixed = 1.
template <class Real>
struct AbsorbingFresnel {
    Complex<Real> r_s{};
    Complex<Real> r_p{};
    /// Flux-normalised, |t|^2 = into, less the phase of sqrt(q1 q2), which s and p share. Two faces in a row give the
    /// exact product of Fresnel's amplitudes.
    Complex<Real> t_s{};
    Complex<Real> t_p{};
    Real into_s{};  ///< shares of the incident power that flow into medium 2
    Real into_p{};
    /// In an absorbing medium 1 the incident and the reflected wave do not carry their powers independently: 1 - |r|^2
    /// - into is not 0 but this, of either sign.
    Real mixed_s{};
    Real mixed_p{};
    Complex<Real> q2{};
    /// The wave behind advances faster than it decays, Re q2 >= Im q2. Else it dies within a wavelength/(4 pi n2) or
    /// two, and only metals and total reflection make such waves: they are counted as absorbed at the surface.
    MaskOf<Real> goes_on{};
};

/// Requires: n1, n2 > 0, kappa1, kappa2 >= 0, one of them > 0 or medium 2 a conductor. `k1` is the length of the real
/// part of the incident wave vector, `q` its normal component, 0 < q <= k1; all waves share k_t^2 = k1^2 - q^2, real.
template <class Real>
AbsorbingFresnel<Real> absorbing_fresnel(const Complex<Real>& n1, const Complex<Real>& n2, Real k1, Real q) {
    using std::sqrt;
    const Complex<Real> eps1((n1.re - n1.im) * (n1.re + n1.im), Real(2) * n1.re * n1.im);
    const Complex<Real> eps2((n2.re - n2.im) * (n2.re + n2.im), Real(2) * n2.re * n2.im);
    const Complex<Real> contrast((n1.re - n2.re) * (n1.re + n2.re) - (n1.im - n2.im) * (n1.im + n2.im),
                                 eps1.im - eps2.im);
    const Complex<Real> q1 = conductor_q(k1, n1.re, n1.im, q);
    const Complex<Real> q2 = conductor_q(k1, n2.re, n2.im, q);
    const Complex<Real> product = q1 * q2;
    const Complex<Real> k_t2((k1 - q) * (k1 + q));
    const Complex<Real> sum = q1 + q2;
    const Complex<Real> sum_p = product + k_t2;
    AbsorbingFresnel<Real> result;
    result.q2 = q2;
    result.goes_on = q2.im <= q2.re;
    result.r_s = quotient(contrast, sum * sum);
    result.r_p = result.r_s * quotient(k_t2 - product, sum_p);
    // The flux of unit E_s is Re q, of unit H_p Re(q/eps); behind the boundary E_s = 2 q1/sum and H_p = 2 eps2 q1/(sum
    // sum_p).
    const Complex<Real> y1 = q1 * conj(eps1);
    const Real incident = norm2(q1) / norm2(sum);
    result.into_s = Real(4) * incident * (q2.re / q1.re);
    result.into_p = Real(4) * incident * (norm2(eps1) * ((q2 * conj(eps2)).re / y1.re) / norm2(sum_p));
    // The flux before the boundary, Re(conj(q1) (1 + r)(1 - conj r)), less that of each wave alone.
    result.mixed_s = Real(-2) * (q1.im / q1.re) * result.r_s.im;
    result.mixed_p = Real(-2) * (y1.im / y1.re) * result.r_p.im;
    const Complex<Real> phase_p = n1 * n2 * conj(sum * sum_p);
    result.t_s = conj(sum) * sqrt(result.into_s / norm2(sum));
    result.t_p = phase_p * sqrt(result.into_p / norm2(phase_p));
    return result;
}

}  // namespace pol
