// SPDX-License-Identifier: Apache-2.0
// T13 with ideal sheets, T15 with a drop of water, and what is not modelled: T40 to T43.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "core/units.h"
#include "verify/closed_forms.h"
#include "verify/fact_chapters.h"
#include "verify/scene_text.h"
#include "verify/tree_paths.h"

namespace pol::verify {

namespace {

/// Polarizers at these angles (degrees) from the picture's x axis over a lamp, the first one nearest to the lamp.
std::string polarizers(const std::vector<double>& angles) {
    std::string yaml =
        "camera: {type: orthographic, position: [0, 0, 9], target: [0, 0, 0], up: [0, 1, 0], width: 3}\n" + picture() +
        "objects:\n  - {name: lamp, shape: {rectangle: {size: 4}}, transform: [{translate: [0, 0, -1]}], emission: "
        "{radiance: 1}}\n";
    double height = 0.0;
    for (const double angle : angles) {
        const DVec3 axis(std::cos(radians(angle)), std::sin(radians(angle)), 0.0);
        yaml += fmt::format(
            "  - {{name: polarizer at {0}, shape: {{disk: {{radius: 1}}}}, transform: [{{translate: [0, 0, {1}]}}], "
            "sheet: {{polarizer: {{axis: {2}}}}}}}\n",
            angle, text(height), text(axis));
        height += 0.25;
    }
    return yaml;
}

Fact malus() {
    Fact fact{"T13", "Malus: behind a first polarizer a second one passes cos^2 of the angle between them.",
              "Malus 1809; an ideal polarizer projects the field"};
    const Tolerance sheets = rounding(32.0, "two sheets");
    const std::size_t one = add_view(fact, "one polarizer", polarizers({30.0}));
    expect(fact, one, "radiance", 0.5, sheets, of_pixel(s0));
    expect(fact, one, "azimuth", 30.0, rounding(1e3, "an angle in degrees"), of_pixel(azimuth_degrees), "deg");
    const std::size_t two = add_view(fact, "two, 30 degrees apart", polarizers({30.0, 0.0}));
    expect(fact, two, "radiance", 0.375, sheets, of_pixel(s0));
    const std::size_t crossed = add_view(fact, "two, crossed", polarizers({90.0, 0.0}));
    expect(fact, crossed, "radiance", 0.0, {std::pow(32.0 * epsilon, 2), "amplitude of 32 epsilon, squared"},
           of_pixel(s0));
    const std::size_t three = add_view(fact, "three, 45 degrees apart", polarizers({90.0, 45.0, 0.0}));
    expect(fact, three, "radiance", 0.125, sheets, of_pixel(s0));
    constexpr int steps = 9;
    std::vector<double> fan;
    for (int i = 0; i <= steps; ++i) fan.push_back(90.0 * i / steps);
    const std::size_t many = add_view(fact, "fan of ten", polarizers(fan));
    expect(fact, many, "radiance", 0.5 * std::pow(std::cos(0.5 * pi / steps), 2 * steps),
           rounding(16.0 * steps, "ten sheets"), of_pixel(s0));
    return fact;
}

Fact rainbow() {
    Fact fact{"T15", "A water drop sends its rainbow to 42 degrees, 92 % polarized along the bow.",
              "Descartes: cos^2 i = (n^2 - 1)/3; Fresnel: T^2 R"};
    const double n = 1.333;
    const double i = std::acos(std::sqrt((n * n - 1.0) / 3.0));
    const double t = std::asin(std::sin(i) / n);
    const DVec3 met(std::sin(i), 0.0, 0.0);
    const std::size_t view = add_view(fact, "",
                                      camera_seeing_s_as_x(met + DVec3(0.0, 0.0, 5.0), met) + picture("depth: 3") +
                                          "background: 1\nmedia: {water: " + text(n) +
                                          "}\nobjects:\n  - {name: drop, shape: {sphere: {radius: 1}}, "
                                          "medium: water}\n");
    const Tolerance tolerance = rounding(128.0, "three surfaces met at an angle good to epsilon/cos i");
    const ClosedFresnel f(n, i);
    const double s = std::pow(1.0 - f.R_s(), 2) * f.R_s();
    const double p = std::pow(1.0 - f.R_p(), 2) * f.R_p();
    expect(
        fact, view, "radius of the bow", degrees(4.0 * t - 2.0 * i),
        rounding(128.0 * 60.0, "three surfaces, in degrees"),
        [](const Explanation& e) {
            const auto branches = path(e, "TRT");
            if (branches.empty()) return std::numeric_limits<double>::quiet_NaN();
            return degrees(angle_between(branches.front()->start.wave.ray, -branches.back()->start.wave.ray));
        },
        "deg");
    expect(fact, view, "light of s", s, tolerance, along("TRT", s_share));
    expect(fact, view, "light of p", p, tolerance, along("TRT", p_share));
    expect(fact, view, "degree of polarization", dop_of(s, p), rounding(128.0 / 0.04, "three surfaces / 0.04"),
           along("TRT", dop));
    return fact;
}

Fact not_modelled(const char* id, const char* sentence, const char* source, const char* why) {
    Fact fact{id, sentence, source};
    fact.not_modelled = why;
    return fact;
}

}  // namespace

std::vector<Fact> element_facts() {
    return {malus()};
}

std::vector<Fact> drop_facts() {
    return {rainbow()};
}

std::vector<Fact> unmodelled_facts() {
    const char* incoherent = "o and e add incoherently: a crystal plate has no retardance; ideal retarder sheets have";
    return {
        not_modelled("T40", "Biaxial crystals have two optic axes, and cones of rays along them.", "physics.md 2.6",
                     "biaxial media are not traced; the shipped indices of KTP are tested to give its axes and cone"),
        not_modelled("T41", "A quarter-wave plate of crystal makes linear light at 45 degrees circular.",
                     "physics.md 6", incoherent),
        not_modelled("T42", "A half-wave plate of crystal at phi turns linear light by 2 phi and flips handedness.",
                     "physics.md 6", incoherent),
        not_modelled("T43", "A crystal plate between crossed polarizers passes sin^2(2 phi) sin^2(Gamma/2)/2.",
                     "physics.md 6", incoherent)};
}

}  // namespace pol::verify
