// SPDX-License-Identifier: Apache-2.0
// Fresnel's formulas for an isotropic dielectric against an isotropic dielectric or a conductor (physics.md 2.1, 2.2).
//
// Everything follows from q1 = n1 cos(theta1), the normal component of the incident wave vector in units of omega/c: so
// that grazing incidence keeps its relative accuracy. With kappa^2 = k_t^2 = n1^2 - q1^2, which both media share,
//     n2^2 q1 + n1^2 q2 = (q1 + q2)(q1 q2 + kappa^2),
// so r_p = -r_s (q1 q2 - kappa^2)/(q1 q2 + kappa^2) (Fresnel's tangent law), and no difference of nearly equal indices
// is ever formed but n1 - n2 itself. Verdet signs: r_p = -r_s at normal incidence.
#pragma once

#include <cmath>

#include "core/complex.h"

namespace pol {

/// Amplitudes of a dielectric boundary. t_s, t_p are flux-normalised: t^2 is the transmittance, and the
/// same in both directions. Their phase is zero (they are not given beyond the critical angle: nothing is transmitted).
template <class Real>
struct Fresnel {
    Complex<Real> r_s{};
    Complex<Real> r_p{};
    Real t_s{};
    Real t_p{};
    Real q2{};           ///< n2 cos(theta2); if `total`, the decay rate Im q2 >= 0 of the field behind
    bool total = false;  ///< at or beyond the critical angle: T = 0
};

/// Requires: n1 > 0, n2 > 0, 0 < q1 <= n1.
template <class Real>
Fresnel<Real> fresnel(Real n1, Real n2, Real q1) {
    using std::sqrt;
    const Real contrast = (n1 - n2) * (n1 + n2);  // n1^2 - n2^2 = q1^2 - q2^2
    const Real q2_squared = q1 * q1 - contrast;
    const Real k_t2 = (n1 - q1) * (n1 + q1);
    if (q2_squared > Real(0)) {
        const Real q2 = sqrt(q2_squared);
        const Real product = q1 * q2;
        const Real per_sum = Real(1) / (q1 + q2);
        const Real per_p = Real(1) / (product + k_t2);
        const Real r_s = contrast * per_sum * per_sum;
        const Real t_s = Real(2) * sqrt(product) * per_sum;
        return {
            Complex<Real>(r_s), Complex<Real>(r_s * (k_t2 - product) * per_p), t_s, t_s * n1 * n2 * per_p, q2, false};
    }
    // q2 = i decay: r = (q1 - q2)/(q1 + q2) = (q1 - i decay)^2/(q1^2 + decay^2), and likewise for the factor of r_p.
    const Real decay = sqrt(-q2_squared);
    const Complex<Real> half_s(q1, -decay);
    const Complex<Real> half_p(k_t2, -q1 * decay);
    const Complex<Real> r_s = half_s * half_s / norm2(half_s);
    return {r_s, r_s * (half_p * half_p / norm2(half_p)), Real(0), Real(0), decay, true};
}

/// Amplitudes of a conductor's surface, and the shares of the incident power that flow into it. The latter come from
/// the field inside, so r and the absorbed shares check each other: |r|^2 + absorbed = 1.
template <class Real>
struct ConductorFresnel {
    Complex<Real> r_s{};
    Complex<Real> r_p{};
    Real absorbed_s{};
    Real absorbed_p{};
};

/// Normal component of the wave vector in a conductor n2 + i kappa2 behind an isotropic wave: Im q2 > 0 where it
/// absorbs. `n1` is the index that the incident wave sees, |k|.
template <class Real>
Complex<Real> conductor_q(Real n1, Real n2, Real kappa2, Real q1) {
    return sqrt_decaying(Complex<Real>((n2 - n1) * (n2 + n1) - kappa2 * kappa2 + q1 * q1, Real(2) * n2 * kappa2));
}

/// Requires: n1 > 0, n2 > 0, kappa2 >= 0, 0 < q1 <= n1.
template <class Real>
ConductorFresnel<Real> conductor_fresnel(Real n1, Real n2, Real kappa2, Real q1) {
    const Complex<Real> permittivity2((n2 - kappa2) * (n2 + kappa2), Real(2) * n2 * kappa2);
    const Complex<Real> contrast((n1 - n2) * (n1 + n2) + kappa2 * kappa2, -permittivity2.im);
    const Complex<Real> q2 = conductor_q(n1, n2, kappa2, q1);
    const Complex<Real> product = q1 * q2;
    const Complex<Real> k_t2((n1 - q1) * (n1 + q1));
    const Complex<Real> sum = q1 + q2;
    const Complex<Real> sum_p = product + k_t2;
    ConductorFresnel<Real> result;
    result.r_s = contrast / (sum * sum);
    result.r_p = result.r_s * ((k_t2 - product) / sum_p);
    // Flux into the metal: Re(q2)|E_s|^2, Re(q2 conj(eps2))|H_p/eps2|^2.
    result.absorbed_s = Real(4) * q1 * q2.re / norm2(sum);
    result.absorbed_p = Real(4) * q1 * n1 * n1 * (q2 * conj(permittivity2)).re / (norm2(sum) * norm2(sum_p));
    return result;
}

}  // namespace pol
