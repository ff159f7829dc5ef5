// SPDX-License-Identifier: Apache-2.0
// Plane-parallel crystal plates beyond facts T21 to T25 and T35: pictures through them, and lamps in them.
#include "physics/crystal_scene.h"

namespace pol::test {
namespace {

TEST(Plate, T21CutAcrossItsAxisShowsACardOnceAndUnpolarizedLikeGlass) {
    const auto picture = [](const std::string& medium) {
        return render(scene_of(R"(
camera: {type: orthographic, position: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], width: 2}
render: {size: [16, 16], residual: 1e-14}
media: {stuff: )" + medium + R"(}
objects:
  - {name: plate, shape: {box: {size: [4, 4, 1]}}, medium: stuff}
  - {name: card, shape: {rectangle: {size: 2}}, transform: [{translate: [0, 0, -1]}],
     emission: {radiance: {texture: test-card.png}}}
)"));
    };
    const StokesImage crystal = picture(calcite({0.0, 0.0, 1.0}));
    const StokesImage glass = picture("{index: 1.6584}");
    for (std::size_t p = 0; p < crystal.pixel_count(); ++p)
        expect_stokes(crystal.at(0, p), glass.at(0, p), all_passes * glass.brightest[0]);
}

/// Where the branch `mode` reaches the back face at normal incidence, axis at `theta` from the normal, turned by
/// `turn`.
DVec3 back_face_point(double theta, double turn, const char* mode) {
    const Scene scene =
        scene_of(camera_along(downward(0.0)) + "media: {crystal: " + calcite({std::sin(theta), 0.0, std::cos(theta)}) +
                 "}\nobjects:\n" + plate("plate", "crystal", 0.0, degrees(turn)) + lamp_below());
    return branch(explain_look(scene), mode).end.origin;
}

TEST(Plate, T25TurnedAboutTheViewAxisCarriesTheExtraordinaryImageOnACircle) {
    const double radius = (eps_o - eps_e) / (eps_o + eps_e);
    for (const double turn : {0.0, 0.4, 1.9, 3.5, 5.9}) {
        const DVec3 e = back_face_point(radians(45.0), turn, "Te");
        EXPECT_NEAR(e.x, radius * std::cos(turn), 16.0 * eps) << turn;
        EXPECT_NEAR(e.y, radius * std::sin(turn), 16.0 * eps) << turn;
        const DVec3 o = back_face_point(radians(45.0), turn, "To");
        EXPECT_LT(std::hypot(o.x, o.y), 16.0 * eps) << turn;
    }
}

// A lamp as small as a pinhole under one of the two images: at normal incidence a mode is reflected into itself and
// back along its own ray, so all passes end on it. E lies in the principal section for e and across it for o.
TEST(Plate, T25ShowsTwoImagesPolarizedAlongAndAcrossThePrincipalSection) {
    const double radius = (eps_o - eps_e) / (eps_o + eps_e);
    for (const double turn : {0.0, 0.4, 1.9, 3.5, 5.9}) {
        const auto image_at = [&](double distance) {
            return look(camera_along(downward(0.0)) + "render: {residual: 1e-14}\nmedia: {crystal: " +
                        calcite({1.0, 0.0, 1.0}) + "}\nobjects:\n" + plate("plate", "crystal", 0.0, degrees(turn)) +
                        lamp_below(0.02, {distance * std::cos(turn), distance * std::sin(turn), -1.2}));
        };
        // The section makes the angle turn + 90 degrees with the picture's x axis, which is -y.
        const double t_o = plate_transmittance(n_o);
        const double t_e = plate_transmittance(n_45);
        const double c = std::cos(2.0 * turn);
        const double s = std::sin(2.0 * turn);
        expect_stokes(image_at(0.0), {0.5 * t_o, 0.5 * t_o * c, 0.5 * t_o * s, 0.0}, all_passes);
        expect_stokes(image_at(radius), {0.5 * t_e, -0.5 * t_e * c, -0.5 * t_e * s, 0.0}, all_passes);
        expect_stokes(image_at(-radius), {}, 0.0);
    }
}

TEST(Plate, SendsEveryRayOutParallelToTheOneThatCameInOrToItsMirrorImage) {
    const DVec3 in = downward(0.7);
    const Explanation e =
        explain_look(scene_of(camera_along(in) + "render: {depth: 6}\nmedia: {crystal: " + calcite({1.0, 2.0, 3.0}) +
                              "}\nobjects:\n" + box("plate", {400.0, 400.0, 1.0}, {0.0, 0.0, -0.5}, "crystal")));
    int out = 0;
    for (const RayTreeNode& node : e.tree.nodes) {
        if (node.interaction == Interaction::camera || node.start.wave.kind != WaveKind::pair) continue;
        // Six surfaces, each good to a few eps.
        EXPECT_LT(angle_between(node.start.wave.ray, node.start.wave.ray.z < 0.0 ? in : upward(0.7)), 32.0 * eps);
        ++out;
    }
    EXPECT_EQ(out, 1 + 2 + 4 + 8 + 16 + 32);  // the reflection outside, then every second of twice as many each time
}

// Radiance inside a mode is N^2 times basic radiance, N^2 = dS_k/dOmega_ray with dS_k = k^2 dOmega_k/cos(walk-off)
// (PHYSICS.md 2.3). tan(theta_ray) = (eps_o/eps_e) tan(theta_k) gives dOmega_ray/dOmega_k. The lamp swallows what is
// reflected back to it, so there is one pass only.
TEST(Plate, DimsALampInsideByTheSolidAngleThatItsModeGains) {
    for (const double theta : {radians(20.0), radians(45.0), radians(80.0)}) {
        const Stokes<double> s = look(camera_along(downward(0.0)) + "render: {residual: 1e-14}\nmedia: {crystal: " +
                                      calcite({std::sin(theta), 0.0, std::cos(theta)}) + "}\nobjects:\n" +
                                      plate("plate", "crystal") + lamp("lamp", {0.0, 0.0, -0.5}, {0.0, 0.0, 1.0}, 3.0));
        const double ratio = eps_o / eps_e;
        const double theta_ray = std::atan(ratio * std::tan(theta));
        const double theta_slope = ratio / (std::pow(std::cos(theta), 2) + std::pow(ratio * std::sin(theta), 2));
        const double solid_angles = std::sin(theta_ray) / std::sin(theta) * theta_slope;
        const double n = e_index(theta);
        const double n2 = n * n / (solid_angles * std::cos(theta_ray - theta));
        EXPECT_NEAR(s.s0 - s.s1, (1.0 - normal_reflectance(n)) / n2, 2.0 * surface_rounding) << theta;
        EXPECT_NEAR(s.s0 + s.s1, (1.0 - normal_reflectance(n_o)) / eps_o, surface_rounding) << theta;
    }
}

TEST(Plate, OfEqualIndicesIsGlassToTheLastBitOfAWholePicture) {
    const auto picture = [](const std::string& medium) {
        return render(scene_of(R"(
camera: {position: [0.35, -4, 3.2], target: [0, 0, -0.1], fov: 34}
background: 0.1
render: {size: [24, 24], wavelengths: [450, 550], mode: area, spp: 2}
media: {stuff: )" + medium + R"(}
objects:
  - {name: stone, shape: {brilliant: {diameter: 2}}, medium: stuff}
  - {name: lamp, shape: {rectangle: {size: 3}}, transform: [{translate: [0, 0, -0.95]}],
     emission: {radiance: 1, polarization: {dop: 1, azimuth: 20, ellipticity: 0.5, handedness: left}}}
)"));
    };
    const StokesImage crystal =
        picture("{ordinary: 1.5, extraordinary: 1.5, axis: [1, 2, 3], absorption_o: 0.1, absorption_e: 0.1}");
    const StokesImage glass = picture("{index: 1.5, absorption: 0.1}");
    EXPECT_GT(glass.at(0, glass.pixel(12, 12)).s0, 0.1);
    EXPECT_EQ(crystal.stokes, glass.stokes);
    EXPECT_EQ(crystal.residual, glass.residual);
    EXPECT_EQ(crystal.tail, glass.tail);
}

}  // namespace
}  // namespace pol::test
