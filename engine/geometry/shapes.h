// SPDX-License-Identifier: Apache-2.0
// Shapes as the user writes them, turned into meshes with exact planes.
#pragma once

#include "core/result.h"
#include "core/vec.h"
#include "geometry/mesh.h"
#include "geometry/shape.h"

namespace pol {

/// Mesh of a flat-faced shape in object space. Solids are closed with outward normals; the planes come from the
/// parameters and the vertices from the planes. Rectangle: open, two triangles. Error (with field and hint) for
/// impossible parameters, and for sphere, disk (both curved: analytic elsewhere) and mesh file (see
/// io/meshes/mesh_file.h).
///
/// Facet order, e.g. for naming faces: box -x +x -y +y -z +z; extrusion, prism and rhomb -z, +z, then the sides in
/// the order of the polygon's edges (prism: base, right leg, left leg; rhomb: long face below, exit, long face above,
/// entrance); brilliant: table, 8 bezels, 8 stars, 16 upper girdles, 16 girdle facets, 16 lower girdles, 8 pavilion
/// mains.
Result<Mesh> make_mesh(const Shape& shape);

/// The mesh moved by an affine map, planes recomputed in double. Mirroring maps keep outward normals outward.
/// Error if the map is singular, projective or not finite.
Result<Mesh> transformed(const Mesh& mesh, const DMat4& to_world);

}  // namespace pol
