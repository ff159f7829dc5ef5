// SPDX-License-Identifier: Apache-2.0
// How two solids lie to each other. Slow and careful: used when a scene is checked, never while rays fly.
#pragma once

#include <variant>
#include <vector>

#include "geometry/facet_contact.h"
#include "geometry/half_space_solid.h"
#include "geometry/mesh.h"
#include "geometry/sphere.h"

namespace pol {

/// A solid of any kind; a Mesh must be closed. Pointers are borrowed for the call.
using SolidRef = std::variant<const HalfSpaceSolid*, const Sphere*, const Mesh*>;

enum class Arrangement {
    disjoint,
    touching,      ///< apart by no more than rounding, interiors apart
    a_contains_b,  ///< b within a; common boundary allowed
    b_contains_a,
    overlapping,  ///< some volume in common, some not
};

/// How far the surface of a solid may be from where it belongs: rounding of its coordinates, and for meshes twice what
/// their corners are off their facets' planes (mesh_check.h).
double slack(const SolidRef& solid);

/// How `a` and `b` lie to each other. Lengths count as zero below the slack of both, where they meet: a gap that is
/// more than rounding is a gap. Equal solids: a_contains_b. Methods: convex pairs by separating axes (face normals and
/// edge cross products; Gottschalk et al., OBBTree, SIGGRAPH 1996, sec. 5), spheres by distance, non-convex meshes by
/// triangle pairs and containment (those count as touching where a corner of one lies on the other).
Arrangement arrangement(const SolidRef& a, const SolidRef& b);

/// Facets of `a` and `b` that lie in one plane, face each other or the same way and share an area, see facet_contact.h.
/// Two equal spheres are one facet each that face the same way; else a sphere has none.
std::vector<FacetPair> common_facets(const SolidRef& a, const SolidRef& b, Facing facing);

}  // namespace pol
