// SPDX-License-Identifier: Apache-2.0
// What several geometry tests throw rays at, and with.
#pragma once

#include <cmath>
#include <cstdint>
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
