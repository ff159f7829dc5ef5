// SPDX-License-Identifier: Apache-2.0
// Beer-Lambert absorption along a ray. Power falls as exp(-alpha length).
#pragma once

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

/// Absorption coefficient of a weakly absorbing crystal mode along its ray (physics.md 2.9):
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
