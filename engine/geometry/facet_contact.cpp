// SPDX-License-Identifier: Apache-2.0
#include "geometry/facet_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "geometry/mesh_check.h"

namespace pol {
namespace {

// A facet's triangles and bounds, gathered.
struct Face {
    Plane plane{};
    std::vector<std::array<DVec3, 3>> triangles;
    double slack = 0.0;
    DVec3 low{std::numeric_limits<double>::infinity()};
    DVec3 high{-std::numeric_limits<double>::infinity()};
};

std::vector<Face> faces_of(const Mesh& mesh) {
    std::vector<Face> faces(mesh.facets.size());
    for (std::size_t i = 0; i < faces.size(); ++i) faces[i].plane = mesh.facets[i];
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        Face& face = faces[mesh.facet_of_triangle[t]];
        std::array<DVec3, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = mesh.vertices[mesh.triangles[t][k]];
            face.low = glm::min(face.low, corners[k]);
            face.high = glm::max(face.high, corners[k]);
        }
        face.triangles.push_back(corners);
        face.slack = std::max(face.slack, slack(mesh, t));
    }
    return faces;
}

bool lies_in(const Face& face, const Plane& plane, double distance) {
    return std::all_of(face.triangles.begin(), face.triangles.end(), [&](const auto& triangle) {
        return std::all_of(triangle.begin(), triangle.end(),
                           [&](const DVec3& p) { return std::abs(dot(plane.normal, p) - plane.offset) <= distance; });
    });
}

// Area common to two triangles of one plane: the first clipped by the sides of the second (Sutherland & Hodgman 1974).
double common_area(const std::array<DVec3, 3>& s, const std::array<DVec3, 3>& t, const DVec3& t_normal) {
    std::vector<DVec3> polygon(s.begin(), s.end());
    for (std::size_t k = 0; k < 3 && !polygon.empty(); ++k) {
        const DVec3 inward = cross(t_normal, t[(k + 1) % 3] - t[k]);
        std::vector<DVec3> kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const DVec3& here = polygon[i];
            const DVec3& next = polygon[(i + 1) % polygon.size()];
            const double h = dot(inward, here - t[k]);
            const double n = dot(inward, next - t[k]);
            if (h >= 0.0) kept.push_back(here);
            if ((h >= 0.0) != (n >= 0.0)) kept.push_back(here + h / (h - n) * (next - here));
        }
        polygon = std::move(kept);
    }
    DVec3 twice(0.0);
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        twice += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    }
    return 0.5 * std::sqrt(length2(twice));
}

}  // namespace

std::vector<FacetPair> flush_facets(const Mesh& a, const Mesh& b, Facing facing, double beyond) {
    const std::vector<Face> faces_a = faces_of(a);
    const std::vector<Face> faces_b = faces_of(b);
    std::vector<std::size_t> by_x(faces_b.size());
    std::iota(by_x.begin(), by_x.end(), std::size_t{0});
    std::sort(by_x.begin(), by_x.end(), [&](auto s, auto t) { return faces_b[s].low.x < faces_b[t].low.x; });
    double largest_slack = 0.0;
    for (const Face& g : faces_b) largest_slack = std::max(largest_slack, g.slack);
    std::vector<FacetPair> pairs;
    for (std::size_t i = 0; i < faces_a.size(); ++i) {
        const Face& f = faces_a[i];
        for (const std::size_t j : by_x) {
            const Face& g = faces_b[j];
            if (g.low.x > f.high.x + f.slack + largest_slack + beyond) break;
            const double distance = f.slack + g.slack + beyond;
            const DVec3 between = glm::max(f.low - g.high, g.low - f.high);
            if (std::max({between.x, between.y, between.z}) > distance) continue;
            const double turn = dot(f.plane.normal, g.plane.normal);
            if ((turn > 0.0) != (facing == Facing::same)) continue;
            if (!lies_in(f, g.plane, distance) && !lies_in(g, f.plane, distance)) continue;
            double area = 0.0;
            for (const auto& s : f.triangles) {
                for (const auto& t : g.triangles) area += common_area(s, t, g.plane.normal);
            }
            const double extent = std::min(glm::length(f.high - f.low), glm::length(g.high - g.low));
            if (area > distance * extent) {
                pairs.push_back({static_cast<int>(i), static_cast<int>(j), distance});
            }
        }
    }
    std::sort(pairs.begin(), pairs.end(),
              [](const FacetPair& p, const FacetPair& q) { return std::tie(p.a, p.b) < std::tie(q.a, q.b); });
    return pairs;
}

DVec3 closest_on_triangle(const DVec3& a, const DVec3& b, const DVec3& c, const DVec3& p) {
    const DVec3 ab = b - a;
    const DVec3 ac = c - a;
    const DVec3 ap = p - a;
    const double d1 = dot(ab, ap);
    const double d2 = dot(ac, ap);
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    const DVec3 bp = p - b;
    const double d3 = dot(ab, bp);
    const double d4 = dot(ac, bp);
    if (d3 >= 0.0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
    const DVec3 cp = p - c;
    const double d5 = dot(ab, cp);
    const double d6 = dot(ac, cp);
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    const double sum = va + vb + vc;
    return a + vb / sum * ab + vc / sum * ac;
}

}  // namespace pol
