// SPDX-License-Identifier: Apache-2.0
#include "geometry/polytope.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <string>

#include "geometry/complaint.h"
#include "geometry/mesh_check.h"

namespace pol {
namespace {

// Corner of the polygon that is being cut out of a plane: made by that plane, `before` and `after`, where the edge
// after the corner lies in plane `after`.
struct Corner {
    std::size_t before = 0;
    std::size_t after = 0;
    DVec3 at{};
};

// Cramer's rule with the triple product; the caller guarantees that the three planes meet in a point.
DVec3 meeting_point(const Plane& a, const Plane& b, const Plane& c) {
    const DVec3 bc = cross(b.normal, c.normal);
    const DVec3 ca = cross(c.normal, a.normal);
    const DVec3 ab = cross(a.normal, b.normal);
    return (a.offset * bc + b.offset * ca + c.offset * ab) / dot(a.normal, bc);
}

double outside(const Plane& plane, const DVec3& p) {
    return dot(plane.normal, p) - plane.offset;
}

// Sutherland & Hodgman (CACM 17(1), 1974) against one plane; new corners are computed from planes, never by
// interpolation, so errors do not build up.
std::vector<Corner> cut(const std::vector<Corner>& polygon, const std::vector<Plane>& planes, std::size_t own,
                        std::size_t by) {
    std::vector<Corner> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner& here = polygon[i];
        const Corner& next = polygon[(i + 1) % polygon.size()];
        const bool here_in = outside(planes[by], here.at) <= 0.0;
        const bool next_in = outside(planes[by], next.at) <= 0.0;
        if (here_in) kept.push_back(here);
        if (here_in && !next_in) {
            kept.push_back({here.after, by, meeting_point(planes[own], planes[here.after], planes[by])});
        } else if (!here_in && next_in) {
            kept.push_back({by, here.after, meeting_point(planes[own], planes[by], planes[here.after])});
        }
    }
    return kept;
}

// The point closest to all given planes, found as a small step from `start`: the step is short, so squaring the
// condition number in the normal equations costs nothing.
DVec3 closest_to_planes(const std::vector<Plane>& planes, const std::vector<std::size_t>& which, const DVec3& start) {
    DMat3 normal_matrix(0.0);
    DVec3 right(0.0);
    for (const std::size_t i : which) {
        normal_matrix += glm::outerProduct(planes[i].normal, planes[i].normal);
        right -= planes[i].normal * outside(planes[i], start);
    }
    return start + glm::inverse(normal_matrix) * right;
}

Error bad_planes(std::string what) {
    return complaint("", std::move(what), "a convex solid needs planes on all sides, each with a face on it");
}

}  // namespace

Result<Mesh> mesh_from_planes(std::span<const Plane> planes) {
    const std::size_t count = planes.size();
    double reach = 0.0;
    for (const Plane& p : planes) {
        if (!std::isfinite(length2(p.normal)) || !std::isfinite(p.offset)) return bad_planes("a plane is not finite");
        reach = std::max(reach, std::abs(p.offset));
    }
    if (count < 4 || reach == 0.0) return bad_planes("the planes do not bound a solid");

    // Four planes far away hold the polygon of each plane before it is cut; any of them left at the end: unbounded.
    std::vector<Plane> all(planes.begin(), planes.end());
    all.resize(count + 4);
    std::vector<std::vector<Corner>> polygons(count);
    std::vector<DVec3> points;
    for (std::size_t i = 0; i < count; ++i) {
        const DVec3 u = any_perpendicular(planes[i].normal);
        const DVec3 v = cross(planes[i].normal, u);
        const double far = 1e4 * reach;
        all[count + 0] = {u, far};
        all[count + 1] = {v, far};
        all[count + 2] = {-u, far};
        all[count + 3] = {-v, far};
        std::vector<Corner> polygon;
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t before = count + k;
            const std::size_t after = count + (k + 1) % 4;
            polygon.push_back({before, after, meeting_point(planes[i], all[before], all[after])});
        }
        for (std::size_t j = 0; j < count && !polygon.empty(); ++j) {
            if (j != i) polygon = cut(polygon, all, i, j);
        }
        for (const Corner& corner : polygon) {
            if (corner.before >= count || corner.after >= count) return bad_planes("the planes leave the solid open");
            points.push_back(corner.at);
        }
        polygons[i] = std::move(polygon);
    }
    if (points.empty()) return bad_planes("no point lies inside all planes");

    DVec3 low = points.front();
    DVec3 high = points.front();
    for (const DVec3& p : points) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    // Where more than three planes meet, rounding makes several corners of one: 1e-11 of the size is far above rounding
    // about the origin, and below the thickness of any film.
    const double tolerance = 1e-11 * glm::length(high - low) + rounding_share * reach;

    Mesh mesh;
    mesh.facets.assign(planes.begin(), planes.end());
    const auto vertex_at = [&](const DVec3& p) {
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
            if (glm::distance(mesh.vertices[v], p) <= 4.0 * tolerance) return v;
        }
        std::vector<std::size_t> through;
        for (std::size_t i = 0; i < count; ++i) {
            if (std::abs(outside(planes[i], p)) <= tolerance) through.push_back(i);
        }
        mesh.vertices.push_back(closest_to_planes(all, through, p));
        return mesh.vertices.size() - 1;
    };
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<std::uint32_t> ring;
        for (const Corner& corner : polygons[i]) {
            const auto v = static_cast<std::uint32_t>(vertex_at(corner.at));
            if (std::find(ring.begin(), ring.end(), v) == ring.end()) ring.push_back(v);
        }
        if (ring.size() < 3) {
            return bad_planes("plane " + std::to_string(i) +
                              " has no face on the solid, or a narrower one than 1e-11 of its size");
        }
        for (std::size_t k = 2; k < ring.size(); ++k) {
            mesh.triangles.push_back({ring[0], ring[k - 1], ring[k]});
            mesh.facet_of_triangle.push_back(static_cast<std::uint32_t>(i));
        }
    }
    return mesh;
}

}  // namespace pol
