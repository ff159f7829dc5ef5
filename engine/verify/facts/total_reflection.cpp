// SPDX-License-Identifier: Apache-2.0
// T9 to T12: total reflection keeps energy and P, and turns linear light elliptic.
#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "geometry/shapes.h"
#include "verify/facts/chapters.h"
#include "verify/facts/closed_forms.h"
#include "verify/facts/scene_text.h"
#include "verify/facts/tree_paths.h"

namespace pol::verify {

namespace {

constexpr double n_rhomb = 1.51;

const Tolerance few_surfaces = rounding(200.0, "four surfaces, phases with slopes of order 10");

double delay_degrees(const Stokes<double>& s) {
    return degrees(std::atan2(s.s3, s.s2));
}

/// A lamp inside glass seen from inside it by reflection in the surface z = 0 at the angle `i`.
std::string inner_mirror_scene(double n, double i, const std::string& emission) {
    return camera_along(upward(i), 1.0) + picture() + "media: {stuff: " + text(n) + "}\nobjects:\n" +
           box("block", {40.0, 40.0, 4.0}, {0.0, 0.0, -2.0}, "stuff") +
           lamp("lamp", downward(i) * 1.5, -downward(i), 0.2, emission);
}

/// Light that enters and leaves the middle of two faces of a glass prism along their normals, and is reflected by the
/// third at half the angle between them: base angles `i`, edge along y, base in z = 0.
std::string prism_scene(double i, const std::string& emission) {
    const DVec3 into(-std::sin(i), 0.0, -std::cos(i));
    const DVec3 out(-std::sin(i), 0.0, std::cos(i));
    return camera_seeing_s_as_x(-5.0 * into, {0.0, 0.0, 0.0}) + picture() +
           "media: {glass: 1.5}\nobjects:\n"
           "  - {name: prism, medium: glass, shape: {extrusion: {polygon: [[-1, 0], [1, 0], [0, " +
           text(std::tan(i)) + "]], height: 1}}, transform: [{rotate: {axis: [1, 0, 0], angle: 90}}]}\n" +
           lamp("lamp", 5.0 * out, -out, 0.5, emission);
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
           ", up: [0, 1, 0], width: 1}\n" + picture() + "media: {glass: " + text(n) +
           "}\nobjects:\n  - {name: rhomb, medium: glass, shape: {rhomb: {angle: " + text(degrees(angle)) +
           ", aperture: 1, height: 1}}}\n  - {name: lamp, shape: {rectangle: {size: 0.9}}, " +
           placed(-exit - 5.0 * x, x, {0.0, 0.0, -1.0}) + ", emission: {" + emission + "}}\n";
}

/// The two angles at which one total reflection delays by `delta`: cos i sqrt(sin^2 i - m^2) = tan(delta/2) sin^2 i is
/// quadratic in sin^2 i.
std::pair<double, double> angles_of_delay(double n, double delta) {
    const double m2 = 1.0 / (n * n);
    const double a = 1.0 + std::pow(std::tan(0.5 * delta), 2);
    const double b = 1.0 + m2;
    const double root = std::sqrt(b * b - 4.0 * a * m2);
    return {std::asin(std::sqrt((b + root) / (2.0 * a))), std::asin(std::sqrt((b - root) / (2.0 * a)))};
}

Fact reflecting_prism() {
    Fact fact{"T9", "Total reflection in glass turns light at +45 degrees right-handed elliptic.",
              "Born & Wolf 1.5.4; PHYSICS.md 2.1: Delta = -2 atan(cos i sqrt(sin^2 i - 1/n^2)/sin^2 i)"};
    const double critical = std::asin(1.0 / 1.5);
    const std::string light = polarized("[0, 1, 0]");
    for (const auto& [name, side, out] : {std::tuple{"1e-12 rad inside the critical angle", -1.0, 1.0},
                                          std::tuple{"1e-12 rad beyond the critical angle", 1.0, 0.0}}) {
        const std::size_t view = add_view(fact, name, inner_mirror_scene(1.5, critical + side * 1e-12, light));
        expect(fact, view, "refracted rays", out, exact(),
               [](const Explanation& e) { return find_branch(e, "T") == nullptr ? 0.0 : 1.0; });
    }
    for (const auto& [degree, e, delay] : {std::tuple{45, 1.0 / 3.0, std::atan(0.75)},
                                           std::tuple{60, std::sqrt(11.0) / 9.0, -retardance(1.5, radians(60.0))}}) {
        const std::string name = std::to_string(degree) + " degrees";
        const std::size_t view = add_view(fact, name, prism_scene(radians(degree), light));
        expect(fact, view, "ellipticity", e, few_surfaces, along("TRT", ellipticity));
        expect(fact, view, "delay of s after p", degrees(delay), rounding(200.0 * 60.0, "four surfaces, in degrees"),
               along("TRT", delay_degrees), "deg");
        expect(fact, view, "handedness (+1 right)", 1.0, exact(), along("TRT", handedness));
        expect(fact, view, "radiance", 0.96 * 0.96, few_surfaces, along("TRT", s0));
    }
    return fact;
}

/// From inside a glass cube into its corner at (1, 1, 1): three total reflections in three planes turn the ray around.
std::string corner_scene(const std::string& emission) {
    const DVec3 d = unit(DVec3(1.0, 1.15, 0.9));
    const DVec3 corner(1.0);
    const DVec3 from = corner - 0.9 * d + DVec3(0.05, -0.03, 0.02);
    return "camera: {type: orthographic, position: " + text(from) + ", target: " + text(from + d) + ", width: 0.2}\n" +
           picture() + "media: {glass: 1.5}\nobjects:\n" + box("cube", DVec3(2.0), DVec3(0.0), "glass") +
           "  - {name: lamp, shape: {rectangle: {size: 1}}, " +
           placed(corner - 1.1 * d, d, unit(cross(d, DVec3(0.0, 0.0, 1.0)))) + ", emission: {" + emission + "}}\n";
}

Fact corner_cube() {
    Fact fact{"T10", "Any number of total reflections in any planes keeps unpolarized light unpolarized.",
              "total reflection is unitary"};
    const std::size_t natural = add_view(fact, "unpolarized light", corner_scene("radiance: 1"));
    expect(fact, natural, "radiance", 1.0, few_surfaces, along("RRR", s0));
    expect(fact, natural, "degree of polarization", 0.0, few_surfaces, along("RRR", dop));
    for (const auto& [name, state] :
         {std::pair{"linear light", "[1, 0, 0]"}, {"diagonal light", "[0, 1, 0]"}, {"circular light", "[0, 0, 1]"}}) {
        const std::size_t view = add_view(fact, name, corner_scene(polarized(state)));
        expect(fact, view, "degree of polarization", 1.0, few_surfaces, along("RRR", dop));
    }
    return fact;
}

Fact fresnel_rhomb() {
    Fact fact{"T11", "Two total reflections in a Fresnel rhomb make linear light at +45 degrees circular.",
              "Fresnel; Born & Wolf 1.5.4: tan(Delta/2) is largest, (1 - m^2)/(2 m), at sin^2 i = 2 m^2/(1 + m^2)"};
    const std::string light = polarized("[0, 1, 0]");
    const auto [steep, flat] = angles_of_delay(n_rhomb, radians(45.0));
    for (const auto& [name, angle] : {std::pair{"steeper angle", steep}, std::pair{"flatter angle", flat}}) {
        const std::size_t view = add_view(fact, name, rhomb_scene(n_rhomb, angle, light));
        expect(fact, view, "ellipticity", 1.0, few_surfaces, along("TRRT", ellipticity));
        expect(fact, view, "handedness (+1 right)", 1.0, exact(), along("TRRT", handedness));
    }
    const double angle = radians(54.6);
    const std::size_t view = add_view(fact, "54.6 degrees", rhomb_scene(n_rhomb, angle, light));
    const double delay = -2.0 * retardance(n_rhomb, angle);
    expect(fact, view, "delay", degrees(delay), rounding(200.0 * 60.0, "four surfaces, in degrees"),
           along("TRRT", delay_degrees), "deg");
    expect(fact, view, "ellipticity", std::min(std::tan(0.5 * delay), 1.0 / std::tan(0.5 * delay)), few_surfaces,
           along("TRRT", ellipticity));
    const double m = 1.0 / n_rhomb;
    const double best = std::asin(std::sqrt(2.0 * m * m / (1.0 + m * m)));
    const std::size_t largest = add_view(fact, "largest delay", inner_mirror_scene(n_rhomb, best, light));
    expect(fact, largest, "delay of one reflection", degrees(2.0 * std::atan((1.0 - m * m) / (2.0 * m))),
           rounding(32.0 * 60.0, "one surface, in degrees"), of_pixel(delay_degrees), "deg");
    return fact;
}

Fact rhomb_keeps_s_and_p() {
    Fact fact{"T12", "Linear light along s or p stays linear in the rhomb.", "r_s and r_p act apart, Fresnel"};
    const double power = std::pow(4.0 * n_rhomb / ((n_rhomb + 1.0) * (n_rhomb + 1.0)), 2);
    for (const auto& [name, sign] : {std::pair{"s", 1.0}, std::pair{"p", -1.0}}) {
        const std::size_t view = add_view(fact, std::string("light along ") + name,
                                          rhomb_scene(n_rhomb, radians(54.6), polarized("[" + text(sign) + ", 0, 0]")));
        expect(fact, view, "S1", sign * power, few_surfaces, along("TRRT", s1));
        expect(fact, view, "ellipticity", 0.0, few_surfaces, along("TRRT", ellipticity));
    }
    return fact;
}

}  // namespace

std::vector<Fact> total_reflection_facts() {
    return {reflecting_prism(), corner_cube(), fresnel_rhomb(), rhomb_keeps_s_and_p()};
}

}  // namespace pol::verify
