// SPDX-License-Identifier: Apache-2.0
// What a person wants to know about a polarization state, in forms that neither cancel nor overflow
// (PHYSICS.md 1, "Derived quantities").
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "core/hypot.h"
#include "core/units.h"
#include "core/vec.h"
#include "polarization/jones.h"
#include "polarization/stokes.h"

namespace pol {

/// Noise threshold tau of a Stokes vector that was summed from `terms` parts, relative to S0: rounding leaves about
/// 1e-15 per term in each component (PHYSICS.md 1, "Undefined states").
template <class Real = double>
constexpr Real noise_threshold(double terms) {
    return Real(terms * 1e-15);
}

/// Values where a flag is false are placeholders: 0. Every value is NaN if the Stokes vector is no light at all:
/// not finite, S0 < 0, or S0 = 0 with a polarized part.
template <class Real>
struct Measures {
    Real dop{};                ///< degree of polarization, 0 to 1 (above 1 only by rounding or by a defect)
    Real dolp{};               ///< degree of linear polarization
    Real docp{};               ///< degree of circular polarization, >= 0; the sign is `handedness`
    Real unpolarized{};        ///< 1 - dop, absolute accuracy epsilon; unpolarized_fraction() is better near 0
    Real ellipticity{};        ///< b/a, 0 linear to 1 circular; 0 if unpolarized
    Real ellipticity_angle{};  ///< chi, -pi/4 to pi/4, positive is right-handed
    Real azimuth{};            ///< psi, of the major axis from x towards y, -pi/2 to pi/2 (both ends are one direction)
    int handedness = 0;        ///< +1 right (S3 > 0), -1 left, 0 linear within noise or undefined
    bool has_light = false;    ///< S0 > 0
    bool has_polarization = false;  ///< polarized part above noise: ellipticity means something
    bool has_azimuth = false;       ///< linear part above noise: azimuth means something
};

/// Length of the linear part, sqrt(s1^2 + s2^2).
template <class Real>
Real linear_part(const Stokes<Real>& s) {
    return hypot(s.s1, s.s2);
}

/// Length of the polarized part, sqrt(s1^2 + s2^2 + s3^2).
template <class Real>
Real polarized_part(const Stokes<Real>& s) {
    return hypot(hypot(s.s1, s.s2), s.s3);
}

/// All measures of `s`. Parts of the vector up to `tau` S0 count as rounding noise.
///
/// Exact under scaling by powers of two, for S0 from 1e-300 to 1e300 (normal numbers).
template <class Real>
Measures<Real> measure(const Stokes<Real>& s, const Real& tau = noise_threshold<Real>(1)) {
    using std::abs;
    using std::atan2;
    using std::isfinite;

    Measures<Real> result;
    const Real linear = linear_part(s);
    const Real polarized = polarized_part(s);
    const bool is_light =
        isfinite(s.s0) && isfinite(polarized) && (s.s0 > Real(0) || (s.s0 == Real(0) && polarized == Real(0)));
    if (!is_light) {
        const Real nan = std::numeric_limits<Real>::quiet_NaN();
        result.dop = result.dolp = result.docp = result.unpolarized = nan;
        result.ellipticity = result.ellipticity_angle = result.azimuth = nan;
        return result;
    }
    if (s.s0 == Real(0)) return result;

    result.has_light = true;
    result.dop = polarized / s.s0;
    result.dolp = linear / s.s0;
    result.docp = abs(s.s3) / s.s0;
    result.unpolarized = (s.s0 - polarized) / s.s0;

    // Rounding leaves noise of order tau S0, not tau p, in each component: weakly polarized light has it too.
    result.has_polarization = result.dop > tau;
    result.has_azimuth = result.dolp > tau;
    if (result.has_polarization) {
        result.ellipticity = abs(s.s3) / (polarized + linear);
        result.ellipticity_angle = atan2(s.s3, linear) / Real(2);
        if (result.docp > tau) result.handedness = s.s3 > Real(0) ? 1 : -1;
    }
    // Adding 0 turns -0 into 0, so that a vertical state is +pi/2 whatever the sign of its zero.
    if (result.has_azimuth) result.azimuth = atan2(s.s2 + Real(0), s.s1) / Real(2);
    return result;
}

/// Angle between two azimuths as undirected lines, 0 to pi/2.
inline double line_angle(double a, double b) {
    const double apart = std::abs(std::remainder(a - b, pi));
    return std::min(apart, pi - apart);
}

/// Half the angle between two states on the Poincare sphere, 0 to pi/2; from the cross product too: acos loses half the
/// digits. Of light without polarization it is 0.
inline double half_poincare_angle(const Stokes<double>& a, const Stokes<double>& b) {
    const DVec3 u(a.s1, a.s2, a.s3);
    const DVec3 v(b.s1, b.s2, b.s3);
    return 0.5 * std::atan2(std::sqrt(length2(cross(u, v))), dot(u, v));
}

/// Tip of the field of fully polarized light of power 1 at the phase omega t, Re[E exp(-i omega t)] in the frame (x,
/// y); phase 0 is an end of the major axis. Right-handed light (chi > 0) turns clockwise for the receiver, who sees y a
/// quarter turn counter-clockwise from x. Angles in radians.
inline DVec2 field_tip(double azimuth, double ellipticity_angle, double phase) {
    const double along = std::cos(ellipticity_angle) * std::cos(phase);
    const double across = -std::sin(ellipticity_angle) * std::sin(phase);
    const double c = std::cos(azimuth);
    const double s = std::sin(azimuth);
    return {c * along - s * across, s * along + c * across};
}

/// 1 - P of the incoherent sum of fully polarized fields, with relative accuracy even where it is tiny:
/// 4 det J / (tr^2 J (1 + P)), det J = sum over i < j of |v_i x v_j|^2. Quadratic in the number of fields; 0 for none.
template <class Real>
Real unpolarized_fraction(std::span<const JonesVector<Real>> fields) {
    using std::sqrt;
    Real largest(0);
    for (const JonesVector<Real>& v : fields) {
        for (const Real& part : {v.x.re, v.x.im, v.y.re, v.y.im}) {
            const Real size = part < Real(0) ? -part : part;
            if (size > largest) largest = size;
        }
    }
    if (largest == Real(0)) return Real(0);

    Stokes<Real> sum;
    Real determinant(0);
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const Complex<Real> x = fields[i].x / largest;
        const Complex<Real> y = fields[i].y / largest;
        const Complex<Real> xy = x * conj(y);
        sum += {norm2(x) + norm2(y), norm2(x) - norm2(y), Real(2) * xy.re, Real(2) * xy.im};
        for (std::size_t j = 0; j < i; ++j) {
            determinant += norm2(x * (fields[j].y / largest) - y * (fields[j].x / largest));
        }
    }
    const Real p = polarized_part(sum) / sum.s0;
    return Real(4) * determinant / (sum.s0 * sum.s0 * (Real(1) + p));
}

}  // namespace pol
