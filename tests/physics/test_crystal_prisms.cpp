// SPDX-License-Identifier: Apache-2.0
// Crystal prisms and beam splitters beyond facts T27 and T29: that a minimum is one, and what the images look like.
#include "physics/crystal_scene.h"

namespace pol::test {
namespace {

using verify::camera_in_plane;
using verify::lamp_in_plane;

/// A 60 degree prism with its axis along the refracting edge, met at the middle of its left face at the angle `i`.
const DVec3 left_face_middle(-0.5, 0.5 * std::sqrt(3.0), 0.0);
DVec3 towards_left_face(double i) {
    return {std::cos(i - radians(30.0)), std::sin(i - radians(30.0)), 0.0};
}
std::string prism_scene(double i, const std::string& lamp) {
    return camera_in_plane(towards_left_face(i), left_face_middle) + "media: {crystal: " + calcite({0.0, 0.0, 1.0}) +
           "}\nobjects:\n" + extruded("prism", {{-1.0, 0.0}, {1.0, 0.0}, {0.0, std::sqrt(3.0)}}, "crystal") + lamp;
}
double deviation(double i, const char* route) {
    const Explanation e = explain_look(scene_of(prism_scene(i, "")));
    return angle_between(branch(e, "").start.wave.ray, branch(e, route).start.wave.ray);
}

// The angle is the sum of two refractions, each a few roundings of numbers of order 1 with slopes up to 4 (the o ray
// leaves at 56 degrees).
TEST(Prism, T27OfSixtyDegreesDeviatesEachModeByItsOwnMinimum) {
    const struct {
        const char* route;
        double n, printed_degrees;
    } rows[] = {{"To T", n_o, 52.0332923}, {"Te T", n_e, 36.0094493}};
    for (const auto& row : rows) {
        const double i = std::asin(0.5 * row.n);
        const double least = deviation(i, row.route);
        EXPECT_NEAR(least, 2.0 * i - radians(60.0), 64.0 * eps) << row.route;
        EXPECT_NEAR(degrees(least), row.printed_degrees, printed(7)) << row.route;
        for (const double turned : {-0.01, 0.01}) EXPECT_GT(deviation(i + turned, row.route), least) << row.route;
    }
}

/// Two wedges in contact, the nearer one with its axis in the plane of the picture's x axis, the farther one along z.
std::string wollaston(double wedge, const std::string& near_medium, const std::string& far_medium,
                      const std::string& lamp = "") {
    const double slope = std::tan(wedge);
    const double length = slope + 0.5;
    return camera_in_plane({-1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}) + "render: {residual: 1e-6, wavelengths: 589.3}\n" +
           "media:\n  near: " + near_medium + "\n  far: " + far_medium + "\nobjects:\n" +
           extruded("near wedge", {{-slope, -1.0}, {length, -1.0}, {length, 1.0}, {slope, 1.0}}, "near") +
           extruded("far wedge", {{-length, -1.0}, {-slope, -1.0}, {slope, 1.0}, {-length, 1.0}}, "far") + lamp;
}

/// Snell's law at the seam from n_1 to n_2, then at the exit face.
double exit_angle_by_snell(double wedge, double n_1, double n_2) {
    const double seam = std::asin(n_1 / n_2 * std::sin(wedge));
    return std::asin(n_2 * std::sin(wedge - seam));
}

// A lamp in one of the two beams, 2 degrees wide. Field in the near wedge: e along y, the picture's x axis.
TEST(Wollaston, T29ShowsTwoImagesEachFullyPolarizedAndOrthogonal) {
    const double wedge = radians(15.0);
    const auto image = [&](double angle) {
        const DVec3 out(-std::cos(angle), std::sin(angle), 0.0);
        return look(
            wollaston(wedge, calcite({0.0, 1.0, 0.0}), calcite({0.0, 0.0, 1.0}), lamp_in_plane(out * 30.0, -out, 1.0)));
    };
    const Stokes<double> weak = image(exit_angle_by_snell(wedge, n_e, n_o));
    const Stokes<double> strong = image(exit_angle_by_snell(wedge, n_o, n_e));
    EXPECT_GT(weak.s0, 0.4);
    EXPECT_GT(strong.s0, 0.4);
    EXPECT_NEAR(weak.s1, weak.s0, 4.0 * eps);
    EXPECT_NEAR(strong.s1, -strong.s0, 4.0 * eps);
}

}  // namespace
}  // namespace pol::test
