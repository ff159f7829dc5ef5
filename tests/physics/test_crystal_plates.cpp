// SPDX-License-Identifier: Apache-2.0
// physics.md T21 to T25 and T35: plane-parallel crystal plates, and lamps in them.
#include "physics/crystal_scene.h"

namespace pol::test {
namespace {

TEST(Plate, T21CutAcrossItsAxisIsGlassOfTheOrdinaryIndexAtNormalIncidence) {
    const std::string yaml = plate_scene(calcite({0.0, 0.0, 1.0}));
    expect_stokes(look(yaml), {plate_transmittance(n_o), 0.0, 0.0, 0.0}, all_passes);
    for (const RayTreeNode& node : explain_look(scene_of(yaml)).tree.nodes)
        EXPECT_EQ(node.start.wave.kind, WaveKind::pair);
}

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

TEST(Plate, T22WithItsAxisInTheFacePolarizesReflectedLight) {
    const Stokes<double> s =
        look(camera_along(downward(0.0)) + "media: {crystal: " + calcite({1.0, 0.0, 0.0}) + "}\nobjects:\n" +
             deep_block("crystal") + lamp("lamp", {0.0, 0.0, 10.0}, {0.0, 0.0, -1.0}, 1.0));
    const double r_o = normal_reflectance(n_o);
    const double r_e = normal_reflectance(n_e);
    EXPECT_NEAR(r_o, 0.0613393, printed(7));
    EXPECT_NEAR(r_e, 0.0382688, printed(7));  // physics.md prints ...9; its P has the right one
    expect_stokes(s, {0.5 * (r_o + r_e), 0.5 * (r_o - r_e), 0.0, 0.0}, surface_rounding);
    EXPECT_NEAR(measure(s).dop, 0.2316126, printed(7));
}

TEST(Plate, T22WithItsAxisInTheFacePolarizesTransmittedLight) {
    const Stokes<double> s = look(plate_scene(calcite({1.0, 0.0, 0.0})));
    const double t_o = plate_transmittance(n_o);
    const double t_e = plate_transmittance(n_e);
    EXPECT_NEAR(t_o, 0.8844115, printed(7));
    EXPECT_NEAR(t_e, 0.9262834, printed(7));
    expect_stokes(s, {0.5 * (t_o + t_e), 0.5 * (t_o - t_e), 0.0, 0.0}, all_passes);
    EXPECT_NEAR(measure(s).dop, 0.0231248, printed(7));
}

/// Where the branch `mode` reaches the back face at normal incidence, axis at `theta` from the normal, turned by
/// `turn`.
DVec3 back_face_point(double theta, double turn, const char* mode) {
    const Scene scene =
        scene_of(camera_along(downward(0.0)) + "media: {crystal: " + calcite({std::sin(theta), 0.0, std::cos(theta)}) +
                 "}\nobjects:\n" + plate("plate", "crystal", 0.0, degrees(turn)) + lamp_below());
    return branch(explain_look(scene), mode).end.origin;
}

// Closed form: the ray is parallel to eps k. A displacement is a sum of half a dozen rounded numbers of order 1; the
// angle loses another eps to the camera's direction.
TEST(Plate, T23ShiftsTheExtraordinaryRayAwayFromTheAxisAtNormalIncidence) {
    const auto walk_off = [](double theta) {
        const DVec3 p = back_face_point(theta, 0.0, "Te");
        EXPECT_NEAR(p.y, 0.0, 16.0 * eps);
        EXPECT_NEAR(p.z, -1.0, 4.0 * eps);
        EXPECT_NEAR(p.x,
                    (eps_o - eps_e) * std::sin(theta) * std::cos(theta) /
                        (eps_o * std::pow(std::sin(theta), 2) + eps_e * std::pow(std::cos(theta), 2)),
                    16.0 * eps);
        return p.x;
    };
    EXPECT_NEAR(walk_off(radians(45.0)), (eps_o - eps_e) / (eps_o + eps_e), 16.0 * eps);
    EXPECT_NEAR(walk_off(radians(45.0)), 0.1090607, printed(7));
    EXPECT_NEAR(degrees(std::atan(walk_off(radians(45.0)))), 6.2241176, printed(7));
    EXPECT_NEAR(walk_off(radians(44.61)), 0.1092127, printed(7));  // the cleavage rhomb
    EXPECT_NEAR(degrees(std::atan(walk_off(radians(44.61)))), 6.2327262, printed(7));
    const double steepest = std::atan(n_e / n_o);
    EXPECT_NEAR(degrees(steepest), 41.8694, printed(4));
    EXPECT_NEAR(walk_off(steepest), (eps_o - eps_e) / (2.0 * n_o * n_e), 16.0 * eps);
    EXPECT_NEAR(degrees(std::atan(walk_off(steepest))), 6.2611709, printed(7));
    EXPECT_GT(walk_off(steepest), walk_off(steepest - 0.001));
    EXPECT_GT(walk_off(steepest), walk_off(steepest + 0.001));
    const DVec3 o = back_face_point(radians(45.0), 0.0, "To");
    EXPECT_LT(std::hypot(o.x, o.y), 16.0 * eps);
}

TEST(Plate, T24SharesUnpolarizedLightAlmostEquallyBetweenOrdinaryAndExtraordinary) {
    const Explanation e = explain_look(scene_of(plate_scene(calcite({1.0, 0.0, 1.0}))));
    EXPECT_NEAR(n_45, 1.5653568, printed(7));
    EXPECT_NEAR(share(e, "To"), 0.5 * (1.0 - normal_reflectance(n_o)), surface_rounding);
    EXPECT_NEAR(share(e, "Te"), 0.5 * (1.0 - normal_reflectance(n_45)), surface_rounding);
    EXPECT_NEAR(share(e, "To"), 0.4693303, printed(7));
    EXPECT_NEAR(share(e, "Te"), 0.4757160, printed(7));
    EXPECT_NEAR(share(e, "R") + share(e, "To") + share(e, "Te"), 1.0, surface_rounding);
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

TEST(Plate, T25BehindAnAnalyzerLosesTheImageThatTheAnalyzerCrosses) {
    for (const double turn : {0.0, 0.4, 1.9}) {
        const auto behind_analyzer = [&](double axis) {
            return explain_look(scene_of(camera_along(downward(0.0)) + "render: {residual: 1e-14}\nmedia: {crystal: " +
                                         calcite({1.0, 0.0, 1.0}) + "}\nobjects:\n" +
                                         plate("plate", "crystal", 0.0, degrees(turn)) + lamp_below() +
                                         "  - {name: analyzer, shape: {disk: {radius: 1}}, transform: [{translate: [0, "
                                         "0, 2]}], sheet: {polarizer: {axis: " +
                                         text(DVec3(std::cos(axis), std::sin(axis), 0.0)) + "}}}\n"));
        };
        // The crossed amplitude is a cosine of 90 degrees rounded a few times; shares are its square.
        const Explanation along = behind_analyzer(turn);
        EXPECT_LT(share(along, "S To"), 100.0 * eps * eps);
        EXPECT_NEAR(along.sample_light.s0, 0.5 * plate_transmittance(n_45), all_passes);
        const Explanation across = behind_analyzer(turn + 0.5 * pi);
        EXPECT_LT(share(across, "S Te"), 100.0 * eps * eps);
        EXPECT_NEAR(across.sample_light.s0, 0.5 * plate_transmittance(n_o), all_passes);
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
// (physics.md 2.3). tan(theta_ray) = (eps_o/eps_e) tan(theta_k) gives dOmega_ray/dOmega_k. The lamp swallows what is
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

// The wave normal inside is perpendicular to the axis, which is turned by 45 degrees from s: the plate splits light
// into equal parts that do not interfere any more, however small its birefringence. Straight path alone: two surfaces.
TEST(Plate, T35OfVanishingBirefringencePolarizesAsOneFaceDoesButGlassAsTwo) {
    const double brewster = std::atan(1.5);
    const DVec3 inside = downward(std::asin(std::sin(brewster) / 1.5));
    const DVec3 s(0.0, 1.0, 0.0);
    const auto straight = [&](const std::string& extraordinary) {
        return look(plate_scene(
            "{ordinary: 1.5, extraordinary: " + extraordinary + ", axis: " + text(unit(s + cross(inside, s))) + "}",
            "{depth: 2}", brewster));
    };
    // At Brewster's angle T_p = 1 and T_s = alpha^2 with alpha = 2n/(1 + n^2) at each face.
    const double t_s = std::pow(2.0 * 1.5 / (1.0 + 1.5 * 1.5), 2);
    const double one_face = (1.0 - t_s) / (1.0 + t_s);
    const double two_faces = (1.0 - t_s * t_s) / (1.0 + t_s * t_s);
    EXPECT_NEAR(one_face, 0.0798722045, printed(10));
    EXPECT_NEAR(two_faces, 0.1587317687, printed(10));
    // The birefringence itself, 1e-12, moves P by as much.
    const Stokes<double> split = straight("1.500000000001");
    EXPECT_NEAR(measure(split).dop, one_face, 4e-12);
    const Stokes<double> glass = straight("1.5");
    EXPECT_NEAR(measure(glass).dop, two_faces, 8.0 * surface_rounding);
    EXPECT_LT(glass.s1, 0.0);  // p passes
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
