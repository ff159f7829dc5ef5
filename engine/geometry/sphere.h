// SPDX-License-Identifier: Apache-2.0
// The analytic ball. Same queries as HalfSpaceSolid; its whole surface is facet 0.
#pragma once

#include <cmath>

#include "core/lanes.h"
#include "core/result.h"
#include "core/vec.h"
#include "geometry/hit.h"
#include "geometry/shape.h"

namespace pol {

/// Where a ray meets a ball, if it does; else the distance means nothing.
template <class Real>
struct BallMeeting {
    Real distance{};
    MaskOf<Real> met{};
};

/// Ball in world space.
struct Sphere {
    DVec3 center{};
    double radius = 1.0;

    /// Where a ray from inside or from the surface leaves. `skip` = 0 says that `o` lies on the sphere; the answer is
    /// then the exact second root -2 (o - center).d. Otherwise -1. facet = -1: the line misses the ball.
    /// Requires: |d| = 1.
    FacetHit exit(const DVec3& o, const DVec3& d, int skip) const;

    /// Where a ray from outside enters. With `skip` = 0 (just left) nothing: the ball is convex. A tangent misses the
    /// ball: all of it is reflected, straight on. Requires: |d| = 1.
    FacetHit enter(const DVec3& o, const DVec3& d, int skip) const;

    /// exit() of rays from the sphere itself, and enter() of rays that have not just left it.
    template <class Real>
    [[nodiscard]] BallMeeting<Real> leave(const Vec3<Real>& o, const Vec3<Real>& d) const {
        const Real t = Real(-2.0) * dot(o - Vec3<Real>(center), d);
        return {t, t > Real(0.0)};
    }
    template <class Real>
    [[nodiscard]] BallMeeting<Real> come_in(const Vec3<Real>& o, const Vec3<Real>& d) const {
        using std::sqrt;
        const auto [middle, half2] = chord(o, d);
        if constexpr (!is_lanes<Real>)  // the short way to the same
            if (!(half2 > Real(0.0)) || !(middle > Real(0.0))) return {};
        BallMeeting<Real> meeting;
        meeting.distance = middle - sqrt(half2);
        // Rounding of a distant start turns a line that grazes into one that touches: it must run inward where it
        // arrives.
        const auto inward = dot(normal_at(o + meeting.distance * d), d) < Real(0.0);
        meeting.met = (half2 > Real(0.0)) & (middle > Real(0.0)) & inward;
        return meeting;
    }

    /// Whether `p` is inside by more than `margin`; a negative margin lets points slightly outside in.
    bool contains(const DVec3& p, double margin) const;

    /// Outward unit normal at a point of the surface.
    template <class Real>
    [[nodiscard]] Vec3<Real> normal_at(const Vec3<Real>& p) const {
        return unit(p - Vec3<Real>(center));
    }

private:
    /// Half the chord and the distance from `o` to its middle. Haines, Guenther, Akenine-Moeller, "Precision
    /// improvements for ray/sphere intersection", Ray Tracing Gems (2019), ch. 7: the discriminant from the distance of
    /// the center to the line, not from b^2 - c, which cancels for distant or large spheres. The roots middle -+ half
    /// then err by an ulp of the larger term, which the rounding of `o` itself costs anyway.
    template <class Real>
    struct Chord {
        Real middle{};
        Real half2{};  ///< negative: the line misses
    };
    template <class Real>
    [[nodiscard]] Chord<Real> chord(const Vec3<Real>& o, const Vec3<Real>& d) const {
        using std::sqrt;
        const Vec3<Real> f = o - Vec3<Real>(center);
        const Real middle = -dot(f, d);
        const Real off_axis = sqrt(length2(f + middle * d));
        return {middle, (Real(radius) - off_axis) * (Real(radius) + off_axis)};
    }
};

/// The sphere in world space. Error if `to_world` is singular or does not keep it round (within 1e-12 relative).
Result<Sphere> make_sphere(const SphereShape& shape, const DMat4& to_world);

}  // namespace pol
