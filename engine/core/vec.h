// SPDX-License-Identifier: Apache-2.0
// Vectors over any real type: GLM's, so that double, long double and 128-bit types share one formula.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pol {

template <class Real>
using Vec3 = glm::vec<3, Real, glm::defaultp>;
using DVec2 = glm::dvec2;
using DVec3 = glm::dvec3;
using DMat3 = glm::dmat3;
using DMat4 = glm::dmat4;

/// |v|^2
template <class Real>
constexpr Real length2(const Vec3<Real>& v) {
    return v.x * v.x + v.y * v.y + v.z * v.z;
}

/// v/|v|. Requires: |v|^2 neither overflows nor underflows, v is not zero.
template <class Real>
Vec3<Real> unit(const Vec3<Real>& v) {
    using std::sqrt;
    return v / sqrt(length2(v));
}

/// World axis least aligned with `v`: a safe partner for a cross product.
template <class Real>
Vec3<Real> least_aligned_axis(const Vec3<Real>& v) {
    using std::abs;
    const Real x = abs(v.x);
    const Real y = abs(v.y);
    const Real z = abs(v.z);
    if (x <= y && x <= z) return {Real(1), Real(0), Real(0)};
    if (y <= z) return {Real(0), Real(1), Real(0)};
    return {Real(0), Real(0), Real(1)};
}

/// Some unit vector perpendicular to `v`; the same one for every call with the same v.
template <class Real>
Vec3<Real> any_perpendicular(const Vec3<Real>& v) {
    return unit(cross(v, least_aligned_axis(v)));
}

}  // namespace pol
