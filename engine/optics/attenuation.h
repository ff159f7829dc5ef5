// SPDX-License-Identifier: Apache-2.0
// Beer-Lambert absorption along a ray. Power falls as exp(-alpha length).
#pragma once

#include <cmath>

#include "core/exponential.h"
#include "core/vec.h"

namespace pol {

/// Absorption coefficients of a medium at one wavelength, power per scene unit of length.
/// `ordinary` is for E across the optic axis (and the only one of an isotropic medium), `extraordinary` for E along it.
struct AbsorptionAt {
    double ordinary = 0.0;
    double extraordinary = 0.0;

    [[nodiscard]] bool absorbs() const { return ordinary != 0.0 || extraordinary != 0.0; }
    friend bool operator==(const AbsorptionAt&, const AbsorptionAt&) = default;
};

/// What becomes of a wave along a segment.
template <class Real>
struct Attenuation {
    Real lost{};       ///< share of the power that is absorbed, 1 - exp(-alpha length)
    Real amplitude{};  ///< factor of the field, exp(-alpha length / 2)
};

template <class Real>
Attenuation<Real> attenuation(const Real& alpha, const Real& length) {
    return {-exponential_less_one(-alpha * length), exponential(Real(-0.5) * alpha * length)};
}

/// Absorption coefficient along the ray of a wave in an isotropic medium of index n + i kappa, `k` the real part of its
/// wave vector. Behind a plane face the wave has Im k along the normal, and Re k . Im k = n kappa however it leans: the
/// power falls as exp(-alpha n/|k| length) along k. |k| = n for a wave of real direction.
template <class Real>
Real pair_absorption(const AbsorptionAt& alpha, const Real& n, const Vec3<Real>& k) {
    using std::sqrt;
    return Real(alpha.ordinary) * n / sqrt(length2(k));
}

/// Absorption coefficient of a weakly absorbing crystal mode along its ray (PHYSICS.md 2.9):
/// alpha = k0 E^H eps'' E / |Re(E x H*)| with eps'' = n alpha / k0 along each principal axis and, for unit E,
/// |E x H| = dot(k, ray). Reduces to `ordinary` for an o wave and to `extraordinary` for an e wave across the axis.
/// Requires: `field`, `ray` and `axis` unit, dot(k, ray) > 0.
template <class Real>
Real mode_absorption(const AbsorptionAt& alpha, const Real& n_o, const Real& n_e, const Vec3<Real>& axis,
                     const Vec3<Real>& field, const Vec3<Real>& k, const Vec3<Real>& ray) {
    const Real along = dot(field, axis);
    const Real across2 = length2(cross(field, axis));
    return (n_o * Real(alpha.ordinary) * across2 + n_e * Real(alpha.extraordinary) * along * along) / dot(k, ray);
}

}  // namespace pol
