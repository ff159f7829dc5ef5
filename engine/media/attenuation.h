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
inline double mode_absorption(const AbsorptionAt& alpha, double n_o, double n_e, const DVec3& axis, const DVec3& field,
                              const DVec3& k, const DVec3& ray) {
    const double along = dot(field, axis);
    const double across2 = length2(cross(field, axis));
    return (n_o * alpha.ordinary * across2 + n_e * alpha.extraordinary * along * along) / dot(k, ray);
}

}  // namespace pol
