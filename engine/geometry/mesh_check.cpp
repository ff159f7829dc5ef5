// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "core/units.h"
#include "geometry/complaint.h"
#include "geometry/mesh_pieces.h"

namespace pol {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

// Of the size of a piece: float32 keeps 24 bits, and coordinates about the origin, perhaps turned and scaled since, are
// off by up to 6e-8 of it.
constexpr double weld_tolerance = 1e-7;
constexpr double flatness_tolerance = 1e-6;
// Of the height of a triangle: a bend of more than 1e-4 rad is one, unless rounding of the coordinates explains it.
constexpr double bend_tolerance = 1e-4;
// Of the size of a piece: numbers so coarse leave little of its shape.
constexpr double most_rounding = 1e-2;

Error broken(std::string what, std::string hint) {
    return complaint("", std::move(what), std::move(hint));
}

std::string text(const DVec3& p) {
    char buffer[96];
    std::snprintf(buffer, sizeof buffer, "(%.9g, %.9g, %.9g)", p.x, p.y, p.z);
    return buffer;
}

std::string text(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.3g", x);
    return buffer;
}

Error too_coarse(const DVec3& p, int bits, double size) {
    return broken("coordinates near " + text(p) + " are " + std::to_string(bits) +
                      "-bit numbers, too coarse there for a piece of size " + text(size),
                  "move the model to its origin before it is exported, and back by 'transform'");
}

std::string vertex_name(const Mesh& mesh, std::uint32_t v) {
    return "vertex " + std::to_string(v) + " " + text(mesh.vertices[v]);
}

std::uint64_t edge_key(std::uint32_t from, std::uint32_t to) {
    return (std::uint64_t{from} << 32U) | to;
}

double largest_coordinate(const std::vector<DVec3>& vertices) {
    double largest = 0.0;
    for (const DVec3& p : vertices) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return largest;
}

DVec3 vector_area(const Mesh& mesh, std::size_t t) {
    const Triangle& v = mesh.triangles[t];
    const DVec3& a = mesh.vertices[v[0]];
    return 0.5 * cross(mesh.vertices[v[1]] - a, mesh.vertices[v[2]] - a);
}

// Which triangles run along a directed edge. Sorted, not hashed: 16 bytes per edge, ten million triangles fit.
class EdgeTable {
public:
    struct Entry {
        std::uint64_t key;
        std::uint32_t triangle;
    };

    explicit EdgeTable(const Mesh& mesh) {
        entries_.reserve(3 * mesh.triangles.size());
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const Triangle& v = mesh.triangles[t];
            for (std::size_t k = 0; k < 3; ++k) {
                entries_.push_back({edge_key(v[k], v[(k + 1) % 3]), static_cast<std::uint32_t>(t)});
            }
        }
        std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
            return a.key != b.key ? a.key < b.key : a.triangle < b.triangle;
        });
    }

    std::span<const Entry> along(std::uint32_t from, std::uint32_t to) const {
        const std::uint64_t key = edge_key(from, to);
        const auto first = std::lower_bound(entries_.begin(), entries_.end(), key,
                                            [](const Entry& e, std::uint64_t k) { return e.key < k; });
        auto last = first;
        while (last != entries_.end() && last->key == key) ++last;
        return {first, last};
    }

private:
    std::vector<Entry> entries_;
};

std::optional<std::pair<std::size_t, std::size_t>> first_duplicate(const std::vector<Triangle>& triangles) {
    std::vector<std::pair<Triangle, std::size_t>> sorted;
    sorted.reserve(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        Triangle corners = triangles[t];
        std::sort(corners.begin(), corners.end());
        sorted.emplace_back(corners, t);
    }
    std::sort(sorted.begin(), sorted.end());
    const auto same = std::adjacent_find(sorted.begin(), sorted.end(),
                                         [](const auto& a, const auto& b) { return a.first == b.first; });
    if (same == sorted.end()) return std::nullopt;
    return std::pair{same->second, std::next(same)->second};
}

// Plane of a growing facet: normal from the summed vector area (Newell), offset from the area-weighted centroid.
struct FacetFit {
    DVec3 vector_area{0.0};
    DVec3 moment{0.0};
    double area = 0.0;

    void add(const Mesh& mesh, std::size_t t) {
        const DVec3 own = pol::vector_area(mesh, t);
        const double weight = std::sqrt(length2(own));
        const Triangle& v = mesh.triangles[t];
        vector_area += own;
        area += weight;
        moment += weight / 3.0 * (mesh.vertices[v[0]] + mesh.vertices[v[1]] + mesh.vertices[v[2]]);
    }
    Plane plane() const {
        const DVec3 normal = unit(vector_area);
        return {normal, dot(normal, moment) / area};
    }
};

double lowest_height(const Mesh& mesh, std::size_t t) {
    const Triangle& v = mesh.triangles[t];
    const double longest2 = std::max({length2(mesh.vertices[v[1]] - mesh.vertices[v[0]]),
                                      length2(mesh.vertices[v[2]] - mesh.vertices[v[1]]),
                                      length2(mesh.vertices[v[0]] - mesh.vertices[v[2]])});
    return 2.0 * std::sqrt(length2(vector_area(mesh, t)) / longest2);
}

// How far the corners of triangle `t` may be off the plane of a facet that it joins. Corners and plane are both
// rounded.
double flatness(const Mesh& mesh, const Precision& precision, std::size_t t) {
    double rounding = 0.0;
    for (const std::uint32_t v : mesh.triangles[t]) {
        rounding = std::max(rounding, precision.rounding(mesh.vertices[v]));
    }
    const double size = precision.piece_size(mesh.triangles[t][0]);
    return std::max(4.0 * rounding, std::min(flatness_tolerance * size, bend_tolerance * lowest_height(mesh, t)));
}

// Flood fill over shared edges, largest triangles first: their planes are known best.
void group_facets(Mesh& mesh, const Precision& precision) {
    constexpr std::uint32_t none = ~0U;
    const std::size_t count = mesh.triangles.size();
    std::vector<double> areas(count);
    for (std::size_t t = 0; t < count; ++t) areas[t] = std::sqrt(length2(vector_area(mesh, t)));
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return areas[a] > areas[b]; });

    const EdgeTable edges(mesh);
    mesh.facet_of_triangle.assign(count, none);
    mesh.facets.clear();
    for (const std::uint32_t seed : order) {
        if (mesh.facet_of_triangle[seed] != none) continue;
        const auto facet = static_cast<std::uint32_t>(mesh.facets.size());
        FacetFit fit;
        std::vector<std::uint32_t> members;
        const auto join = [&](std::uint32_t t) {
            mesh.facet_of_triangle[t] = facet;
            fit.add(mesh, t);
            members.push_back(t);
        };
        join(seed);
        for (std::size_t i = 0; i < members.size(); ++i) {
            const Triangle& v = mesh.triangles[members[i]];
            for (std::size_t k = 0; k < 3; ++k) {
                for (const auto& [key, next] : edges.along(v[(k + 1) % 3], v[k])) {
                    if (mesh.facet_of_triangle[next] != none) continue;
                    const Plane plane = fit.plane();
                    const Triangle& w = mesh.triangles[next];
                    const double tolerance = flatness(mesh, precision, next);
                    const bool flat = std::all_of(w.begin(), w.end(), [&](std::uint32_t p) {
                        return std::abs(dot(plane.normal, mesh.vertices[p]) - plane.offset) <= tolerance;
                    });
                    if (flat && dot(plane.normal, vector_area(mesh, next)) > 0.0) join(next);
                }
            }
        }
        mesh.facets.push_back(fit.plane());
    }
}

}  // namespace

Result<Mesh> mesh_from_triangles(std::vector<DVec3> vertices, std::vector<Triangle> triangles) {
    if (triangles.empty()) return broken("the mesh has no triangles", "a mesh needs at least one face");
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const DVec3& p = vertices[v];
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
            return broken("vertex " + std::to_string(v) + " is not finite", "repair the file in a modeling program");
        }
    }
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (const std::uint32_t v : triangles[t]) {
            if (v < vertices.size()) continue;
            return broken("triangle " + std::to_string(t) + " uses vertex " + std::to_string(v) + " of " +
                              std::to_string(vertices.size()),
                          "vertices count from 0 here");
        }
    }
    const double scale = largest_coordinate(vertices);
    // 1e100 keeps products of three coordinates finite.
    if (!(scale < 1e100)) return broken("coordinates reach " + std::to_string(scale), "scale the model down");
    if (!(scale > 1e-100)) return broken("all vertices lie at the origin", "scale the model up");

    const Precision given(vertices, triangles);
    std::vector<double> tolerances(vertices.size());
    for (std::uint32_t v = 0; v < vertices.size(); ++v) {
        const double rounding = given.rounding(vertices[v]);
        const double size = given.piece_size(v);
        if (size > 0.0 && rounding > most_rounding * size) return too_coarse(vertices[v], given.bits(), size);
        tolerances[v] = std::max(weld_tolerance * size, 2.0 * rounding);
    }
    Mesh mesh;
    const std::vector<std::uint32_t> target = weld(vertices, tolerances, mesh.vertices);
    mesh.triangles.reserve(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Triangle& corners = triangles[t];
        const Triangle v{target[corners[0]], target[corners[1]], target[corners[2]]};
        mesh.triangles.push_back(v);
        const double least = tolerances[corners[0]];
        if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0] || !(lowest_height(mesh, t) > least)) {
            return broken("triangle " + std::to_string(t) + " is degenerate (vertices " + std::to_string(corners[0]) +
                              ", " + std::to_string(corners[1]) + ", " + std::to_string(corners[2]) + " near " +
                              text(mesh.vertices[v[0]]) + "): less than " + text(least) + " high",
                          "remove faces without area in a modeling program");
        }
    }
    if (const auto same = first_duplicate(mesh.triangles)) {
        return broken("triangles " + std::to_string(same->first) + " and " + std::to_string(same->second) +
                          " have the same corners (near " + text(mesh.vertices[mesh.triangles[same->first][0]]) + ")",
                      "remove duplicate faces in a modeling program");
    }
    group_facets(mesh, Precision(mesh.vertices, mesh.triangles));
    return mesh;
}

Result<Done> check_closed(const Mesh& mesh) {
    if (mesh.triangles.empty()) return broken("the mesh has no triangles", "a solid needs at least four");
    const EdgeTable edges(mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles[t][k];
            const std::uint32_t b = mesh.triangles[t][(k + 1) % 3];
            const auto edge = [&] { return "the edge from " + vertex_name(mesh, a) + " to " + vertex_name(mesh, b); };
            const auto along = edges.along(a, b);
            if (along.size() > 1) {
                return broken(edge() + " is used in the same direction by triangles " +
                                  std::to_string(along[0].triangle) + " and " + std::to_string(along[1].triangle),
                              "each edge of a solid joins two faces with the same sense of rotation");
            }
            if (edges.along(b, a).empty()) {
                return broken("hole: " + edge() + " belongs to triangle " + std::to_string(t) + " alone",
                              "close the surface in a modeling program");
            }
        }
    }
    const double volume = signed_volume(mesh);
    if (!(volume > 0.0)) {
        return broken("the mesh is inside out (volume " + std::to_string(volume) + ", from triangle 0 to " +
                          std::to_string(mesh.triangles.size() - 1) + ")",
                      "reverse its faces: corners run counter-clockwise seen from outside");
    }
    return Done{};
}

bool is_convex(const Mesh& mesh) {
    const double tolerance = slack(mesh);
    const auto inside = [&](const Plane& plane, std::uint32_t v) {
        return dot(plane.normal, mesh.vertices[v]) - plane.offset <= tolerance;
    };
    // Neighbors first: a surface that is not convex nearly always shows it at an edge, in linear time.
    const EdgeTable edges(mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Triangle& v = mesh.triangles[t];
            for (const auto& [key, neighbor] : edges.along(v[(k + 1) % 3], v[k])) {
                for (const std::uint32_t p : mesh.triangles[neighbor]) {
                    if (!inside(mesh.facets[mesh.facet_of_triangle[t]], p)) return false;
                }
            }
        }
    }
    return std::all_of(mesh.facets.begin(), mesh.facets.end(), [&](const Plane& plane) {
        for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
            if (!inside(plane, v)) return false;
        }
        return true;
    });
}

double signed_volume(const Mesh& mesh) {
    if (mesh.vertices.empty()) return 0.0;
    const DVec3 from = mesh.vertices.front();
    double six_volumes = 0.0;
    for (const Triangle& v : mesh.triangles) {
        six_volumes += dot(mesh.vertices[v[0]] - from, cross(mesh.vertices[v[1]] - from, mesh.vertices[v[2]] - from));
    }
    return six_volumes / 6.0;
}

bool encloses(const Mesh& mesh, const DVec3& p) {
    double half_angle = 0.0;
    for (const Triangle& v : mesh.triangles) {
        const DVec3 a = mesh.vertices[v[0]] - p;
        const DVec3 b = mesh.vertices[v[1]] - p;
        const DVec3 c = mesh.vertices[v[2]] - p;
        const double la = std::sqrt(length2(a));
        const double lb = std::sqrt(length2(b));
        const double lc = std::sqrt(length2(c));
        half_angle += std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    // 2 pi in half angles inside, 0 outside.
    return half_angle > pi;
}

double slack(const Mesh& mesh, std::size_t triangle) {
    const Plane& plane = mesh.facets[mesh.facet_of_triangle[triangle]];
    double off = 0.0;
    double largest = 0.0;
    for (const std::uint32_t v : mesh.triangles[triangle]) {
        const DVec3& p = mesh.vertices[v];
        off = std::max(off, std::abs(dot(plane.normal, p) - plane.offset));
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    return 2.0 * off + rounding_share * largest;
}

double slack(const Mesh& mesh) {
    double largest = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) largest = std::max(largest, slack(mesh, t));
    return largest;
}

}  // namespace pol
