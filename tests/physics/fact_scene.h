// SPDX-License-Identifier: Apache-2.0
// Scenes of physical facts as text, and the light that came along one named path.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/units.h"
#include "polarization/measures.h"
#include "support/render_scene.h"

namespace pol::test {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Half a unit in the last of `digits` printed decimals, and a hair.
inline double printed(int digits) {
    return 0.5000001 * std::pow(10.0, -digits);
}

/// All 17 digits, so that the loader reads the same double.
inline std::string text(double value) {
    std::ostringstream out;
    out << std::setprecision(17) << value;
    return out.str();
}
inline std::string text(const DVec3& v) {
    return "[" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + "]";
}

/// Directions that meet the plane z = 0 from above and leave it after reflection, at the angle `i` from the normal, in
/// the plane y = 0.
inline DVec3 downward(double i) {
    return {std::sin(i), 0.0, -std::cos(i)};
}
inline DVec3 upward(double i) {
    return {std::sin(i), 0.0, std::cos(i)};
}

/// Camera at `from` whose picture's x axis is -y: s for every surface across the plane y = 0, so that S1 is s minus p.
/// Requires: `from` and `target` have the same y.
inline std::string camera_seeing_s_as_x(const DVec3& from, const DVec3& target) {
    const DVec3 d = unit(target - from);
    return "camera: {type: orthographic, position: " + text(from) + ", target: " + text(target) +
           ", up: " + text(DVec3(-d.z, 0.0, d.x)) + ", width: 0.01}\n";
}

/// Camera in front of the origin, looking along `direction`, otherwise as above.
inline std::string camera_along(const DVec3& direction, double distance = 5.0) {
    return camera_seeing_s_as_x(-direction * distance, DVec3(0.0));
}

/// Transform step that puts a flat shape's centre at `center`, its x axis along `x` and its front towards `normal`.
inline std::string placed(const DVec3& center, const DVec3& normal, const DVec3& x) {
    const DVec3 y = cross(normal, x);
    std::string rows;
    for (int i = 0; i < 3; ++i)
        rows += (i == 0 ? "[" : ", [") + text(x[i]) + ", " + text(y[i]) + ", " + text(normal[i]) + ", " +
                text(center[i]) + "]";
    return "transform: [{matrix: [" + rows + "]}]";
}

/// Square lamp whose x axis is -y, as that of the cameras above; `emission` in YAML.
inline std::string lamp(const std::string& name, const DVec3& center, const DVec3& normal, double size,
                        const std::string& emission = "radiance: 1") {
    return "  - {name: " + name + ", shape: {rectangle: {size: " + text(size) + "}}, " +
           placed(center, normal, DVec3(0.0, -1.0, 0.0)) + ", emission: {" + emission + "}}\n";
}

/// Unit radiance in the state (s1, s2, s3).
inline std::string polarized(const std::string& stokes) {
    return "radiance: 1, polarization: {stokes: " + stokes + "}";
}

inline std::string box(const std::string& name, const DVec3& size, const DVec3& center, const std::string& medium) {
    return "  - {name: " + name + ", shape: {box: {size: " + text(size) +
           "}}, transform: [{translate: " + text(center) + "}], medium: " + medium + "}\n";
}

/// A block with its top in the plane z = 0 that swallows what it lets in.
inline std::string deep_block(const std::string& medium) {
    return box("block", {40.0, 40.0, 4.0}, {0.0, 0.0, -2.0}, medium) +
           "  - {name: bottom, shape: {rectangle: {size: 39}}, transform: [{translate: [0, 0, -2]}], absorber: on}\n";
}

/// How light came from leaf `leaf` to the camera, followed backward: R reflected, T transmitted, S through a sheet.
inline std::string route(const RayTree& tree, int leaf) {
    std::string letters;
    for (int i = leaf; i > 0; i = tree.nodes[static_cast<std::size_t>(i)].parent) {
        switch (tree.nodes[static_cast<std::size_t>(i)].interaction) {
            case Interaction::reflected:
                letters += 'R';
                break;
            case Interaction::transmitted:
                letters += 'T';
                break;
            case Interaction::sheet:
                letters += 'S';
                break;
            case Interaction::camera:
                break;
        }
    }
    return {letters.rbegin(), letters.rend()};
}

/// Branches of the only path with light whose route is `letters`, from the camera ray to the leaf.
inline std::vector<const RayTreeNode*> path(const Explanation& explanation, const std::string& letters) {
    const RayTree& tree = explanation.tree;
    std::vector<const RayTreeNode*> branches;
    for (const int leaf : tree.leaves) {
        const RayTreeNode& end = tree.nodes[static_cast<std::size_t>(leaf)];
        if (end.estimated || !end.brings_light() || route(tree, leaf) != letters) continue;
        if (!branches.empty()) throw std::runtime_error("two paths " + letters);
        for (int i = leaf; i >= 0; i = tree.nodes[static_cast<std::size_t>(i)].parent)
            branches.insert(branches.begin(), &tree.nodes[static_cast<std::size_t>(i)]);
    }
    if (branches.empty()) throw std::runtime_error("no light came along " + letters);
    return branches;
}
/// The branches point into the explanation: it must not be a temporary.
std::vector<const RayTreeNode*> path(Explanation&&, const std::string&) = delete;

/// What the only path with that route brings to the pixel.
inline Stokes<double> light_along(const Explanation& explanation, const std::string& letters) {
    if (!explanation.exact()) throw std::runtime_error("the explanation is not the picture");
    return path(explanation, letters).back()->light;
}
inline Stokes<double> light_along(const std::string& yaml, const std::string& letters) {
    return light_along(explain_look(scene_of(yaml)), letters);
}

/// Fresnel's formulas as Born & Wolf write them (7th ed., 1.5.2 and 14.4.1), signs after Verdet, for any complex index
/// n = n2/n1 and the angle of incidence i.
struct ClosedFresnel {
    std::complex<double> r_s, r_p;
    ClosedFresnel(std::complex<double> n, double i) {
        const double c = std::cos(i);
        const std::complex<double> cos_t = std::sqrt(1.0 - std::sin(i) * std::sin(i) / (n * n));
        r_s = (c - n * cos_t) / (c + n * cos_t);
        r_p = (n * c - cos_t) / (n * c + cos_t);
    }
    [[nodiscard]] double R_s() const { return std::norm(r_s); }
    [[nodiscard]] double R_p() const { return std::norm(r_p); }
    /// Stokes vector of reflected light of unit power that was linear at +45 degrees between s and p.
    [[nodiscard]] Stokes<double> of_diagonal_light() const {
        const std::complex<double> xy = r_s * std::conj(r_p);
        return {0.5 * (R_s() + R_p()), 0.5 * (R_s() - R_p()), xy.real(), xy.imag()};
    }
};

/// Every component to `tolerance`.
inline void expect_stokes(const Stokes<double>& got, const Stokes<double>& expected, double tolerance) {
    EXPECT_NEAR(got.s0, expected.s0, tolerance);
    EXPECT_NEAR(got.s1, expected.s1, tolerance);
    EXPECT_NEAR(got.s2, expected.s2, tolerance);
    EXPECT_NEAR(got.s3, expected.s3, tolerance);
}

}  // namespace pol::test
