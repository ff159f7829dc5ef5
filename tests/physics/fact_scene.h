// SPDX-License-Identifier: Apache-2.0
// The words of verify/ in which tests of physics are written, and what a failing test throws.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/units.h"
#include "polarization/measures.h"
#include "support/render_scene.h"
#include "verify/facts/closed_forms.h"
#include "verify/facts/scene_text.h"
#include "verify/facts/tree_paths.h"

namespace pol::test {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Half a unit in the last of `digits` printed decimals, and a hair.
inline double printed(int digits) {
    return 0.5000001 * std::pow(10.0, -digits);
}

using verify::box;
using verify::camera_along;
using verify::camera_seeing_s_as_x;
using verify::ClosedFresnel;
using verify::deep_block;
using verify::downward;
using verify::lamp;
using verify::placed;
using verify::polarized;
using verify::route;
using verify::text;
using verify::upward;

/// Branches of the only path with light whose route is `letters`, from the camera ray to the leaf; throws if there is
/// none. The branches point into the explanation: it must not be a temporary.
inline std::vector<const RayTreeNode*> path(const Explanation& explanation, const std::string& letters) {
    auto branches = verify::path(explanation, letters);
    if (branches.empty()) throw std::runtime_error("not exactly one path " + letters);
    return branches;
}
std::vector<const RayTreeNode*> path(Explanation&&, const std::string&) = delete;

/// What the only path with that route brings to the pixel.
inline Stokes<double> light_along(const Explanation& explanation, const std::string& letters) {
    if (!explanation.exact()) throw std::runtime_error("the explanation is not the picture");
    return path(explanation, letters).back()->light;
}

/// Every component to `tolerance`.
inline void expect_stokes(const Stokes<double>& got, const Stokes<double>& expected, double tolerance) {
    EXPECT_NEAR(got.s0, expected.s0, tolerance);
    EXPECT_NEAR(got.s1, expected.s1, tolerance);
    EXPECT_NEAR(got.s2, expected.s2, tolerance);
    EXPECT_NEAR(got.s3, expected.s3, tolerance);
}

}  // namespace pol::test
