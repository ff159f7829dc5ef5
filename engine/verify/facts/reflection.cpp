// SPDX-License-Identifier: Apache-2.0
// T1 to T3 and T16 to T20: one surface between air and glass, diamond or metal.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/hypot.h"
#include "core/units.h"
#include "verify/facts/chapters.h"
#include "verify/facts/closed_forms.h"
#include "verify/facts/scene_text.h"
#include "verify/facts/tree_paths.h"

namespace pol::verify {

namespace {

constexpr double n_glass = 1.5;
const double glass_brewster = std::atan(n_glass);
constexpr const char* diagonal = "[0, 1, 0]";

const Tolerance one_mirror = rounding(32.0, "one surface");
const Tolerance ratio = rounding(4.0, "a ratio of Stokes components");

/// A lamp seen by reflection in a deep block of the medium, at the angle of incidence `i`. The lamp is farther than the
/// camera, which it would otherwise hide at normal incidence, and small enough to stay above the block.
std::string mirror_scene(const std::string& medium, double i, const std::string& emission = "radiance: 1") {
    return camera_along(downward(i)) + picture() + "media: {stuff: " + medium + "}\nobjects:\n" + deep_block("stuff") +
           lamp("lamp", upward(i) * 10.0, -upward(i), std::cos(i), emission);
}

/// Light of a lamp inside the medium, seen from outside through one surface at the angle `i` outside.
std::string refraction_scene(double n, double i, const std::string& emission = "radiance: 1") {
    const double t = std::asin(std::sin(i) / n);
    return camera_along(downward(i)) + picture() + "media: {stuff: " + text(n) + "}\nobjects:\n" +
           box("block", {40.0, 40.0, 4.0}, {0.0, 0.0, -2.0}, "stuff") +
           lamp("lamp", downward(t), -downward(t), 0.5, emission);
}

/// A lamp outside, seen from inside the glass by refraction; `i` is the angle outside.
std::string from_inside_scene(double n, double i) {
    const double t = std::asin(std::sin(i) / n);
    return camera_along(upward(t), 1.0) + picture() + "media: {stuff: " + text(n) + "}\nobjects:\n" +
           box("block", {40.0, 40.0, 4.0}, {0.0, 0.0, -2.0}, "stuff") +
           lamp("lamp", upward(i) * 5.0, -upward(i), 0.5 * std::cos(i));
}

Fact brewster_reflection() {
    Fact fact{"T1", "Light reflected at Brewster's angle, tan i = n, is fully polarized across the plane of incidence.",
              "Born & Wolf 1.5.3; PHYSICS.md 2.1"};
    const std::size_t view = add_view(fact, "", mirror_scene("1.5", glass_brewster));
    const double n2 = n_glass * n_glass;
    expect(fact, view, "reflectance of p", 0.0, one_mirror, of_pixel(p_share));
    expect(fact, view, "reflectance of s", std::pow((n2 - 1.0) / (n2 + 1.0), 2), one_mirror, of_pixel(s_share));
    expect(fact, view, "degree of polarization", 1.0, ratio, of_pixel(dop));
    expect(fact, view, "ellipticity", 0.0, ratio, of_pixel(ellipticity));
    expect(fact, view, "azimuth from s", 0.0, rounding(1e3, "an angle in degrees"), of_pixel(azimuth_degrees), "deg");
    return fact;
}

Fact brewster_refraction() {
    Fact fact{"T2", "Light refracted at Brewster's angle is partially polarized in the plane of incidence.",
              "Born & Wolf 1.5.3: T_p = 1, T_s = 1 - R_s"};
    const std::size_t view = add_view(fact, "", refraction_scene(n_glass, glass_brewster));
    const double n2 = n_glass * n_glass;
    const double t_s = 1.0 - std::pow((n2 - 1.0) / (n2 + 1.0), 2);
    expect(fact, view, "degree of polarization", dop_of(1.0, t_s), one_mirror, of_pixel(dop));
    expect(fact, view, "s minus p over s plus p", -dop_of(1.0, t_s), one_mirror,
           of_pixel([](const Stokes<double>& s) { return s.s1 / s.s0; }));
    expect(fact, view, "ellipticity", 0.0, ratio, of_pixel(ellipticity));
    return fact;
}

Fact reflection_by_angle() {
    Fact fact{"T3", "Glass reflects 4 % at normal incidence, R_p = R_s^2 at 45 degrees, and everything at grazing.",
              "Fresnel, Born & Wolf 1.5.2 (24), signs after Verdet"};
    const std::size_t normal = add_view(fact, "normal incidence", mirror_scene("1.5", 0.0));
    expect(fact, normal, "reflectance", 0.04, one_mirror, of_pixel(s0));
    expect(fact, normal, "degree of polarization", 0.0, rounding(32.0 / 0.04, "one surface / 0.04"), of_pixel(dop));

    const ClosedFresnel f(n_glass, radians(45.0));
    const std::size_t oblique = add_view(fact, "45 degrees", mirror_scene("1.5", radians(45.0)));
    expect(fact, oblique, "reflectance of s", f.R_s(), one_mirror, of_pixel(s_share));
    expect(fact, oblique, "reflectance of p", f.R_s() * f.R_s(), one_mirror, of_pixel(p_share));
    expect(fact, oblique, "degree of polarization", (1.0 - f.R_s()) / (1.0 + f.R_s()),
           rounding(32.0 / 0.05, "one surface / 0.05"), of_pixel(dop));

    const Stokes<double> turned = f.of_diagonal_light();
    const std::size_t linear =
        add_view(fact, "45 degrees, diagonal light", mirror_scene("1.5", radians(45.0), polarized(diagonal)));
    expect(fact, linear, "S2", turned.s2, one_mirror, of_pixel(s2));

    const double i = radians(90.0) - 1e-3;
    const ClosedFresnel grazing(n_glass, i);
    const std::size_t flat = add_view(fact, "1 mrad from grazing", mirror_scene("1.5", i));
    expect(fact, flat, "reflectance of s", grazing.R_s(), one_mirror, of_pixel(s_share));
    expect(fact, flat, "reflectance of p", grazing.R_p(), one_mirror, of_pixel(p_share));
    return fact;
}

Fact diamond() {
    Fact fact{
        "T16",
        "Diamond reflects 17 % at normal incidence, no p at its Brewster angle, and holds light beyond 24.4 degrees.",
        "Fresnel; critical angle asin(1/n)"};
    const double n = 2.4172592;
    const std::size_t normal = add_view(fact, "normal incidence", mirror_scene(text(n), 0.0));
    expect(fact, normal, "reflectance", normal_reflectance(n), one_mirror, of_pixel(s0));
    const std::size_t at_brewster = add_view(fact, "Brewster's angle", mirror_scene(text(n), std::atan(n)));
    expect(fact, at_brewster, "reflectance of p", 0.0, one_mirror, of_pixel(p_share));
    const auto from_inside = [n](double i) {
        return camera_along(upward(i), 1.0) + picture("depth: 2") + "background: 1\nmedia: {stuff: " + text(n) +
               "}\nobjects:\n" + box("block", {40.0, 40.0, 4.0}, {0.0, 0.0, -2.0}, "stuff");
    };
    const double critical = std::asin(1.0 / n);
    for (const auto& [name, side, out] : {std::tuple{"1e-12 rad inside the critical angle", -1.0, 1.0},
                                          std::tuple{"1e-12 rad beyond the critical angle", 1.0, 0.0}}) {
        const std::size_t view = add_view(fact, name, from_inside(critical + side * 1e-12));
        expect(fact, view, "refracted rays", out, exact(),
               [](const Explanation& e) { return find_branch(e, "T") == nullptr ? 0.0 : 1.0; });
    }
    return fact;
}

/// n + ik at 580 nm between the two measured points around it, as PHYSICS.md 3 prints them.
struct Metal {
    const char* record;
    double nm[2], n[2], k[2];
    [[nodiscard]] Complex<double> index() const {
        const double share = (580.0 - nm[0]) / (nm[1] - nm[0]);
        return {n[0] + share * (n[1] - n[0]), k[0] + share * (k[1] - k[0])};
    }
};
constexpr std::array<Metal, 3> metals{{{"gold", {548.6, 582.1}, {0.43, 0.29}, {2.455, 2.863}},
                                       {"silver", {548.6, 582.1}, {0.06, 0.05}, {3.586, 3.858}},
                                       {"aluminium", {563.57, 619.93}, {1.0728, 1.3660}, {6.7839, 7.4052}}}};

/// Where r_p lags r_s by a quarter wave: S2 of light at +45 degrees vanishes. By bisection on the closed form.
double principal_angle(Complex<double> index) {
    double low = radians(45.0);
    double high = radians(89.0);
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (ClosedFresnel(index, middle).of_diagonal_light().s2 < 0.0 ? low : high) = middle;
    }
    return low;
}

Fact metal_reflection() {
    Fact fact{"T17", "Gold, silver and aluminium at 580 nm make light at +45 degrees right-handed elliptic.",
              "Born & Wolf 14.4.1; indices of Johnson & Christy 1972 and Rakic 1995, interpolated linearly"};
    for (const Metal& metal : metals) {
        const Complex<double> index = metal.index();
        const std::string name = metal.record;
        const std::string medium = "{conductor: " + name + "}";
        const ClosedFresnel f(index, radians(45.0));
        const Stokes<double> turned = f.of_diagonal_light();
        const std::size_t normal = add_view(fact, name + ", normal incidence", mirror_scene(medium, 0.0));
        expect(fact, normal, "reflectance", ClosedFresnel(index, 0.0).R_s(), one_mirror, of_pixel(s0));
        const std::size_t oblique = add_view(fact, name + ", 45 degrees", mirror_scene(medium, radians(45.0)));
        expect(fact, oblique, "degree of polarization", dop_of(f.R_s(), f.R_p()), one_mirror, of_pixel(dop));
        const std::size_t linear = add_view(fact, name + ", 45 degrees, diagonal light",
                                            mirror_scene(medium, radians(45.0), polarized(diagonal)));
        expect(fact, linear, "S3", turned.s3, one_mirror, of_pixel(s3));
        expect(fact, linear, "ellipticity",
               std::abs(turned.s3) / (std::hypot(turned.s1, turned.s2, turned.s3) + pol::hypot(turned.s1, turned.s2)),
               one_mirror, of_pixel(ellipticity));
        const std::size_t principal = add_view(fact, name + ", principal angle",
                                               mirror_scene(medium, principal_angle(index), polarized(diagonal)));
        expect(fact, principal, "S2", 0.0, rounding(64.0, "one surface and an angle"), of_pixel(s2));
    }
    return fact;
}

Fact reversed_handedness() {
    Fact fact{
        "T18",
        "A mirror met head on turns right circular light into left: the field goes on turning, the light comes back.",
        "PHYSICS.md 2.1: r_p = -r_s at normal incidence"};
    for (const auto& [name, medium, index] :
         {std::tuple{"glass", "1.5", Complex<double>(1.5)},
          std::tuple{"metal", "{conductor: [0.05, 3.8]}", Complex<double>(0.05, 3.8)}}) {
        const double r = ClosedFresnel(index, 0.0).R_s();
        for (const double hand : {1.0, -1.0}) {
            const std::string lit = hand > 0.0 ? ", right circular light" : ", left circular light";
            const std::size_t view =
                add_view(fact, name + lit, mirror_scene(medium, 0.0, polarized("[0, 0, " + text(hand) + "]")));
            expect(fact, view, "S3", -hand * r, one_mirror, of_pixel(s3));
            expect(fact, view, "ellipticity", 1.0, rounding(32.0 / 0.04, "one surface / 0.04"), of_pixel(ellipticity));
        }
    }
    return fact;
}

/// Amplitude of s through the first surface, from the branch that left it on the given side. The picture's x axis is s
/// up to the sign of the field vector.
Measurement s_amplitude(Interaction side) {
    return [side](const Explanation& e) {
        for (const RayTreeNode& node : e.tree.nodes)
            if (node.parent == 0 && node.interaction == side)
                return node.start.throughput.m[0][0].re * dot(node.start.wave.field[0], DVec3(0.0, -1.0, 0.0));
        return std::numeric_limits<double>::quiet_NaN();
    };
}

Fact reversed_ray() {
    Fact fact{"T19", "A ray and its reverse share R and T; their r are opposite, and t t' = 1 - r^2.",
              "Stokes' relations, PHYSICS.md 2.1"};
    const double i = radians(45.0);
    const double n4 = std::pow(n_glass, 4);
    const ClosedFresnel f(n_glass, i);
    const std::size_t out = add_view(fact, "lamp inside, camera outside", refraction_scene(n_glass, i));
    const std::size_t in = add_view(fact, "camera inside, lamp outside", from_inside_scene(n_glass, i));
    const double t = 1.0 - 0.5 * (f.R_s() + f.R_p());
    expect(fact, out, "transmittance", t, rounding(72.0, "one surface, n^2"),
           of_pixel([](const Stokes<double>& s) { return n_glass * n_glass * s.s0; }));
    expect(fact, in, "transmittance", t, one_mirror,
           of_pixel([](const Stokes<double>& s) { return s.s0 / (n_glass * n_glass); }));
    expect(fact, in, "radiance inside", n4 * t / (n_glass * n_glass), rounding(72.0, "one surface, n^2"), of_pixel(s0));
    expect(fact, out, "r of s from outside", f.r_s.re, one_mirror, s_amplitude(Interaction::reflected));
    expect(fact, in, "r of s from inside", -f.r_s.re, one_mirror, s_amplitude(Interaction::reflected));
    const double amplitude = std::sqrt(1.0 - f.r_s.re * f.r_s.re);
    expect(fact, out, "t of s from outside", amplitude, one_mirror, s_amplitude(Interaction::transmitted));
    expect(fact, in, "t of s from inside", amplitude, one_mirror, s_amplitude(Interaction::transmitted));
    return fact;
}

Fact lamp_inside_glass() {
    Fact fact{"T20",
              "A lamp inside glass looks dimmer from outside by T/n^2: its light spreads over a larger solid angle.",
              "conservation of L/n^2, PHYSICS.md 2.3"};
    const std::size_t view = add_view(fact, "", refraction_scene(n_glass, 0.0));
    expect(fact, view, "radiance", (1.0 - normal_reflectance(n_glass)) / (n_glass * n_glass), one_mirror, of_pixel(s0));
    expect(fact, view, "degree of polarization", 0.0, one_mirror, of_pixel(dop));
    return fact;
}

}  // namespace

std::vector<Fact> reflection_facts() {
    return {brewster_reflection(), brewster_refraction(), reflection_by_angle(), diamond(),
            metal_reflection(),    reversed_handedness(), reversed_ray(),        lamp_inside_glass()};
}

}  // namespace pol::verify
