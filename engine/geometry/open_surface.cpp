// SPDX-License-Identifier: Apache-2.0
#include "geometry/open_surface.h"

#include <cmath>

#include "core/units.h"
#include "geometry/complaint.h"

namespace pol {

Result<OpenSurface> OpenSurface::from(const RectangleShape& shape, const DMat4& to_world) {
    if (!(shape.size.x > 0.0 && shape.size.y > 0.0) || !std::isfinite(shape.size.x + shape.size.y)) {
        return complaint("size", "both sides must be positive and finite", "for example [1, 1]");
    }
    return make(Outline::rectangle, 0.5 * shape.size, to_world);
}

Result<OpenSurface> OpenSurface::from(const DiskShape& shape, const DMat4& to_world) {
    if (!(shape.radius > 0.0) || !std::isfinite(shape.radius)) {
        return complaint("radius", "the radius must be positive and finite", "for example radius: 1");
    }
    return make(Outline::disk, DVec2(shape.radius), to_world);
}

Result<OpenSurface> OpenSurface::make(Outline outline, const DVec2& half_size, const DMat4& to_world) {
    OpenSurface s;
    s.outline_ = outline;
    s.center_ = DVec3(to_world[3]);
    s.half_u_ = half_size.x * DVec3(to_world[0]);
    s.half_v_ = half_size.y * DVec3(to_world[1]);
    const DVec3 across = cross(s.half_u_, s.half_v_);
    const double across2 = length2(across);
    const double sides2 = length2(s.half_u_) * length2(s.half_v_);
    // 1e-12 of a radian between the sides: below that the duals have no correct digit worth having.
    if (!std::isfinite(sides2) || !std::isfinite(length2(s.center_)) || !(across2 > 1e-24 * sides2)) {
        return complaint("transform", "the transform flattens the surface to a line or a point, or is not finite",
                         "use non-zero scales");
    }
    s.dual_u_ = cross(s.half_v_, across) / across2;
    s.dual_v_ = cross(across, s.half_u_) / across2;
    // The image of +z may lean; the normal is the perpendicular on its side.
    const double side = dot(across, DVec3(to_world[2])) < 0.0 ? -1.0 : 1.0;
    s.plane_.normal = side * unit(across);
    s.plane_.offset = dot(s.plane_.normal, s.center_);
    return s;
}

std::optional<SurfaceHit> OpenSurface::hit(const DVec3& o, const DVec3& d, int skip) const {
    if (skip >= 0) return std::nullopt;
    const double along = dot(plane_.normal, d);
    const double t = dot(plane_.normal, center_ - o) / along;
    if (!(t > 0.0) || std::isinf(t)) return std::nullopt;
    const DVec3 from_center = o + t * d - center_;
    const double u = dot(dual_u_, from_center);
    const double v = dot(dual_v_, from_center);
    const bool on = outline_ == Outline::disk ? u * u + v * v <= 1.0 : std::abs(u) <= 1.0 && std::abs(v) <= 1.0;
    if (!on) return std::nullopt;
    return SurfaceHit{t, {0.5 * (u + 1.0), 0.5 * (v + 1.0)}};
}

double OpenSurface::area() const {
    const double quarter = std::sqrt(length2(cross(half_u_, half_v_)));
    return outline_ == Outline::disk ? pi * quarter : 4.0 * quarter;
}

}  // namespace pol
