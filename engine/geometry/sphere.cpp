// SPDX-License-Identifier: Apache-2.0
#include "geometry/sphere.h"

#include <cmath>
#include <glm/matrix.hpp>

#include "geometry/complaint.h"

namespace pol {
FacetHit Sphere::exit(const DVec3& o, const DVec3& d, int skip) const {
    if (skip >= 0) {
        const BallMeeting<double> meeting = leave(o, d);
        return meeting.met ? FacetHit{meeting.distance, 0} : FacetHit{};
    }
    const Chord<double> c = chord(o, d);
    if (!(c.half2 >= 0.0)) return {};
    return {c.middle + std::sqrt(c.half2), 0};
}

FacetHit Sphere::enter(const DVec3& o, const DVec3& d, int skip) const {
    if (skip >= 0) return {};
    const BallMeeting<double> meeting = come_in(o, d);
    return meeting.met ? FacetHit{meeting.distance, 0} : FacetHit{};
}

bool Sphere::contains(const DVec3& p, double margin) const {
    return std::sqrt(length2(p - center)) - radius < -margin;
}

Result<Sphere> make_sphere(const SphereShape& shape, const DMat4& to_world) {
    if (!(shape.radius > 0.0) || !std::isfinite(shape.radius)) {
        return complaint("radius", "the radius must be positive and finite", "for example radius: 1");
    }
    const DMat3 linear(to_world);
    const double scale = std::cbrt(std::abs(glm::determinant(linear)));
    if (!std::isfinite(scale) || scale == 0.0) {
        return complaint("transform", "the transform is singular or not finite", "use non-zero scales");
    }
    // A similarity: columns of equal length, mutually perpendicular.
    const DMat3 gram = glm::transpose(linear) * linear / (scale * scale);
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) {
            if (std::abs(gram[c][r] - (c == r ? 1.0 : 0.0)) > 1e-12) {
                return complaint("transform", "the transform makes the sphere an ellipsoid",
                                 "scale a sphere by the same factor along all axes, or use a mesh");
            }
        }
    }
    return Sphere{DVec3(to_world[3]), shape.radius * scale};
}

}  // namespace pol
