// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/result.h"
#include "geometry/mesh.h"

namespace pol {

/// Closed mesh of the convex solid { x : dot(normal_i, x) <= offset_i for all i }; facet i is planes[i], as given.
/// Each vertex is the least-squares intersection of all planes within 1e-11 of the size from it (usually exactly
/// three). Requires: unit normals. Error if the planes leave the solid unbounded or empty, or if some plane has no face
/// on it.
Result<Mesh> mesh_from_planes(std::span<const Plane> planes);

}  // namespace pol
