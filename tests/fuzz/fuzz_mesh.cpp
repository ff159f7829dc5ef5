// SPDX-License-Identifier: Apache-2.0
// Meshes of all formats. The first byte, '2' to '6' in the corpus, chooses one; the rest is the file. What can be read
// has triangles that name its own vertices and facets.
#include <array>

#include "core/contract.h"
#include "fuzz/fuzz_input.h"
#include "io/meshes/mesh_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::array<const char*, 5> endings = {".obj", ".ply", ".stl", ".gltf", ".glb"};
    if (size == 0) return 0;
    const char* ending = endings[data[0] % endings.size()];
    const auto read = pol::load_mesh(pol::test::as_file(pol::test::as_text(data + 1, size - 1), ending));
    if (!read) return 0;
    const pol::Mesh& mesh = read.value();
    POL_EXPECTS(mesh.facet_of_triangle.size() == mesh.triangles.size());
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle) POL_EXPECTS(vertex < mesh.vertices.size());
    for (const std::uint32_t facet : mesh.facet_of_triangle) POL_EXPECTS(facet < mesh.facets.size());
    return 0;
}
