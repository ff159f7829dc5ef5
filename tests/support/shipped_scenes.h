// SPDX-License-Identifier: Apache-2.0
// All scenes that ship with the program, and edits of them that leave something unchanged.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "support/render_scene.h"

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

/// The scene as a square picture of `side` pixels, cut as its file asks but after 1000 rays a pixel at most.
inline Scene small(Scene scene, int side) {
    scene.render.width = scene.render.height = side;
    scene.render.node_budget = std::min(scene.render.node_budget, 1000);
    return scene;
}

inline bool has_crystals(const Plan& plan) {
    return plan.features.anisotropic;
}

/// No metal, sheet or black surface, and no medium that absorbs at the scene's wavelengths: light is only redirected.
inline bool is_lossless(const Scene& scene, const Plan& plan) {
    for (const Object& object : scene.objects)
        if (std::holds_alternative<Sheet>(object.role) || std::holds_alternative<Absorber>(object.role)) return false;
    for (const WavelengthGroup& group : plan.groups)
        for (const MediumAt& medium : group.media)
            if (medium.dielectric.kind == MediumKind::conductor || medium.absorption.absorbs()) return false;
    return true;
}

/// Every emitter shines on both sides, unpolarized, with the surroundings' radiance: nothing but light everywhere.
inline Scene as_furnace(Scene scene, double radiance) {
    scene.background.radiance = ConstantSpectrum{radiance};
    for (Object& object : scene.objects)
        if (std::holds_alternative<Emission>(object.role))
            object.role = Emission{Spectrum{ConstantSpectrum{radiance}}, Unpolarized{}, true};
    return scene;
}

/// The whole scene, camera included, turned by the rotation `turn`, then stretched by `scale`, then moved by `shift`.
/// Lengths in wavelengths stay what they were.
inline Scene carried(Scene scene, const DMat3& turn, double scale, const DVec3& shift) {
    const auto point = [&](const DVec3& p) { return turn * p * scale + shift; };
    DMat4 map(turn * scale);
    map[3] = glm::dvec4(shift, 1.0);
    scene.camera.position = point(scene.camera.position);
    scene.camera.target = point(scene.camera.target);
    scene.camera.up = turn * scene.camera.up;
    scene.camera.width *= scale;
    scene.unit_nm /= scale;
    for (Object& object : scene.objects) object.to_world = map * object.to_world;
    for (Medium& medium : scene.media)
        if (auto* crystal = std::get_if<UniaxialMedium>(&medium.matter);
            crystal != nullptr && crystal->axis_space == AxisSpace::world)
            crystal->axis = turn * crystal->axis;
    return scene;
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
