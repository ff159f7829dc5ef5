// SPDX-License-Identifier: Apache-2.0
// Triangles grouped into flat facets, in double precision. Normals come from here, never from Embree.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace pol {

/// Points x with dot(normal, x) = offset; normal is unit and points out of the solid.
struct Plane {
    DVec3 normal{};
    double offset = 0.0;
};

/// Polygon soup with shared vertices. facet_of_triangle[t] names the plane in `facets` that triangle t lies in;
/// coplanar neighbours share a facet. Triangles are counter-clockwise seen from outside.
struct Mesh {
    std::vector<DVec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> facet_of_triangle;
    std::vector<Plane> facets;
};

}  // namespace pol
