// SPDX-License-Identifier: Apache-2.0
// The analytic ball. Same queries as HalfSpaceSolid; its whole surface is facet 0.
#pragma once

#include "core/result.h"
#include "core/vec.h"
#include "geometry/hit.h"
#include "geometry/shape.h"

namespace pol {

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

    /// Whether `p` is inside by more than `margin`; a negative margin lets points slightly outside in.
    bool contains(const DVec3& p, double margin) const;

    /// Outward unit normal at a point of the surface.
    DVec3 normal_at(const DVec3& p) const;
};

/// The sphere in world space. Error if `to_world` is singular or does not keep it round (within 1e-12 relative).
Result<Sphere> make_sphere(const SphereShape& shape, const DMat4& to_world);

}  // namespace pol
