// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes.h"

#include <cmath>
#include <glm/matrix.hpp>
#include <string>
#include <utility>

#include "core/overloaded.h"
#include "core/units.h"
#include "geometry/brilliant.h"
#include "geometry/complaint.h"
#include "geometry/polytope.h"

namespace pol {
namespace {

bool is_length(double x) {
    return x > 0.0 && std::isfinite(x);
}

Error not_a_length(std::string field) {
    return complaint(std::move(field), "must be positive and finite", "lengths are in scene units, for example 1");
}

// Right prism over a strictly convex counter-clockwise polygon; the callers have checked `height`.
Result<Mesh> extruded(const std::vector<DVec2>& polygon, double height) {
    const std::string hint = "list at least three corners of a convex polygon counter-clockwise, no three in line";
    const std::size_t n = polygon.size();
    if (n < 3) return complaint("polygon", "has fewer than three corners", hint);
    double turned = 0.0;
    std::vector<Plane> planes{{{0.0, 0.0, -1.0}, 0.5 * height}, {{0.0, 0.0, 1.0}, 0.5 * height}};
    for (std::size_t i = 0; i < n; ++i) {
        const DVec2 a = polygon[i];
        const DVec2 b = polygon[(i + 1) % n];
        const DVec2 c = polygon[(i + 2) % n];
        const DVec2 ab = b - a;
        const DVec2 bc = c - b;
        const double turn = std::atan2(ab.x * bc.y - ab.y * bc.x, dot(ab, bc));
        // 1e-9 rad: flatter corners cannot be told from rounding of their coordinates.
        if (!(turn > 1e-9)) {
            return complaint("polygon[" + std::to_string((i + 1) % n) + "]", "the corner does not turn left", hint);
        }
        turned += turn;
        const DVec3 normal = unit(DVec3(ab.y, -ab.x, 0.0));
        planes.push_back({normal, dot(normal, DVec3(0.5 * (a + b), 0.0))});
    }
    if (turned > 3.0 * pi) return complaint("polygon", "winds around more than once", hint);
    return mesh_from_planes(planes);
}

Result<Mesh> make(const BoxShape& box) {
    if (!is_length(box.size.x) || !is_length(box.size.y) || !is_length(box.size.z)) return not_a_length("size");
    std::vector<Plane> planes;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            DVec3 normal(0.0);
            normal[axis] = sign;
            planes.push_back({normal, 0.5 * box.size[axis]});
        }
    }
    return mesh_from_planes(planes);
}

Result<Mesh> make(const ExtrusionShape& extrusion) {
    if (!is_length(extrusion.height)) return not_a_length("height");
    return extruded(extrusion.polygon, extrusion.height);
}

Result<Mesh> make(const PrismShape& prism) {
    if (!is_length(prism.side)) return not_a_length("side");
    if (!is_length(prism.height)) return not_a_length("height");
    if (!(prism.apex_angle > 0.0 && prism.apex_angle < pi)) {
        return complaint("apex_angle", "must lie between 0 and 180 degrees", "60 degrees is usual");
    }
    const double half_base = prism.side * std::sin(0.5 * prism.apex_angle);
    const double half_rise = 0.5 * prism.side * std::cos(0.5 * prism.apex_angle);
    return extruded({{-half_base, -half_rise}, {half_base, -half_rise}, {0.0, half_rise}}, prism.height);
}

// The axial ray meets both long faces once and leaves along the axis of the exit face. With beta = 90 degrees - angle
// between axis and long faces, their length is 2 aperture cos^2(beta) / sin(beta).
Result<Mesh> make(const RhombShape& rhomb) {
    if (!is_length(rhomb.aperture)) return not_a_length("aperture");
    if (!is_length(rhomb.height)) return not_a_length("height");
    if (!(rhomb.angle >= radians(45.0) && rhomb.angle < radians(90.0))) {
        return complaint("angle", "must lie between 45 and 90 degrees", "54.6 degrees turns 45 degrees in n = 1.51");
    }
    const double sin_beta = std::cos(rhomb.angle);
    const double cos_beta = std::sin(rhomb.angle);
    const double length = 2.0 * rhomb.aperture * cos_beta * cos_beta / sin_beta;
    const DVec2 exit = 0.5 * length * DVec2(cos_beta, sin_beta);
    const DVec2 up(0.0, 0.5 * rhomb.aperture);
    return extruded({-exit - up, exit - up, exit + up, -exit + up}, rhomb.height);
}

Result<Mesh> make(const RectangleShape& rectangle) {
    if (!is_length(rectangle.size.x) || !is_length(rectangle.size.y)) return not_a_length("size");
    const double x = 0.5 * rectangle.size.x;
    const double y = 0.5 * rectangle.size.y;
    Mesh mesh;
    mesh.vertices = {{-x, -y, 0.0}, {x, -y, 0.0}, {x, y, 0.0}, {-x, y, 0.0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.facet_of_triangle = {0, 0};
    mesh.facets = {{{0.0, 0.0, 1.0}, 0.0}};
    return mesh;
}

}  // namespace

Result<Mesh> make_mesh(const Shape& shape) {
    const auto not_flat = [](const char* what) {
        return complaint("shape", std::string(what) + " cannot be made from planes", "a defect of the caller");
    };
    return std::visit(Overloaded{
                          [&](const SphereShape&) -> Result<Mesh> { return not_flat("a sphere"); },
                          [&](const DiskShape&) -> Result<Mesh> { return not_flat("a disk"); },
                          [&](const MeshShape&) -> Result<Mesh> { return not_flat("a mesh file"); },
                          [&](const BrilliantShape& s) { return make_brilliant(s); },
                          [&](const auto& s) { return make(s); },
                      },
                      shape);
}

Result<Mesh> transformed(const Mesh& mesh, const DMat4& to_world) {
    const DMat3 linear(to_world);
    const double det = glm::determinant(linear);
    double columns = 1.0;
    for (int c = 0; c < 3; ++c) columns *= std::sqrt(length2(linear[c]));
    const bool affine = to_world[0].w == 0.0 && to_world[1].w == 0.0 && to_world[2].w == 0.0 && to_world[3].w == 1.0;
    // det / product of column lengths is the volume of the box of unit vectors: 1e-12 leaves four digits in a normal.
    if (!affine || !std::isfinite(columns) || !std::isfinite(length2(DVec3(to_world[3]))) ||
        !(std::abs(det) > 1e-12 * columns)) {
        return complaint("transform", "is singular, projective or not finite",
                         "scales must not be zero and axes must not coincide");
    }
    // Rows of the cofactor matrix carry normals (up to the factor det, whose sign a mirror reverses).
    const double side = det < 0.0 ? -1.0 : 1.0;
    const DMat3 cofactors(cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1]));
    Mesh moved = mesh;
    for (DVec3& p : moved.vertices) p = linear * p + DVec3(to_world[3]);
    for (Plane& plane : moved.facets) {
        const DVec3 anchor = linear * (plane.offset * plane.normal) + DVec3(to_world[3]);
        plane.normal = unit(side * (cofactors * plane.normal));
        plane.offset = dot(plane.normal, anchor);
    }
    if (det < 0.0) {
        for (auto& triangle : moved.triangles) std::swap(triangle[1], triangle[2]);
    }
    return moved;
}

}  // namespace pol
