// SPDX-License-Identifier: Apache-2.0
// Calcite in scenes of physical facts, and the branches of a tree by the modes they went through.
#pragma once

#include <string>
#include <string_view>

#include "physics/fact_scene.h"

namespace pol::test {

using verify::angle_between;
using verify::calcite;
using verify::e_index;
using verify::eps_e;
using verify::eps_o;
using verify::extruded;
using verify::find_branch;
using verify::kept;
using verify::n_e;
using verify::n_o;
using verify::normal_reflectance;
using verify::plate;
using verify::plate_transmittance;
using verify::share;

/// Rounding of one surface: some 60 operations on numbers of order 1.
constexpr double surface_rounding = 60.0 * eps;

/// The branch that `route` names; throws if there is none.
inline const RayTreeNode& branch(const Explanation& explanation, std::string_view route) {
    const RayTreeNode* found = find_branch(explanation, route);
    if (found == nullptr) throw std::runtime_error("no branch " + std::string(route));
    return *found;
}

/// All passes of a plate: a residual of 1e-14 times radiance 1, and the rounding of a dozen passes that still matter.
constexpr double all_passes = 1e-14 + 12.0 * surface_rounding;

inline const double n_45 = e_index(radians(45.0));

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

}  // namespace pol::test
