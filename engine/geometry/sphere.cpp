// SPDX-License-Identifier: Apache-2.0
#include "geometry/sphere.h"

#include <cmath>
#include <glm/matrix.hpp>

#include "geometry/complaint.h"

namespace pol {
namespace {

// Half the chord and the distance from `o` to its middle. Haines, Guenther, Akenine-Moeller, "Precision improvements
// for ray/sphere intersection", Ray Tracing Gems (2019), ch. 7: the discriminant from the distance of the center to
// the line, not from b^2 - c, which cancels for distant or large spheres. The roots middle -+ half then err by an ulp
// of the larger term, which the rounding of `o` itself costs anyway.
struct Chord {
    double middle = 0.0;
    double half2 = 0.0;  // negative: the line misses
};

Chord chord(const Sphere& s, const DVec3& o, const DVec3& d) {
    const DVec3 f = o - s.center;
    const double middle = -dot(f, d);
    const double off_axis = std::sqrt(length2(f + middle * d));
    return {middle, (s.radius - off_axis) * (s.radius + off_axis)};
}

}  // namespace

FacetHit Sphere::exit(const DVec3& o, const DVec3& d, int skip) const {
    if (skip >= 0) {
        const double t = -2.0 * dot(o - center, d);
        return t > 0.0 ? FacetHit{t, 0} : FacetHit{};
    }
    const Chord c = chord(*this, o, d);
    if (!(c.half2 >= 0.0)) return {};
    return {c.middle + std::sqrt(c.half2), 0};
}

FacetHit Sphere::enter(const DVec3& o, const DVec3& d, int skip) const {
    if (skip >= 0) return {};
    const Chord c = chord(*this, o, d);
    if (!(c.half2 > 0.0) || !(c.middle > 0.0)) return {};
    const double t = c.middle - std::sqrt(c.half2);
    // Rounding of a distant start turns a line that grazes into one that touches: it must run inward where it arrives.
    return dot(normal_at(o + t * d), d) < 0.0 ? FacetHit{t, 0} : FacetHit{};
}

bool Sphere::contains(const DVec3& p, double margin) const {
    return std::sqrt(length2(p - center)) - radius < -margin;
}

DVec3 Sphere::normal_at(const DVec3& p) const {
    return unit(p - center);
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
