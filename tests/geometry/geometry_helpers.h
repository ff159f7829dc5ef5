// SPDX-License-Identifier: Apache-2.0
// What several geometry tests throw rays at, and with.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "core/random.h"
#include "core/units.h"
#include "core/vec.h"
#include "geometry/mesh_check.h"

namespace pol::test {

/// Random numbers of a seed, one after the other.
struct Dice {
    RandomKey key{};
    std::uint32_t dimension = 0;
    double next() { return random_unit(key, dimension++); }
    DVec3 direction() {
        const double z = 2.0 * next() - 1.0;
        const double azimuth = 2.0 * pi * next();
        return {std::sqrt(1.0 - z * z) * std::cos(azimuth), std::sqrt(1.0 - z * z) * std::sin(azimuth), z};
    }
};

inline Dice dice(std::uint64_t seed) {
    return {{seed, 0, 0, 0}, 0};
}

/// Adds the triangles of another mesh to one.
inline void append(Mesh& mesh, const Mesh& more) {
    const auto vertices = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto facets = static_cast<std::uint32_t>(mesh.facets.size());
    mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
    for (const auto& t : more.triangles) {
        mesh.triangles.push_back({t[0] + vertices, t[1] + vertices, t[2] + vertices});
    }
    for (const std::uint32_t facet : more.facet_of_triangle) mesh.facet_of_triangle.push_back(facet + facets);
    mesh.facets.insert(mesh.facets.end(), more.facets.begin(), more.facets.end());
}

/// Corners and triangles of a ball of radius 1 about `center`: an icosahedron, each triangle cut in four `level` times.
struct Triangles {
    std::vector<DVec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};
inline Triangles icosphere(int level, const DVec3& center) {
    const double t = 0.5 * (1.0 + std::sqrt(5.0));
    Triangles ball{{{-1, t, 0},
                    {1, t, 0},
                    {-1, -t, 0},
                    {1, -t, 0},
                    {0, -1, t},
                    {0, 1, t},
                    {0, -1, -t},
                    {0, 1, -t},
                    {t, 0, -1},
                    {t, 0, 1},
                    {-t, 0, -1},
                    {-t, 0, 1}},
                   {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    for (DVec3& p : ball.vertices) p = unit(p);
    for (int i = 0; i < level; ++i) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [entry, is_new] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(ball.vertices.size()));
            if (is_new) ball.vertices.push_back(unit(ball.vertices[a] + ball.vertices[b]));
            return entry->second;
        };
        std::vector<std::array<std::uint32_t, 3>> finer;
        for (const auto& [a, b, c] : ball.triangles) {
            const std::uint32_t ab = middle(a, b);
            const std::uint32_t bc = middle(b, c);
            const std::uint32_t ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        ball.triangles = std::move(finer);
    }
    for (DVec3& p : ball.vertices) p += center;
    return ball;
}

/// A cube whose top is pressed in to a pit: closed, not convex.
inline Mesh pitted_cube() {
    const std::vector<DVec3> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},      {0, 0, 1},
                                     {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, 0.5, 0.5}};
    return mesh_from_triangles(corners, {{0, 2, 1},
                                         {0, 3, 2},
                                         {0, 1, 5},
                                         {0, 5, 4},
                                         {1, 2, 6},
                                         {1, 6, 5},
                                         {2, 3, 7},
                                         {2, 7, 6},
                                         {3, 0, 4},
                                         {3, 4, 7},
                                         {4, 5, 8},
                                         {5, 6, 8},
                                         {6, 7, 8},
                                         {7, 4, 8}})
        .value();
}

}  // namespace pol::test
