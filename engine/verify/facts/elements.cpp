// SPDX-License-Identifier: Apache-2.0
// T13, T52 and T53 with ideal sheets, T15 with a drop of water, and what is not modelled: T40 to T43.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "core/units.h"
#include "verify/facts/chapters.h"
#include "verify/facts/closed_forms.h"
#include "verify/facts/scene_text.h"
#include "verify/facts/tree_paths.h"

namespace pol::verify {

namespace {

/// Ideal sheets (YAML of their operators) over a lamp, the first one nearest to the lamp. The camera's x and y are
/// those of the world.
std::string stack(const std::vector<std::string>& sheets, const std::string& emission = "radiance: 1") {
    std::string yaml =
        "camera: {type: orthographic, position: [0, 0, 9], target: [0, 0, 0], up: [0, 1, 0], width: 3}\n" + picture() +
        "objects:\n  - {name: lamp, shape: {rectangle: {size: 4}}, transform: [{translate: [0, 0, -1]}], emission: {" +
        emission + "}}\n";
    double height = 0.0;
    for (const std::string& sheet : sheets) {
        yaml += fmt::format(
            "  - {{name: sheet at {0}, shape: {{disk: {{radius: 1}}}}, transform: [{{translate: [0, 0, {0}]}}], "
            "sheet: {{{1}}}}}\n",
            text(height), sheet);
        height += 0.25;
    }
    return yaml;
}

std::string axis_text(double degree) {
    return text(DVec3(std::cos(radians(degree)), std::sin(radians(degree)), 0.0));
}
std::string polarizer(double degree) {
    return "polarizer: {axis: " + axis_text(degree) + "}";
}
std::string retarder(double degree, double retardance) {
    return "retarder: {fast_axis: " + axis_text(degree) + ", retardance: " + text(retardance) + "}";
}

Fact malus() {
    Fact fact{"T13", "Malus: behind a first polarizer a second one passes cos^2 of the angle between them.",
              "Malus 1809; an ideal polarizer projects the field"};
    const Tolerance sheets = rounding(32.0, "two sheets");
    const std::size_t one = add_view(fact, "one polarizer", stack({polarizer(30.0)}));
    expect(fact, one, "radiance", 0.5, sheets, of_pixel(s0));
    expect(fact, one, "azimuth", 30.0, rounding(1e3, "an angle in degrees"), of_pixel(azimuth_degrees), "deg");
    const std::size_t two = add_view(fact, "two, 30 degrees apart", stack({polarizer(30.0), polarizer(0.0)}));
    expect(fact, two, "radiance", 0.375, sheets, of_pixel(s0));
    const std::size_t crossed = add_view(fact, "two, crossed", stack({polarizer(90.0), polarizer(0.0)}));
    expect(fact, crossed, "radiance", 0.0, {std::pow(32.0 * epsilon, 2), "amplitude of 32 epsilon, squared"},
           of_pixel(s0));
    const std::size_t three =
        add_view(fact, "three, 45 degrees apart", stack({polarizer(90.0), polarizer(45.0), polarizer(0.0)}));
    expect(fact, three, "radiance", 0.125, sheets, of_pixel(s0));
    constexpr int steps = 9;
    std::vector<std::string> fan;
    for (int i = 0; i <= steps; ++i) fan.push_back(polarizer(90.0 * i / steps));
    const std::size_t many = add_view(fact, "fan of ten", stack(fan));
    expect(fact, many, "radiance", 0.5 * std::pow(std::cos(0.5 * pi / steps), 2 * steps),
           rounding(16.0 * steps, "ten sheets"), of_pixel(s0));
    return fact;
}

Fact retarder_sheets() {
    Fact fact{"T52", "Ideal retarders: a quarter wave makes linear light circular, half a wave turns it by 2 phi.",
              "Born & Wolf 14.4.2 with exp(-i omega t): s3 = 2 Im E_x E_y^*, the slow axis lags"};
    const Tolerance sheets = rounding(48.0, "three sheets");
    const std::size_t quarter =
        add_view(fact, "quarter wave, light at +45 degrees", stack({retarder(0.0, 90.0)}, polarized("[0, 1, 0]")));
    expect(fact, quarter, "S3 (left-handed)", -1.0, sheets, of_pixel(s3));
    const std::size_t half =
        add_view(fact, "half wave at 10 degrees", stack({retarder(10.0, 180.0)}, polarized("[1, 0, 0]")));
    expect(fact, half, "azimuth", 20.0, rounding(48.0 * 60.0, "three sheets, in degrees"), of_pixel(azimuth_degrees),
           "deg");
    const std::size_t right =
        add_view(fact, "half wave, right circular light", stack({retarder(10.0, 180.0)}, polarized("[0, 0, 1]")));
    expect(fact, right, "S3", -1.0, sheets, of_pixel(s3));
    const std::size_t crossed =
        add_view(fact, "between crossed polarizers", stack({polarizer(90.0), retarder(20.0, 75.0), polarizer(0.0)}));
    expect(fact, crossed, "radiance", 0.5 * std::pow(std::sin(radians(40.0)), 2) * std::pow(std::sin(radians(37.5)), 2),
           sheets, of_pixel(s0));
    return fact;
}

Fact circular_sheet() {
    Fact fact{"T53", "A circular polarizer passes one handedness and makes all light that passes circular.",
              "projector on (1, -i)/sqrt 2 for right"};
    const Tolerance sheets = rounding(16.0, "one sheet");
    const std::string right = "circular: {passes: right}";
    for (const auto& [name, emission, power] : {std::tuple{"unpolarized light", std::string("radiance: 1"), 0.5},
                                                std::tuple{"right circular light", polarized("[0, 0, 1]"), 1.0},
                                                std::tuple{"left circular light", polarized("[0, 0, -1]"), 0.0},
                                                std::tuple{"linear light", polarized("[1, 0, 0]"), 0.5}}) {
        const std::size_t view = add_view(fact, name, stack({right}, emission));
        expect(fact, view, "radiance", power, sheets, of_pixel(s0));
        expect(fact, view, "S3", power, sheets, of_pixel(s3));
    }
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
    return {malus(), retarder_sheets(), circular_sheet()};
}

std::vector<Fact> drop_facts() {
    return {rainbow()};
}

std::vector<Fact> unmodelled_facts() {
    const char* incoherent = "o and e add incoherently, so a crystal plate has no retardance; sheets have (T52)";
    return {not_modelled("T40", "Biaxial crystals have two optic axes, and cones of rays along them.", "PHYSICS.md 2.6",
                         "biaxial media are not traced"),
            not_modelled("T41", "A quarter-wave plate of crystal makes linear light at 45 degrees circular.",
                         "PHYSICS.md 6", incoherent),
            not_modelled("T42", "A half-wave plate of crystal at phi turns linear light by 2 phi and flips handedness.",
                         "PHYSICS.md 6", incoherent),
            not_modelled("T43", "A crystal plate between crossed polarizers passes sin^2(2 phi) sin^2(Gamma/2)/2.",
                         "PHYSICS.md 6", incoherent)};
}

}  // namespace pol::verify
