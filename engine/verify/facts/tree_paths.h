// SPDX-License-Identifier: Apache-2.0
// Named paths and branches of a backward tree, and the light on them.
//
// A path is written as the letters of its interactions, in order of the light or of the backward ray as stated:
// R reflected, T transmitted, S through a sheet.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "tracer/explain.h"

namespace pol::verify {

/// What a number is that the tree has not.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// How light came from leaf `leaf` to the camera, followed backward: "TRRT".
std::string route(const RayTree& tree, int leaf);

/// Branches of the only path with light whose route is `letters`, from the camera ray to the leaf. Empty if there is
/// none, or more than one. They point into the explanation.
std::vector<const RayTreeNode*> path(const Explanation& explanation, std::string_view letters);
std::vector<const RayTreeNode*> path(Explanation&&, std::string_view) = delete;

/// What the only path with that route brings to the pixel; NaN if there is no such path.
Stokes<double> light_along(const Explanation& explanation, std::string_view letters);

/// The branch that `route` names, step by step from the camera ray, or nullptr. Every step may say which mode of a
/// crystal the branch is: "To Re T" goes in as o, is reflected as e, and goes out as a pair. Spaces are for reading.
const RayTreeNode* find_branch(const Explanation& explanation, std::string_view route);

/// Share of unpolarized light that comes along that branch, 0 if there is none.
double share(const Explanation& explanation, std::string_view route);

/// Share of branch `child` in what its parent brought to the surface between them: R or T of that surface. NaN without
/// the parent.
double kept(const Explanation& explanation, std::string_view child, std::string_view parent);
/// kept() of those two, as a reading of a fact measures it. Both names outlive it.
std::function<double(const Explanation&)> kept_by(const char* child, const char* parent);

/// The part of share() that is polarized along the unit vector `direction` on the branch itself.
double share_along(const Explanation& explanation, std::string_view route, const DVec3& direction);

/// Angle between two unit vectors, radians, good to epsilon even where it is small.
double angle_between(const DVec3& a, const DVec3& b);

}  // namespace pol::verify
