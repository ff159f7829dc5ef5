// SPDX-License-Identifier: Apache-2.0
// The axes that a polarization state is written in. CONVENTIONS.md has the figures.
#pragma once

#include <cmath>

#include "core/contract.h"
#include "core/vec.h"

namespace pol {

/// Transverse basis of a beam.
///
/// Invariant: x, y and k are orthonormal and right-handed (x cross y = k), and k points along the propagation of the
/// light, not of the traced ray. To the receiver, x is right and y is up. At an interface x is the s axis and y the p
/// axis.
template <class Real>
class PolarizationFrame {
public:
    /// Frame about `k` whose x axis is as close to `x_hint` as possible.
    /// Requires: `k` is unit length and not parallel to `x_hint`, which need not be unit.
    static PolarizationFrame about(const Vec3<Real>& k, const Vec3<Real>& x_hint) {
        const Vec3<Real> across = cross(k, x_hint);
        POL_EXPECTS(length2(across) > Real(0));
        // The second projection removes what the cross product of nearly parallel vectors leaves along k.
        const Vec3<Real> y = unit(across);
        return with_y(k, unit(y - k * dot(k, y)));
    }

    /// Frame of a pixel: x = unit(d x up) is image right, y is `up` made transverse, k = -d points into the camera.
    /// `view` is the unit direction d from the camera into the scene.
    /// Requires: `view` and `up` are not parallel; `up` need not be unit.
    static PolarizationFrame of_camera(const Vec3<Real>& view, const Vec3<Real>& up) {
        return about(-view, cross(view, up));
    }

    /// (s, p, k) of light that travels along unit `k` at an interface with unit normal `n`: s = unit(n x k), p = k x s.
    /// Where k is along n the plane of incidence is undefined, and s comes from the world axis least aligned with n.
    static PolarizationFrame of_interface(const Vec3<Real>& k, const Vec3<Real>& n) {
        const Vec3<Real> s = cross(n, k);
        if (length2(s) > Real(0)) return about(k, s);
        return about(k, cross(n, least_aligned_axis(n)));
    }

    [[nodiscard]] const Vec3<Real>& x() const { return x_; }
    [[nodiscard]] const Vec3<Real>& y() const { return y_; }
    [[nodiscard]] const Vec3<Real>& k() const { return k_; }

private:
    PolarizationFrame(const Vec3<Real>& x, const Vec3<Real>& y, const Vec3<Real>& k) : x_(x), y_(y), k_(k) {}
    static PolarizationFrame with_y(const Vec3<Real>& k, const Vec3<Real>& y) { return {cross(y, k), y, k}; }

    Vec3<Real> x_;
    Vec3<Real> y_;
    Vec3<Real> k_;
};

/// Angle in (-pi, pi] that turns the axes of `from` counter-clockwise, for the receiver, into those of `to`.
/// Requires: both have the same k (within 1e-6).
template <class Real>
Real angle_between(const PolarizationFrame<Real>& from, const PolarizationFrame<Real>& to) {
    using std::atan2;
    POL_EXPECTS(length2(from.k() - to.k()) < Real(1e-12));
    return atan2(dot(to.x(), from.y()), dot(to.x(), from.x()));
}

}  // namespace pol
