// SPDX-License-Identifier: Apache-2.0
#include "geometry/open_surface.h"

#include <algorithm>
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
    const SurfaceMeeting<double> meeting = meet(o, d);
    if (!meeting.met) return std::nullopt;
    return SurfaceHit{meeting.distance, {meeting.u, meeting.v}};
}

std::optional<DVec2> OpenSurface::uv_at(const DVec3& p, double margin) const {
    const DVec3 from_center = p - center_;
    const double u = dot(dual_u_, from_center);
    const double v = dot(dual_v_, from_center);
    const double reach_u = 1.0 + margin * std::sqrt(length2(dual_u_));
    const double reach_v = 1.0 + margin * std::sqrt(length2(dual_v_));
    const bool on = outline_ == Outline::disk ? u * u + v * v <= reach_u * reach_v
                                              : std::abs(u) <= reach_u && std::abs(v) <= reach_v;
    if (!on) return std::nullopt;
    return DVec2(0.5 * (u + 1.0), 0.5 * (v + 1.0));
}

Mesh OpenSurface::mesh() const {
    Mesh mesh;
    if (outline_ == Outline::disk) {
        constexpr int corners = 256;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2.0 * pi * i / corners;
            mesh.vertices.push_back(center_ + std::cos(angle) * half_u_ + std::sin(angle) * half_v_);
        }
    } else {
        mesh.vertices = {center_ - half_u_ - half_v_, center_ + half_u_ - half_v_, center_ + half_u_ + half_v_,
                         center_ - half_u_ + half_v_};
    }
    // Counter-clockwise seen from the side of the normal, whatever the handedness of the transform.
    if (dot(cross(half_u_, half_v_), plane_.normal) < 0.0) std::reverse(mesh.vertices.begin(), mesh.vertices.end());
    for (std::uint32_t i = 2; i < mesh.vertices.size(); ++i) mesh.triangles.push_back({0, i - 1, i});
    mesh.facet_of_triangle.assign(mesh.triangles.size(), 0);
    mesh.facets = {plane_};
    return mesh;
}

double OpenSurface::area() const {
    const double quarter = std::sqrt(length2(cross(half_u_, half_v_)));
    return outline_ == Outline::disk ? pi * quarter : 4.0 * quarter;
}

}  // namespace pol
