// SPDX-License-Identifier: Apache-2.0
// As transparent_boundary.h, with an absorbing medium on either side or both, or a metal behind.
#pragma once

#include "core/lanes.h"
#include "core/vec.h"
#include "optics/fresnel.h"
#include "tracer/throughput.h"
#include "tracer/transparent_boundary.h"

namespace pol {

template <class Real>
struct AbsorbingBoundary {
    Vec3<Real> s{};
    PairChild<Real> reflected{};
    PairChild<Real> transmitted{};
    Real behind{};  ///< |k| of the transmitted wave, real part
    Real absorbed{};
    MaskOf<Real> reaches{};  ///< false: the ray does not go towards the boundary, a numerical failure
};

/// From n1 to n2, complex indices that differ. `k1` is the |k| of the incident wave, real part; `normal` is unit and
/// leans along the ray. Nothing is followed into `metal`.
template <class Real>
inline AbsorbingBoundary<Real> absorbing_boundary(const Vec3<Real>& ray, const Vec3<Real> (&field)[2],
                                                  const Throughput<Real>& throughput, const Vec3<Real>& normal,
                                                  const Complex<Real>& n1, const Complex<Real>& n2, const Real& k1,
                                                  bool metal) {
    using std::sqrt;
    AbsorbingBoundary<Real> out;
    const Real cos_1 = dot(normal, ray);
    out.reaches = cos_1 > Real(0);
    out.s = across_incidence(ray, field[0], normal);
    const Throughput<Real> m = in_basis(throughput, field, out.s, cross(ray, out.s));
    const AbsorbingFresnel<Real> f = absorbing_fresnel(n1, n2, k1, k1 * cos_1);
    out.reflected = pair_child(m, out.s, ray - normal * (Real(2) * cos_1), f.r_s, f.r_p);
    const Vec3<Real> k2 = (ray - normal * cos_1) * k1 + normal * f.q2.re;
    out.behind = sqrt(length2(k2));
    out.transmitted = pair_child(m, out.s, k2 / out.behind, f.t_s, f.t_p);
    const Real kept_s = metal ? Real(0) : select(f.goes_on, f.into_s, Real(0));
    const Real kept_p = metal ? Real(0) : select(f.goes_on, f.into_p, Real(0));
    out.transmitted.weight = metal ? Real(0) : select(f.goes_on, out.transmitted.weight, Real(0));
    out.absorbed = Real(0.5) * ((norm2(m.m[0][0]) + norm2(m.m[1][0])) * (f.mixed_s + (f.into_s - kept_s)) +
                                (norm2(m.m[0][1]) + norm2(m.m[1][1])) * (f.mixed_p + (f.into_p - kept_p)));
    return out;
}

}  // namespace pol
