// SPDX-License-Identifier: Apache-2.0
#include "geometry/overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/overloaded.h"
#include "geometry/facet_contact.h"
#include "geometry/mesh_check.h"

namespace pol {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double length(const DVec3& v) {
    return std::sqrt(length2(v));
}

const Mesh* mesh_of(const SolidRef& solid) {
    return std::visit(Overloaded{
                          [](const HalfSpaceSolid* s) { return &s->mesh(); },
                          [](const Sphere*) -> const Mesh* { return nullptr; },
                          [](const Mesh* m) { return m; },
                      },
                      solid);
}

Arrangement swapped(Arrangement a) {
    if (a == Arrangement::a_contains_b) return Arrangement::b_contains_a;
    if (a == Arrangement::b_contains_a) return Arrangement::a_contains_b;
    return a;
}

// Height of `p` above the highest plane: negative inside.
double above(const HalfSpaceSolid& solid, const DVec3& p) {
    double highest = -infinity;
    for (const Plane& plane : solid.mesh().facets) highest = std::max(highest, dot(plane.normal, p) - plane.offset);
    return highest;
}

bool all_within(const HalfSpaceSolid& solid, const std::vector<DVec3>& points, double tolerance) {
    return std::all_of(points.begin(), points.end(), [&](const DVec3& p) { return above(solid, p) <= tolerance; });
}

// Gap between the shadows of two point sets on an axis; negative if they overlap.
double gap_along(const DVec3& axis, const std::vector<DVec3>& a, const std::vector<DVec3>& b) {
    const auto shadow = [&axis](const std::vector<DVec3>& points) {
        double low = infinity;
        double high = -infinity;
        for (const DVec3& p : points) {
            low = std::min(low, dot(axis, p));
            high = std::max(high, dot(axis, p));
        }
        return std::pair(low, high);
    };
    const auto [low_a, high_a] = shadow(a);
    const auto [low_b, high_b] = shadow(b);
    return std::max(low_b - high_a, low_a - high_b);
}

// Directions of the edges between different facets, each once, up to sign.
std::vector<DVec3> edge_directions(const Mesh& mesh) {
    std::vector<DVec3> directions;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const DVec3 edge =
                unit(mesh.vertices[mesh.triangles[t][(k + 1) % 3]] - mesh.vertices[mesh.triangles[t][k]]);
            const bool known = std::any_of(directions.begin(), directions.end(),
                                           [&](const DVec3& d) { return length2(cross(d, edge)) < 1e-24; });
            if (!known) directions.push_back(edge);
        }
    }
    return directions;
}

double slack_of(const Sphere& s) {
    return rounding_share * (s.radius + std::max({std::abs(s.center.x), std::abs(s.center.y), std::abs(s.center.z)}));
}

Arrangement convex_pair(const HalfSpaceSolid& a, const HalfSpaceSolid& b) {
    const double tolerance = a.slack() + b.slack();
    if (length(a.center() - b.center()) > a.radius() + b.radius() + tolerance) return Arrangement::disjoint;
    if (all_within(a, b.vertices(), tolerance)) return Arrangement::a_contains_b;
    if (all_within(b, a.vertices(), tolerance)) return Arrangement::b_contains_a;
    double gap = -infinity;
    const auto try_axis = [&](const DVec3& axis) { gap = std::max(gap, gap_along(axis, a.vertices(), b.vertices())); };
    for (const Plane& plane : a.mesh().facets) try_axis(plane.normal);
    for (const Plane& plane : b.mesh().facets) try_axis(plane.normal);
    if (gap > tolerance) return Arrangement::disjoint;
    const std::vector<DVec3> edges_b = edge_directions(b.mesh());
    for (const DVec3& edge_a : edge_directions(a.mesh())) {
        for (const DVec3& edge_b : edges_b) {
            const DVec3 axis = cross(edge_a, edge_b);
            // Parallel edges make no axis of their own.
            if (length2(axis) > 1e-20) try_axis(unit(axis));
        }
        if (gap > tolerance) return Arrangement::disjoint;
    }
    return gap >= -tolerance ? Arrangement::touching : Arrangement::overlapping;
}

Arrangement sphere_pair(const Sphere& a, const Sphere& b) {
    const double tolerance = slack_of(a) + slack_of(b);
    const double distance = length(a.center - b.center);
    if (distance + b.radius <= a.radius + tolerance) return Arrangement::a_contains_b;
    if (distance + a.radius <= b.radius + tolerance) return Arrangement::b_contains_a;
    if (distance > a.radius + b.radius + tolerance) return Arrangement::disjoint;
    return distance >= a.radius + b.radius - tolerance ? Arrangement::touching : Arrangement::overlapping;
}

Arrangement sphere_and_mesh(const Sphere& a, const Mesh& b) {
    double farthest = 0.0;
    for (const DVec3& p : b.vertices) farthest = std::max(farthest, length(p - a.center));
    if (farthest <= a.radius + slack_of(a) + slack(b)) return Arrangement::a_contains_b;
    bool touching = false;
    for (std::size_t t = 0; t < b.triangles.size(); ++t) {
        const auto& v = b.triangles[t];
        const DVec3 nearest = closest_on_triangle(b.vertices[v[0]], b.vertices[v[1]], b.vertices[v[2]], a.center);
        const double gap = length(nearest - a.center) - a.radius;
        const double tolerance = slack_of(a) + slack(b, t);
        if (gap < -tolerance) return Arrangement::overlapping;
        touching = touching || gap <= tolerance;
    }
    if (encloses(b, a.center)) return Arrangement::b_contains_a;
    return touching ? Arrangement::touching : Arrangement::disjoint;
}

struct Corners {
    DVec3 a, b, c, low, high;
    double slack = 0.0;
};

std::vector<Corners> corners_of(const Mesh& mesh) {
    std::vector<Corners> all;
    all.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& v = mesh.triangles[t];
        const DVec3& a = mesh.vertices[v[0]];
        const DVec3& b = mesh.vertices[v[1]];
        const DVec3& c = mesh.vertices[v[2]];
        all.push_back({a, b, c, glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), slack(mesh, t)});
    }
    return all;
}

// Whether an edge of `s` goes through `t`, clear of its rim and of its plane by more than `tolerance`.
bool pierces(const Corners& s, const Corners& t, double tolerance) {
    const DVec3 normal = unit(cross(t.b - t.a, t.c - t.a));
    const std::array<DVec3, 3> rim{t.a, t.b, t.c};
    const std::array<std::pair<DVec3, DVec3>, 3> edges{std::pair{s.a, s.b}, {s.b, s.c}, {s.c, s.a}};
    return std::any_of(edges.begin(), edges.end(), [&](const auto& edge) {
        const double from = dot(normal, edge.first - t.a);
        const double to = dot(normal, edge.second - t.a);
        if (std::min(from, to) >= -tolerance || std::max(from, to) <= tolerance) return false;
        const DVec3 at = edge.first + from / (from - to) * (edge.second - edge.first);
        for (std::size_t k = 0; k < 3; ++k) {
            const DVec3 side = rim[(k + 1) % 3] - rim[k];
            if (dot(cross(normal, side), at - rim[k]) <= tolerance * length(side)) return false;
        }
        return true;
    });
}

// Points just inside the surface, one per triangle.
struct Inner {
    bool some_in = false;   // inside the other mesh
    bool some_out = false;  // outside it
};

// Deep enough to be off a common boundary, shallow enough to stay inside; thinner parts are not resolved.
Inner inner_points(const Mesh& mesh, const Mesh& other) {
    Inner seen;
    const double slack_of_other = slack(other);
    for (std::size_t t = 0; t < mesh.triangles.size() && !(seen.some_in && seen.some_out); ++t) {
        const auto& v = mesh.triangles[t];
        const DVec3 middle = (mesh.vertices[v[0]] + mesh.vertices[v[1]] + mesh.vertices[v[2]]) / 3.0;
        const DVec3 normal =
            unit(cross(mesh.vertices[v[1]] - mesh.vertices[v[0]], mesh.vertices[v[2]] - mesh.vertices[v[0]]));
        const double depth = 1e3 * (slack(mesh, t) + slack_of_other);
        (encloses(other, middle - depth * normal) ? seen.some_in : seen.some_out) = true;
    }
    return seen;
}

Arrangement mesh_pair(const Mesh& a, const Mesh& b) {
    const std::vector<Corners> triangles_a = corners_of(a);
    std::vector<Corners> triangles_b = corners_of(b);
    std::sort(triangles_b.begin(), triangles_b.end(), [](const auto& s, const auto& t) { return s.low.x < t.low.x; });
    const double slack_of_b = slack(b);
    bool near = false;
    for (const Corners& s : triangles_a) {
        for (const Corners& t : triangles_b) {
            if (t.low.x > s.high.x + s.slack + slack_of_b) break;
            const double tolerance = s.slack + t.slack;
            const DVec3 between = glm::max(s.low - t.high, t.low - s.high);
            if (std::max({between.x, between.y, between.z}) > tolerance) continue;
            if (pierces(s, t, tolerance) || pierces(t, s, tolerance)) return Arrangement::overlapping;
            const auto touches = [&](const DVec3& p, const Corners& f) {
                return length(closest_on_triangle(f.a, f.b, f.c, p) - p) <= tolerance;
            };
            near = near || touches(s.a, t) || touches(s.b, t) || touches(s.c, t) || touches(t.a, s) ||
                   touches(t.b, s) || touches(t.c, s);
        }
    }
    const Inner of_b = inner_points(b, a);
    if (!of_b.some_out) return Arrangement::a_contains_b;
    const Inner of_a = inner_points(a, b);
    if (!of_a.some_out) return Arrangement::b_contains_a;
    if (of_a.some_in || of_b.some_in || !flush_facets(a, b, Facing::same).empty()) return Arrangement::overlapping;
    return near ? Arrangement::touching : Arrangement::disjoint;
}

}  // namespace

double slack(const SolidRef& solid) {
    return std::visit(Overloaded{
                          [](const HalfSpaceSolid* s) { return s->slack(); },
                          [](const Sphere* s) { return slack_of(*s); },
                          [](const Mesh* m) { return slack(*m); },
                      },
                      solid);
}

Arrangement arrangement(const SolidRef& a, const SolidRef& b) {
    const auto* sphere_a = std::get_if<const Sphere*>(&a);
    const auto* sphere_b = std::get_if<const Sphere*>(&b);
    if (sphere_a != nullptr && sphere_b != nullptr) return sphere_pair(**sphere_a, **sphere_b);
    if (sphere_a != nullptr) return sphere_and_mesh(**sphere_a, *mesh_of(b));
    if (sphere_b != nullptr) return swapped(sphere_and_mesh(**sphere_b, *mesh_of(a)));
    const auto* convex_a = std::get_if<const HalfSpaceSolid*>(&a);
    const auto* convex_b = std::get_if<const HalfSpaceSolid*>(&b);
    if (convex_a != nullptr && convex_b != nullptr) return convex_pair(**convex_a, **convex_b);
    return mesh_pair(*mesh_of(a), *mesh_of(b));
}

std::vector<FacetPair> common_facets(const SolidRef& a, const SolidRef& b, Facing facing) {
    const Mesh* mesh_a = mesh_of(a);
    const Mesh* mesh_b = mesh_of(b);
    if (mesh_a != nullptr && mesh_b != nullptr) return flush_facets(*mesh_a, *mesh_b, facing);
    const auto* sphere_a = std::get_if<const Sphere*>(&a);
    const auto* sphere_b = std::get_if<const Sphere*>(&b);
    if (sphere_a == nullptr || sphere_b == nullptr || facing == Facing::opposite) return {};
    const double distance = slack(a) + slack(b);
    const bool equal = length((*sphere_a)->center - (*sphere_b)->center) <= distance &&
                       std::abs((*sphere_a)->radius - (*sphere_b)->radius) <= distance;
    return equal ? std::vector<FacetPair>{{0, 0, distance}} : std::vector<FacetPair>{};
}

}  // namespace pol
