// SPDX-License-Identifier: Apache-2.0
// The frame in which boundary problems are simple: wave vectors of all waves at the boundary are (k_t, 0, q).
#pragma once

#include <cmath>
#include <limits>

#include "core/vec.h"

namespace pol {

/// Right-handed frame (x, s, normal): x along the tangential wave vector, s = unit(normal x k).
template <class Real>
struct IncidenceFrame {
    Vec3<Real> x{};
    Vec3<Real> s{};
    Vec3<Real> normal{};
    Vec3<Real> tangential{};  ///< tangential wave vector in the world, as all waves at the boundary share it
    Real k_t{};               ///< its length; >= 0
    Real q{};                 ///< normal component of the incident wave vector

    [[nodiscard]] Vec3<Real> to_local(const Vec3<Real>& world) const {
        return {dot(x, world), dot(s, world), dot(normal, world)};
    }
    [[nodiscard]] Vec3<Real> to_world(const Vec3<Real>& local) const {
        return local.x * x + local.y * s + local.z * normal;
    }
    /// World wave vector with normal component `q_out`.
    [[nodiscard]] Vec3<Real> wave_vector(const Real& q_out) const { return tangential + q_out * normal; }
};

/// Requires: `normal` is unit, k is not zero.
///
/// Where k is normal to the boundary, s is the world axis least aligned with it, made tangential. Next to that, where
/// normal x k is nearly all rounding, the frame stays orthonormal: s is cleaned of its normal component after scaling.
template <class Real>
IncidenceFrame<Real> incidence_frame(const Vec3<Real>& normal, const Vec3<Real>& k) {
    using std::sqrt;
    IncidenceFrame<Real> frame;
    frame.normal = normal;
    frame.q = dot(normal, k);
    frame.tangential = k - frame.q * normal;
    Vec3<Real> s = cross(normal, k);
    const Real sine2 = length2(s);
    const Real size2 = length2(k);
    const Real noise = Real(4) * std::numeric_limits<Real>::epsilon();
    const Real clean = Real(1) / Real(16);
    if (sine2 <= noise * noise * size2) {
        const Vec3<Real> axis = least_aligned_axis(normal);
        s = unit(axis - dot(axis, normal) * normal);
    } else {
        s = s * (Real(1) / sqrt(sine2));
        if (sine2 <= clean * clean * size2) s = unit(s - dot(s, normal) * normal);
    }
    frame.s = s;
    frame.x = cross(s, normal);
    frame.k_t = dot(frame.x, k);
    return frame;
}

}  // namespace pol
