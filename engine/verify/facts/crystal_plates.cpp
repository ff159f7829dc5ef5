// SPDX-License-Identifier: Apache-2.0
// T21 to T25, T35, T44, T45 and T51: plane-parallel crystal plates, alone and between polarizers.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "core/hypot.h"
#include "core/units.h"
#include "verify/facts/chapters.h"
#include "verify/facts/closed_forms.h"
#include "verify/facts/scene_text.h"
#include "verify/facts/tree_paths.h"

namespace pol::verify {

namespace {

const Tolerance two_surfaces = rounding(120.0, "two surfaces of a crystal");
const Tolerance displacement = rounding(16.0, "a point on a face");
/// All passes of a plate: residual 1e-14 times radiance 1, and the rounding of a dozen passes that still matter.
const Tolerance all_passes = residual_bound(1e-14, 1.0, rounding(720.0, "a dozen surfaces of a crystal"));
const Tolerance dop_of_all_passes = residual_bound(1e-14, 3.0, rounding(1440.0, "a dozen surfaces of a crystal / 0.5"));

/// A plate before a lamp that fills all that lies behind it. The camera's x axis is -y, its y axis is x.
std::string plate_scene(const std::string& medium, const std::string& settings = "residual: 1e-14", double i = 0.0,
                        double turn = 0.0) {
    return camera_along(downward(i)) + picture(settings) + "media: {crystal: " + medium + "}\nobjects:\n" +
           plate("plate", "crystal", 0.0, turn) + lamp("lamp", {0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}, 20.0);
}

/// An ideal polarizer above the plates, its axis at the angle `axis` (radians) from x in the plane of the plate.
std::string analyzer(double height, double axis) {
    return fmt::format(
        "  - {{name: polarizer at {0}, shape: {{disk: {{radius: 1.5}}}}, transform: [{{translate: [0, 0, {0}]}}], "
        "sheet: {{polarizer: {{axis: {1}}}}}}}\n",
        text(height), text(DVec3(std::cos(axis), std::sin(axis), 0.0)));
}

DVec3 axis_at(double theta) {
    return {std::sin(theta), 0.0, std::cos(theta)};
}

/// Where the branch reaches the back face of the plate.
Measurement back_face(const char* mode, double (*component)(const DVec3&)) {
    return [mode, component](const Explanation& e) {
        const RayTreeNode* found = find_branch(e, mode);
        return found == nullptr ? std::numeric_limits<double>::quiet_NaN() : component(found->end.origin);
    };
}
double x_of(const DVec3& p) {
    return p.x;
}
double y_of(const DVec3& p) {
    return p.y;
}
double off_axis(const DVec3& p) {
    return pol::hypot(p.x, p.y);
}
double angle_off_axis(const DVec3& p) {
    return degrees(std::atan(pol::hypot(p.x, p.y)));
}

Fact cut_across_the_axis() {
    Fact fact{"T21", "A calcite plate cut across its axis is, head on, glass of the ordinary index: no double image.",
              "PHYSICS.md 4, case 1"};
    const std::size_t view = add_view(fact, "", plate_scene(calcite({0.0, 0.0, 1.0})));
    expect(fact, view, "transmittance", plate_transmittance(n_o), all_passes, of_pixel(s0));
    expect(fact, view, "degree of polarization", 0.0, all_passes, of_pixel(dop));
    expect(fact, view, "rays split into o and e", 0.0, exact(), [](const Explanation& e) {
        double split = 0.0;
        for (const RayTreeNode& node : e.tree.nodes) split += node.start.wave.kind == WaveKind::pair ? 0.0 : 1.0;
        return split;
    });
    return fact;
}

Fact axis_in_the_face() {
    Fact fact{"T22", "Calcite with its axis in the face polarizes even what it reflects and transmits head on.",
              "Fresnel at normal incidence with n_o and n_e apart"};
    const double r_o = normal_reflectance(n_o);
    const double r_e = normal_reflectance(n_e);
    const std::size_t mirror =
        add_view(fact, "reflected",
                 camera_along(downward(0.0)) + picture() + "media: {crystal: " + calcite({1.0, 0.0, 0.0}) +
                     "}\nobjects:\n" + deep_block("crystal") + lamp("lamp", {0.0, 0.0, 10.0}, {0.0, 0.0, -1.0}, 1.0));
    expect(fact, mirror, "reflectance of o", r_o, one_crystal_surface(), of_pixel(s_share));
    expect(fact, mirror, "reflectance of e", r_e, one_crystal_surface(), of_pixel(p_share));
    expect(fact, mirror, "degree of polarization", dop_of(r_o, r_e), rounding(60.0 / 0.05, "one surface / 0.05"),
           of_pixel(dop));
    const double t_o = plate_transmittance(n_o);
    const double t_e = plate_transmittance(n_e);
    const std::size_t through = add_view(fact, "transmitted", plate_scene(calcite({1.0, 0.0, 0.0})));
    expect(fact, through, "transmittance of o", t_o, all_passes, of_pixel(s_share));
    expect(fact, through, "transmittance of e", t_e, all_passes, of_pixel(p_share));
    expect(fact, through, "degree of polarization", dop_of(t_o, t_e), dop_of_all_passes, of_pixel(dop));
    return fact;
}

Fact walk_off() {
    Fact fact{"T23", "In calcite with an oblique axis the e ray walks off sideways, by up to 6.26 degrees, head on.",
              "PHYSICS.md 2.5: the ray is parallel to eps k"};
    for (const auto& [name, theta] :
         {std::pair{"axis at 45 degrees", radians(45.0)}, std::pair{"cleavage rhomb", radians(44.61)},
          std::pair{"steepest", std::atan(n_e / n_o)}}) {
        const double shift = (eps_o - eps_e) * std::sin(theta) * std::cos(theta) /
                             (eps_o * std::pow(std::sin(theta), 2) + eps_e * std::pow(std::cos(theta), 2));
        const std::size_t view = add_view(fact, name, plate_scene(calcite(axis_at(theta)), "residual: 0.01"));
        expect(fact, view, "e displaced, thicknesses", shift, displacement, back_face("Te", x_of));
        expect(fact, view, "angle", degrees(std::atan(shift)), rounding(16.0 * 60.0, "a point on a face, in degrees"),
               back_face("Te", angle_off_axis), "deg");
        expect(fact, view, "o displaced, thicknesses", 0.0, displacement, back_face("To", off_axis));
    }
    return fact;
}

Fact shares() {
    Fact fact{"T24", "The two rays of calcite are almost, but not quite, equally bright.",
              "(1 - R)/2 of n_o and of n_e(45 degrees)"};
    const std::size_t view = add_view(fact, "", plate_scene(calcite({1.0, 0.0, 1.0}), "residual: 0.01"));
    const double n_45 = e_index(radians(45.0));
    for (const auto& [name, branch, n] : {std::tuple{"share of o", "To", n_o}, std::tuple{"share of e", "Te", n_45}})
        expect(fact, view, name, 0.5 * (1.0 - normal_reflectance(n)), one_crystal_surface(),
               [branch = branch](const Explanation& e) { return share(e, branch); });
    expect(fact, view, "reflected, o and e together", 1.0, one_crystal_surface(),
           [](const Explanation& e) { return share(e, "R") + share(e, "To") + share(e, "Te"); });
    return fact;
}

Fact turned_plate() {
    Fact fact{"T25",
              "Turn a calcite plate: the o image stays, the e image goes round it, and an analyzer kills either.",
              "e lies in the principal section; radius (eps_o - eps_e)/(eps_o + eps_e)"};
    const double radius = (eps_o - eps_e) / (eps_o + eps_e);
    const double turn = radians(25.0);
    const std::string medium = calcite({1.0, 0.0, 1.0});
    const std::size_t view = add_view(fact, "turned by 25 degrees", plate_scene(medium, "residual: 0.01", 0.0, 25.0));
    expect(fact, view, "e image, x", radius * std::cos(turn), displacement, back_face("Te", x_of));
    expect(fact, view, "e image, y", radius * std::sin(turn), displacement, back_face("Te", y_of));
    expect(fact, view, "o image, distance", 0.0, displacement, back_face("To", off_axis));
    // The crossed amplitude is a cosine of 90 degrees rounded a few times; shares are its square.
    const Tolerance dark{100.0 * epsilon * epsilon, "amplitude of 10 epsilon, squared"};
    const double n_45 = e_index(radians(45.0));
    for (const auto& [name, angle, killed, index] :
         {std::tuple{"analyzer along the section", turn, "S To", n_45},
          std::tuple{"analyzer across the section", turn + 0.5 * pi, "S Te", n_o}}) {
        const std::size_t behind =
            add_view(fact, name, plate_scene(medium, "residual: 1e-14", 0.0, 25.0) + analyzer(2.0, angle));
        expect(fact, behind, "share killed", 0.0, dark,
               [killed = killed](const Explanation& e) { return share(e, killed); });
        expect(fact, behind, "share passed", 0.5 * plate_transmittance(index), all_passes, of_pixel(s0));
    }
    return fact;
}

Fact vanishing_birefringence() {
    Fact fact{"T35",
              "A plate that splits o from e, however little, polarizes as one face does at Brewster; glass as two.",
              "o and e add incoherently, PHYSICS.md 6; T_p = 1, T_s = (2n/(1 + n^2))^2 per face"};
    const double brewster = std::atan(1.5);
    const DVec3 inside = downward(std::asin(std::sin(brewster) / 1.5));
    const DVec3 s(0.0, 1.0, 0.0);
    const auto scene = [&](const char* extraordinary) {
        return plate_scene(fmt::format("{{ordinary: 1.5, extraordinary: {}, axis: {}}}", extraordinary,
                                       text(unit(s + cross(inside, s)))),
                           "depth: 2", brewster);
    };
    const double t_s = std::pow(2.0 * 1.5 / (1.0 + 1.5 * 1.5), 2);
    const std::size_t split = add_view(fact, "n_e - n_o = 1e-12", scene("1.500000000001"));
    expect(fact, split, "degree of polarization", dop_of(1.0, t_s), {4e-12, "the birefringence itself, 4 x 1e-12"},
           of_pixel(dop));
    const std::size_t glass = add_view(fact, "n_e = n_o", scene("1.5"));
    expect(fact, glass, "degree of polarization", dop_of(1.0, t_s * t_s), rounding(480.0, "two surfaces / 0.25"),
           of_pixel(dop));
    return fact;
}

/// A plate with its axis in the face at 30 degrees from x, a polarizer along x below it and an analyzer above.
std::string between_polarizers(double analyzer_axis) {
    return plate_scene(calcite({1.0, 0.0, 0.0}), "residual: 1e-14", 0.0, 30.0) + analyzer(-2.0, 0.0) +
           analyzer(2.0, analyzer_axis);
}

Fact incoherent_plate_between_polarizers() {
    Fact fact{"T44", "A thick plate at phi between crossed polarizers passes sin^2(2 phi)/4, times its transmittance.",
              "powers of o and e add; T = 2n/(n^2 + 1) of each"};
    const double phi = radians(30.0);
    const double t_o = plate_transmittance(n_o);
    const double t_e = plate_transmittance(n_e);
    const double c2 = std::pow(std::cos(phi), 2);
    const double s2 = std::pow(std::sin(phi), 2);
    const std::size_t crossed = add_view(fact, "crossed", between_polarizers(0.5 * pi));
    expect(fact, crossed, "radiance", 0.5 * s2 * c2 * (t_o + t_e), all_passes, of_pixel(s0));
    const std::size_t parallel = add_view(fact, "parallel", between_polarizers(0.0));
    expect(fact, parallel, "radiance", 0.5 * (s2 * s2 * t_o + c2 * c2 * t_e), all_passes, of_pixel(s0));
    return fact;
}

Fact linear_light_through_a_thick_plate() {
    Fact fact{"T45",
              "A thick plate at 45 degrees depolarizes linear light: o and e are equal, orthogonal and incoherent.",
              "P = |T_e cos^2 phi - T_o sin^2 phi|/(T_e cos^2 phi + T_o sin^2 phi), |cos 2 phi| without reflections"};
    for (const double degree : {45.0, 30.0}) {
        const double e = plate_transmittance(n_e) * std::pow(std::cos(radians(degree)), 2);
        const double o = plate_transmittance(n_o) * std::pow(std::sin(radians(degree)), 2);
        const std::string name = fmt::format("plate at {} degrees", degree);
        const std::size_t view = add_view(
            fact, name, plate_scene(calcite({1.0, 0.0, 0.0}), "residual: 1e-14", 0.0, degree) + analyzer(-2.0, 0.0));
        expect(fact, view, "degree of polarization", dop_of(e, o), dop_of_all_passes, of_pixel(dop));
        expect(fact, view, "S3", 0.0, all_passes, of_pixel(s3));
        expect(fact, view, "radiance", 0.5 * (e + o), all_passes, of_pixel(s0));
    }
    return fact;
}

Fact absorbing_plate() {
    Fact fact{"T51", "Tourmaline polarizes by swallowing o; each mode is absorbed over its own path.",
              "Beer-Lambert exp(-alpha l) on power, PHYSICS.md 2.9"};
    const std::size_t tourmaline = add_view(
        fact, "tourmaline",
        plate_scene("{ordinary: 1.640, extraordinary: 1.620, axis: [1, 0, 0], absorption_o: 200, absorption_e: 0}"));
    expect(fact, tourmaline, "transmittance of e", plate_transmittance(1.620), all_passes, of_pixel(p_share));
    expect(fact, tourmaline, "degree of polarization", 1.0, rounding(4.0, "a ratio of Stokes components"),
           of_pixel(dop));
    expect(fact, tourmaline, "light absorbed", 0.5 * (1.0 - normal_reflectance(1.640)), all_passes,
           [](const Explanation& e) { return e.result.absorbed; });
    // The axis is across the plane of incidence: s is e with the plain index n_e, p is o.
    const double i = radians(50.0);
    const std::size_t oblique = add_view(fact, "weak absorption at 50 degrees",
                                         plate_scene("{ordinary: " + text(n_o) + ", extraordinary: " + text(n_e) +
                                                         ", axis: [0, 1, 0], absorption_o: 0.7, absorption_e: 0.2}",
                                                     "depth: 2", i));
    const auto path_length = [i](double n) { return 1.0 / std::cos(std::asin(std::sin(i) / n)); };
    expect(fact, oblique, "transmittance of s (e)",
           std::pow(1.0 - ClosedFresnel(n_e, i).R_s(), 2) * std::exp(-0.2 * path_length(n_e)), two_surfaces,
           of_pixel(s_share));
    expect(fact, oblique, "transmittance of p (o)",
           std::pow(1.0 - ClosedFresnel(n_o, i).R_p(), 2) * std::exp(-0.7 * path_length(n_o)), two_surfaces,
           of_pixel(p_share));
    return fact;
}

}  // namespace

std::vector<Fact> crystal_plate_facts() {
    return {cut_across_the_axis(),
            axis_in_the_face(),
            walk_off(),
            shares(),
            turned_plate(),
            vanishing_birefringence(),
            incoherent_plate_between_polarizers(),
            linear_light_through_a_thick_plate(),
            absorbing_plate()};
}

}  // namespace pol::verify
