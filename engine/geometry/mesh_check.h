// SPDX-License-Identifier: Apache-2.0
// From triangles as a file gives them to a Mesh with facets, and the checks that a solid must pass.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/result.h"
#include "core/vec.h"
#include "geometry/mesh.h"

namespace pol {

/// Welds equal vertices, and groups coplanar neighbors into facets whose planes are fitted in double over all their
/// triangles. Tolerances follow each connected piece and the precision of the numbers, not the distance from the
/// origin: vertices are equal within 1e-7 of the size of their piece, or what rounding may have moved both (of 32-bit
/// numbers, if all coordinates are such); neighbors are coplanar within four times that rounding, or 1e-6 of the size
/// if they bend by less than 1e-4 rad. Error, naming vertices or triangles (from 0, as given), for coordinates that are
/// not finite or too coarse for their piece, indices out of range, degenerate triangles and duplicates.
Result<Mesh> mesh_from_triangles(std::vector<DVec3> vertices, std::vector<std::array<std::uint32_t, 3>> triangles);

/// Whether the mesh bounds a solid: every edge shared by exactly two triangles that run along it in opposite
/// directions, positive volume. The error says which edge, triangles and vertices (as numbered in `mesh`). Surfaces
/// that cut through themselves are not found.
Result<Done> check_closed(const Mesh& mesh);

/// Whether no vertex lies outside any facet's plane by more than the slack (below). Requires: closed.
/// Time: facets x vertices if it is convex.
bool is_convex(const Mesh& mesh);

/// Volume by the divergence theorem; negative if inside out.
double signed_volume(const Mesh& mesh);

/// Whether `p` lies inside, by the summed solid angle of all triangles (A. Van Oosterom, J. Strackee, IEEE TBME 30,
/// 1983). Either answer on the surface itself. Time: linear. Requires: closed.
bool encloses(const Mesh& mesh, const DVec3& p);

/// Share of its coordinates that rounding may have moved a point by: 45 ulp, for a transform and a plane fit or two.
inline constexpr double rounding_share = 1e-14;

/// How far a triangle may be from where it belongs: twice what its corners are off the plane of its facet, which tells
/// the precision of its numbers, and rounding_share of its largest coordinate. Other parts of the mesh do not matter.
double slack(const Mesh& mesh, std::size_t triangle);

/// The largest slack of any triangle.
double slack(const Mesh& mesh);

}  // namespace pol
