// SPDX-License-Identifier: Apache-2.0
// Calcite in scenes of physical facts, and the branches of a tree by the modes they went through.
#pragma once

#include <string>
#include <string_view>

#include "physics/fact_scene.h"

namespace pol::test {

/// The literal calcite of physics.md section 5.
constexpr double n_o = 1.6584;
constexpr double n_e = 1.4864;
constexpr double eps_o = n_o * n_o;
constexpr double eps_e = n_e * n_e;

/// Rounding of one surface: some 60 operations on numbers of order 1.
constexpr double surface_rounding = 60.0 * eps;

/// A medium of calcite with its axis in object space.
inline std::string calcite(const DVec3& axis) {
    return "{ordinary: 1.6584, extraordinary: 1.4864, axis: " + text(axis) + "}";
}

/// Fresnel at normal incidence between air and the index n.
inline double normal_reflectance(double n) {
    return std::pow((n - 1.0) / (n + 1.0), 2);
}

/// Convex polygon in the xy plane, 2 high along z.
inline std::string extruded(const std::string& name, const std::vector<DVec2>& polygon, const std::string& medium) {
    std::string corners;
    for (const DVec2& p : polygon) corners += (corners.empty() ? "[" : ", [") + text(p.x) + ", " + text(p.y) + "]";
    return "  - {name: " + name + ", shape: {extrusion: {polygon: [" + corners + "], height: 2}}, medium: " + medium +
           "}\n";
}

/// The branch that `route` names, step by step from the camera ray, or null: R reflected, T transmitted, S through a
/// sheet, followed by o or e if the branch is a single mode of a crystal. "To Re T": in as o, reflected as e, out.
inline const RayTreeNode* find_branch(const Explanation& explanation, std::string_view route) {
    const std::vector<RayTreeNode>& nodes = explanation.tree.nodes;
    const RayTreeNode* at = &nodes.front();
    for (std::size_t i = 0; i < route.size(); ++i) {
        if (route[i] == ' ') continue;
        const Interaction interaction = route[i] == 'R'   ? Interaction::reflected
                                        : route[i] == 'T' ? Interaction::transmitted
                                                          : Interaction::sheet;
        WaveKind kind = WaveKind::pair;
        if (i + 1 < route.size() && (route[i + 1] == 'o' || route[i + 1] == 'e'))
            kind = route[++i] == 'o' ? WaveKind::ordinary : WaveKind::extraordinary;
        const RayTreeNode* next = nullptr;
        for (const int child : at->children) {
            const RayTreeNode& node = nodes[static_cast<std::size_t>(child)];
            if (node.interaction == interaction && node.start.wave.kind == kind) next = &node;
        }
        if (next == nullptr) return nullptr;
        at = next;
    }
    return at;
}

inline const RayTreeNode& branch(const Explanation& explanation, std::string_view route) {
    const RayTreeNode* found = find_branch(explanation, route);
    if (found == nullptr) throw std::runtime_error("no branch " + std::string(route));
    return *found;
}

/// Share of unpolarized light that comes along that branch, 0 if there is none.
inline double share(const Explanation& explanation, std::string_view route) {
    const RayTreeNode* found = find_branch(explanation, route);
    return found == nullptr ? 0.0 : found->start.weight;
}

/// The part of it that is polarized along the unit vector `direction` on the branch itself.
inline double share_along(const Explanation& explanation, std::string_view route, const DVec3& direction) {
    const RayTreeNode& node = branch(explanation, route);
    double sum = 0.0;
    for (int row = 0; row < 2; ++row) {
        Complex<double> amplitude;
        for (int mode = 0; mode < node.start.wave.mode_count(); ++mode)
            amplitude += node.start.throughput.m[row][mode] * dot(node.start.wave.field[mode], direction);
        sum += norm2(amplitude);
    }
    return 0.5 * sum;
}

/// Angle between two unit vectors, good to eps even where it is small.
inline double angle_between(const DVec3& a, const DVec3& b) {
    return std::atan2(std::sqrt(length2(cross(a, b))), dot(a, b));
}

/// All passes of a plate: a residual of 1e-14 times radiance 1, and the rounding of a dozen passes that still matter.
constexpr double all_passes = 1e-14 + 12.0 * surface_rounding;

/// All incoherent passes of a plate of index n at normal incidence.
inline double plate_transmittance(double n) {
    return 2.0 * n / (n * n + 1.0);
}

/// Index of the e wave at the angle theta between wave normal and axis.
inline double e_index(double theta) {
    return 1.0 / std::sqrt(std::pow(std::cos(theta) / n_o, 2) + std::pow(std::sin(theta) / n_e, 2));
}
inline const double n_45 = e_index(radians(45.0));

/// A plate 1 thick with its top in the plane z = 0, turned about z by `turn` degrees.
inline std::string plate(const std::string& name, const std::string& medium, double top = 0.0, double turn = 0.0) {
    return "  - {name: " + name +
           ", shape: {box: {size: [4, 4, 1]}}, transform: [{rotate: {axis: [0, 0, 1], angle: " + text(turn) +
           "}}, {translate: [0, 0, " + text(top - 0.5) + "]}], medium: " + medium + "}\n";
}

/// A lamp of radiance 1 that shines upward, by default all that lies behind a plate.
inline std::string lamp_below(double size = 20.0, const DVec3& place = {0.0, 0.0, -5.0}) {
    return lamp("lamp", place, {0.0, 0.0, 1.0}, size);
}

/// A plate before a lamp, all passes. The camera's x axis is -y, its y axis is x.
inline std::string plate_scene(const std::string& medium, const std::string& render = "{residual: 1e-14}",
                               double i = 0.0) {
    return camera_along(downward(i)) + "render: " + render + "\nmedia: {crystal: " + medium + "}\nobjects:\n" +
           plate("plate", "crystal") + lamp_below();
}

/// Share of branch `child` in what its parent brought to the surface between them: R or T of that surface.
inline double kept(const Explanation& e, const char* child, const char* parent) {
    return share(e, child) / share(e, parent);
}

}  // namespace pol::test
