// SPDX-License-Identifier: Apache-2.0
// All scenes that ship with the program.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "support/render_scene.h"
#include "verify/invariants/scene_twins.h"

namespace pol::test {

/// Every scene below assets/scenes, named as shipped_scene() takes it, sorted: a new scene is tested without being
/// listed.
inline std::vector<std::string> shipped_scene_names() {
    const std::filesystem::path root = std::filesystem::path(POL_ASSETS) / "scenes";
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root))
        if (entry.path().extension() == ".yaml")
            names.push_back(std::filesystem::relative(entry.path(), root).replace_extension().generic_string());
    std::sort(names.begin(), names.end());
    return names;
}

/// "paper-glass-unpolarized" as a GoogleTest parameter name.
inline std::string test_name(std::string scene) {
    std::replace_if(
        scene.begin(), scene.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return scene;
}

using verify::as_furnace;
using verify::carried;
using verify::small;

inline bool has_crystals(const Plan& plan) {
    return plan.kernel().anisotropic;
}

/// Triangles of `a` and `b` as one mesh.
inline Mesh joined(Mesh a, const Mesh& b) {
    const auto first_vertex = static_cast<std::uint32_t>(a.vertices.size());
    const auto first_facet = static_cast<std::uint32_t>(a.facets.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    a.facets.insert(a.facets.end(), b.facets.begin(), b.facets.end());
    for (const auto& t : b.triangles)
        a.triangles.push_back({t[0] + first_vertex, t[1] + first_vertex, t[2] + first_vertex});
    for (const std::uint32_t facet : b.facet_of_triangle) a.facet_of_triangle.push_back(facet + first_facet);
    return a;
}

}  // namespace pol::test
