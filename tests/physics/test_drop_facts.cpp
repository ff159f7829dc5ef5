// SPDX-License-Identifier: Apache-2.0
// The path of a ray through a drop beyond fact T15: every impact parameter, and that the rainbow is an extreme.
#include "physics/fact_scene.h"

namespace pol::test {
namespace {

constexpr double n_water = 1.333;

// Three surfaces of some 20 operations, each rounded by eps/2. Where the ray meets the sphere is known to a few eps,
// its angle of incidence to that over cos i, and an amplitude changes by order 1 per radian.
constexpr double three_surfaces = 128.0 * eps;

/// A drop of radius 1 in unit surroundings, met by the camera's ray at the angle `i`. The camera's x is s.
Explanation drop(double i) {
    const DVec3 met(std::sin(i), 0.0, 0.0);
    return explain_look(scene_of(camera_seeing_s_as_x(met + DVec3(0.0, 0.0, 5.0), met) +
                                 "render: {depth: 3}\nbackground: 1\nmedia: {water: " + text(n_water) +
                                 "}\nobjects:\n  - {name: drop, shape: {sphere: {radius: 1}}, medium: water}\n"));
}

/// Angle between the line of sight and the direction away from the sun, for light reflected once inside.
double rainbow_radius(double i) {
    const Explanation explanation = drop(i);
    const auto branches = path(explanation, "TRT");
    const DVec3 sight = branches.front()->start.wave.ray;
    const DVec3 shadow = -branches.back()->start.wave.ray;
    return std::atan2(std::sqrt(length2(cross(sight, shadow))), dot(sight, shadow));
}

// The radius 4 t - 2 i of light reflected once is stationary where cos^2 i = (n^2 - 1)/3 (Descartes).
const double descartes = std::acos(std::sqrt((n_water * n_water - 1.0) / 3.0));

TEST(WaterDrop, TurnsARayByFourTimesTheInnerMinusTwiceTheOuterAngle) {
    for (const double degree : {5.0, 30.0, 59.0, 80.0, 89.0}) {
        SCOPED_TRACE(degree);
        const double i = radians(degree);
        const double t = std::asin(std::sin(i) / n_water);
        EXPECT_NEAR(rainbow_radius(i), 4.0 * t - 2.0 * i, three_surfaces / std::cos(i));
    }
}

TEST(WaterDrop, T15SendsItsRainbowAtTheLargestAngle) {
    EXPECT_NEAR(degrees(descartes), 59.410473, printed(6));
    const double radius = rainbow_radius(descartes);
    EXPECT_NEAR(degrees(radius), 42.078107, printed(6));
    for (const double step : {-0.3, -0.03, -0.003, 0.003, 0.03, 0.3}) {
        // Second order: d^2(4 t - 2 i)/di^2 = 4 d^2t/di^2 = -4 (n^2 - 1) sin i/(n^2 - sin^2 i)^(3/2) = -2.5 here.
        EXPECT_LT(rainbow_radius(descartes + step), radius - 0.5 * step * step) << step;
    }
}

}  // namespace
}  // namespace pol::test
