// SPDX-License-Identifier: Apache-2.0
// A pair of modes at the boundary between two transparent isotropic media, without a branch: written once for a single
// ray (double) and for several side by side (core/lanes.h).
#pragma once

#include "core/lanes.h"
#include "core/vec.h"
#include "optics/fresnel.h"
#include "tracer/throughput.h"

namespace pol {

/// Half of what comes out. Its field vectors are TransparentBoundary::s and p. A weight of zero: it is not there.
template <class Real>
struct PairChild {
    Vec3<Real> ray{};
    Vec3<Real> p{};
    Throughput<Real> throughput{};
    Real weight{};
};

template <class Real>
struct TransparentBoundary {
    Vec3<Real> s{};
    PairChild<Real> reflected{};
    PairChild<Real> transmitted{};
    MaskOf<Real> reaches{};  ///< false: the ray does not go towards the boundary, a numerical failure
};

/// The child with the field vectors s and cross(ray, s).
template <class Real>
inline PairChild<Real> pair_child(const Throughput<Real>& m, const Vec3<Real>& s, const Vec3<Real>& ray,
                                  const Complex<Real>& a_s, const Complex<Real>& a_p) {
    PairChild<Real> child;
    // One Newton step towards |ray| = 1: no drift over 1e5 bounces.
    child.ray = ray * (Real(1.5) - Real(0.5) * length2(ray));
    child.p = cross(child.ray, s);
    for (int row = 0; row < 2; ++row) {
        child.throughput.m[row][0] = m.m[row][0] * a_s;
        child.throughput.m[row][1] = m.m[row][1] * a_p;
    }
    child.weight = child.throughput.weight();
    return child;
}

/// s across the plane of incidence. The cross product is off by 1e-16 in any direction, so s leans out of the wave
/// front by 1e-16/sin and a share (1e-16/sin)^2 of the energy is lost. Below sin = 1e-8 any s across the ray will do as
/// well: the two polarizations differ by sin^2 only.
template <class Real>
inline Vec3<Real> across_incidence(const Vec3<Real>& ray, const Vec3<Real>& field, const Vec3<Real>& normal) {
    using std::sqrt;
    constexpr double nearly_normal = 1e-16;
    const Vec3<Real> across = cross(normal, ray);
    const Real sin2 = length2(across);
    const auto is_oblique = sin2 > Real(nearly_normal);
    const Vec3<Real> s = across * (Real(1) / sqrt(sin2));
    return {select(is_oblique, s.x, field.x), select(is_oblique, s.y, field.y), select(is_oblique, s.z, field.z)};
}

/// From index n1 to n2. `normal` is unit and leans along the ray.
template <class Real>
inline TransparentBoundary<Real> transparent_boundary(const Vec3<Real>& ray, const Vec3<Real> (&field)[2],
                                                      const Throughput<Real>& throughput, const Vec3<Real>& normal,
                                                      double n1, double n2) {
    TransparentBoundary<Real> out;
    const Real cos_1 = dot(normal, ray);
    out.reaches = cos_1 > Real(0);
    out.s = across_incidence(ray, field[0], normal);
    const Throughput<Real> m = in_basis(throughput, field, out.s, cross(ray, out.s));
    const Fresnel<Real> f = fresnel(Real(n1), Real(n2), Real(n1) * cos_1);
    out.reflected = pair_child(m, out.s, ray - normal * (Real(2) * cos_1), f.r_s, f.r_p);
    const Vec3<Real> bent = ((ray - normal * cos_1) * Real(n1) + normal * f.q2) * Real(1.0 / n2);
    out.transmitted = pair_child(m, out.s, n1 == n2 ? ray : bent, Complex<Real>(f.t_s), Complex<Real>(f.t_p));
    return out;
}

}  // namespace pol
