// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/result.h"
#include "geometry/mesh.h"

namespace pol {

/// Reads a triangle mesh: .obj, .ply (ascii, binary), .stl (ascii, binary), .gltf or .glb (node transforms applied).
/// Polygons are cut into triangles (geometry/polygon_cut.h), vertices welded, coplanar triangles grouped into facets
/// (geometry/mesh_check.h). Open meshes pass; ask check_closed(). Never trusts a count: at most 10 million triangles,
/// sizes are checked against the file before memory is taken. Errors carry the file and the line (text) or say the byte
/// offset (binary).
Result<Mesh> load_mesh(const std::filesystem::path& path);

}  // namespace pol
