// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/vec.h"
#include "geometry/mesh.h"

namespace pol {

/// One facet of each of two solids.
struct FacetPair {
    int a = 0;
    int b = 0;
    double distance = 0.0;  ///< by which the slack of both (mesh_check.h) lets them differ
};

enum class Facing { same, opposite };

/// Facets of `a` and `b` in one plane, facing each other or the same way, that share an area: more than their slack
/// times the smaller facet's extent. In one plane: all corners of one lie in the plane of the other, within the slack
/// of both and `beyond`. Ordered by a, then b.
std::vector<FacetPair> flush_facets(const Mesh& a, const Mesh& b, Facing facing, double beyond = 0.0);

/// The point of triangle abc closest to p (C. Ericson, Real-Time Collision Detection, 2005, sec. 5.1.5).
DVec3 closest_on_triangle(const DVec3& a, const DVec3& b, const DVec3& c, const DVec3& p);

}  // namespace pol
