// SPDX-License-Identifier: Apache-2.0
// physics.md T9 to T12 as paths through whole prisms: total reflection keeps energy and P, and turns linear light
// elliptic.
#include "geometry/shapes.h"
#include "physics/fact_scene.h"

namespace pol::test {
namespace {

// Four surfaces of some 20 operations, each rounded by eps/2, and phases with slopes of order 10 in the angle.
constexpr double few_surfaces = 200.0 * eps;

/// Linear in (s, p) at +45 degrees, delayed by delta = delta_p - delta_s in all, dimmed to `power`.
Stokes<double> delayed(double delta, double power) {
    return {power, 0.0, power * std::cos(delta), -power * std::sin(delta)};
}

/// delta_p - delta_s of one total reflection, physics.md 2.1.
double retardance(double n, double angle) {
    const double sin2 = std::pow(std::sin(angle), 2);
    return -2.0 * std::atan(std::cos(angle) * std::sqrt(sin2 - 1.0 / (n * n)) / sin2);
}

/// Light that enters and leaves the middle of two faces of a glass prism along their normals, and is reflected by the
/// third at half the angle between them: base angles `i`, edge along y, base in z = 0.
std::string prism_scene(double i, const std::string& emission) {
    // Points of the base corner triangle (0, 0) +- (1, 0), apex (0, tan i), in x and z.
    const DVec3 into(-std::sin(i), 0.0, -std::cos(i));  // direction that meets the base at the angle i
    const DVec3 out(-std::sin(i), 0.0, std::cos(i));
    return camera_seeing_s_as_x(-5.0 * into, {0.0, 0.0, 0.0}) +
           "media: {glass: 1.5}\nobjects:\n"
           "  - {name: prism, medium: glass, shape: {extrusion: {polygon: [[-1, 0], [1, 0], [0, " +
           text(std::tan(i)) + "]], height: 1}}, transform: [{rotate: {axis: [1, 0, 0], angle: 90}}]}\n" +
           lamp("lamp", 5.0 * out, -out, 0.5, emission);
}

TEST(Prism, T9TurnsDiagonalLightRightHandedElliptic) {
    const double through = 0.96 * 0.96;  // the two faces met along their normals
    for (const auto& [degree, e] : {std::pair{45.0, 1.0 / 3.0}, std::pair{60.0, std::sqrt(11.0) / 9.0}}) {
        SCOPED_TRACE(degree);
        const Stokes<double> s = light_along(prism_scene(radians(degree), polarized("[0, 1, 0]")), "TRT");
        expect_stokes(s, delayed(retardance(1.5, radians(degree)), through), few_surfaces);
        EXPECT_NEAR(measure(s).ellipticity, e, few_surfaces);
        EXPECT_EQ(measure(s).handedness, 1);
    }
    EXPECT_NEAR(std::abs(retardance(1.5, radians(45.0))), std::atan(0.75), few_surfaces);
}

TEST(Prism, T12KeepsLinearLightAlongSOrPLinear) {
    for (const std::string state : {"[1, 0, 0]", "[-1, 0, 0]"}) {
        const Stokes<double> s = light_along(prism_scene(radians(60.0), polarized(state)), "TRT");
        const double s1 = state == "[1, 0, 0]" ? 1.0 : -1.0;
        expect_stokes(s, {0.96 * 0.96, s1 * 0.96 * 0.96, 0.0, 0.0}, few_surfaces);
    }
}

/// A lamp in front of the entrance face of a Fresnel rhomb, a camera in front of its exit face; light runs along +x
/// through the middle of both, the planes of incidence are z = const. The camera's x is z, which is s.
std::string rhomb_scene(double n, double angle, const std::string& emission) {
    const RhombShape shape{angle, 1.0, 1.0};
    const double sin_beta = std::cos(angle);
    const double cos_beta = std::sin(angle);
    // As RhombShape is made: the middle of the exit face is half the length of the long faces along their direction.
    const double length = 2.0 * shape.aperture * cos_beta * cos_beta / sin_beta;
    const DVec3 exit(0.5 * length * cos_beta, 0.5 * length * sin_beta, 0.0);
    const DVec3 x(1.0, 0.0, 0.0);
    return "camera: {type: orthographic, position: " + text(exit + 5.0 * x) + ", target: " + text(exit) +
           ", up: [0, 1, 0], width: 0.01}\nmedia: {glass: " + text(n) +
           "}\nobjects:\n  - {name: rhomb, medium: glass, shape: {rhomb: {angle: " + text(degrees(angle)) +
           ", aperture: 1, height: 1}}}\n  - {name: lamp, shape: {rectangle: {size: 0.9}}, " +
           placed(-exit - 5.0 * x, x, {0.0, 0.0, -1.0}) + ", emission: {" + emission + "}}\n";
}

double rhomb_power(double n) {
    return std::pow(4.0 * n / ((n + 1.0) * (n + 1.0)), 2);
}

TEST(FresnelRhomb, T11MakesCircularLightAtItsTwoAngles) {
    for (const double degree : {54.623105, 48.624359}) {
        SCOPED_TRACE(degree);
        const double angle = radians(degree);
        const Stokes<double> s = light_along(rhomb_scene(1.51, angle, polarized("[0, 1, 0]")), "TRRT");
        expect_stokes(s, delayed(2.0 * retardance(1.51, angle), rhomb_power(1.51)), few_surfaces);
        // The delay of two reflections changes by less than 2 degrees per degree here, the angle is printed to 5e-7
        // degrees, and e = tan(delay/2) has slope 1.
        EXPECT_NEAR(measure(s).ellipticity, 1.0, 2.0 * radians(printed(6)));
        EXPECT_EQ(measure(s).handedness, 1);
    }
}

TEST(FresnelRhomb, T11IsAlmostCircularAtFiftyFourPointSixDegrees) {
    const Stokes<double> s = light_along(rhomb_scene(1.51, radians(54.6), polarized("[0, 1, 0]")), "TRRT");
    EXPECT_NEAR(degrees(std::atan2(s.s3, s.s2)), 90.024178, printed(6));
    EXPECT_NEAR(measure(s).ellipticity, 0.9995781, printed(7));
}

TEST(FresnelRhomb, T12KeepsLinearLightAlongSOrPLinear) {
    for (const double s1 : {1.0, -1.0}) {
        const Stokes<double> s =
            light_along(rhomb_scene(1.51, radians(54.6), polarized("[" + text(s1) + ", 0, 0]")), "TRRT");
        expect_stokes(s, {rhomb_power(1.51), s1 * rhomb_power(1.51), 0.0, 0.0}, few_surfaces);
        EXPECT_NEAR(measure(s).ellipticity, 0.0, few_surfaces);
    }
}

/// From inside a glass cube into its corner at (1, 1, 1): three total reflections in three planes turn the ray around.
std::string corner_scene(const std::string& emission) {
    const DVec3 d = unit(DVec3(1.0, 1.15, 0.9));
    const DVec3 corner(1.0);
    const DVec3 from = corner - 0.9 * d + DVec3(0.05, -0.03, 0.02);
    return "camera: {type: orthographic, position: " + text(from) + ", target: " + text(from + d) +
           ", width: 0.01}\nmedia: {glass: 1.5}\nobjects:\n" + box("cube", DVec3(2.0), DVec3(0.0), "glass") +
           "  - {name: lamp, shape: {rectangle: {size: 1}}, " +
           placed(corner - 1.1 * d, d, unit(cross(d, DVec3(0.0, 0.0, 1.0)))) + ", emission: {" + emission + "}}\n";
}

// Total reflection is unitary: it keeps S0 and P, whatever the planes of incidence.
TEST(CornerCube, T10KeepsUnpolarizedLightUnpolarizedAndPolarizedLightPolarized) {
    const Explanation e = explain_look(scene_of(corner_scene("radiance: 1")));
    EXPECT_EQ(e.tree.leaves.size(), 1U);
    const Stokes<double> s = light_along(e, "RRR");
    expect_stokes(s, {1.0, 0.0, 0.0, 0.0}, few_surfaces);
    EXPECT_EQ(measure(s, few_surfaces).ellipticity, 0.0);
    double largest_s3 = 0.0;
    for (const std::string state : {"[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]"}) {
        const Stokes<double> polarized_light = light_along(corner_scene(polarized(state)), "RRR");
        EXPECT_NEAR(polarized_light.s0, 1.0, few_surfaces);
        EXPECT_NEAR(polarized_part(polarized_light), 1.0, few_surfaces);
        if (state != "[0, 0, 1]") largest_s3 = std::max(largest_s3, std::abs(polarized_light.s3));
    }
    EXPECT_GT(largest_s3, 0.1);  // the reflections do something: linear light becomes elliptic
}

}  // namespace
}  // namespace pol::test
