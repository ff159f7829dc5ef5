// SPDX-License-Identifier: Apache-2.0
// From triangles as a file gives them to a Mesh with facets, and the checks that a solid must pass.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/result.h"
#include "core/vec.h"
#include "geometry/mesh.h"

namespace pol {

/// Welds equal vertices (within 1e-7 of the largest coordinate: float32 files), and groups coplanar neighbors into
/// facets whose planes are fitted in double over all their triangles. Error, naming vertices or triangles (from 0, as
/// given), for coordinates that are not finite, indices out of range, degenerate triangles and duplicates.
Result<Mesh> mesh_from_triangles(std::vector<DVec3> vertices, std::vector<std::array<std::uint32_t, 3>> triangles);

/// Whether the mesh bounds a solid: every edge shared by exactly two triangles that run along it in opposite
/// directions, positive volume. The error says which edge, triangles and vertices (as numbered in `mesh`). Surfaces
/// that cut through themselves are not found.
Result<Done> check_closed(const Mesh& mesh);

/// Whether no vertex lies outside any facet's plane by more than 1e-6 of the size. Requires: closed.
/// Time: facets x vertices if it is convex.
bool is_convex(const Mesh& mesh);

/// Volume by the divergence theorem; negative if inside out.
double signed_volume(const Mesh& mesh);

/// Whether `p` lies inside, by the summed solid angle of all triangles (A. Van Oosterom, J. Strackee, IEEE TBME 30,
/// 1983). Either answer on the surface itself. Time: linear. Requires: closed.
bool encloses(const Mesh& mesh, const DVec3& p);

/// Half the diagonal of the bounding box: the length that relative tolerances refer to.
double mesh_size(const Mesh& mesh);

}  // namespace pol
