// SPDX-License-Identifier: Apache-2.0
// T54 to T58: lamps inside, behind and in front of crystals, and where a camera sees them.
#include <cmath>

#include "core/units.h"
#include "verify/facts/chapters.h"
#include "verify/facts/closed_forms.h"
#include "verify/facts/scene_text.h"

namespace pol::verify {

namespace {

/// With the optic axis across the plane of incidence, s is the e wave of index n_e and p the o wave of index n_o, as in
/// two isotropic media. Between the two critical angles of a positive crystal p is reflected totally and s is not.
Fact between_two_critical_angles() {
    Fact fact{"T54", "Between the critical angles of a positive crystal o is reflected totally, e is not.",
              "PHYSICS.md 2.5 with the axis across the plane of incidence; Born & Wolf 1.5.2"};
    const double n1 = 1.7;
    const double n_small = 1.5;
    const double n_large = 1.65;
    const double i = radians(67.0);  // n1 sin i = 1.565
    const std::string media = "media: {liquid: " + text(n1) + ", crystal: {ordinary: " + text(n_small) +
                              ", extraordinary: " + text(n_large) + ", axis: [0, 1, 0]}}\nambient: liquid\nobjects:\n";
    const std::size_t view =
        add_view(fact, "light at +45 degrees",
                 camera_along(downward(i)) + picture() + media + deep_block("crystal") +
                     lamp("lamp", upward(i) * 10.0, -upward(i), std::cos(i), polarized("[0, 1, 0]")));
    const Complex<double> r_s = ClosedFresnel(n_large / n1, i).r_s;
    const Complex<double> r_p = ClosedFresnel(n_small / n1, i).r_p;
    const Complex<double> xy = r_s * conj(r_p);
    expect(fact, view, "reflectance of e (s)", norm2(r_s), one_crystal_surface(), of_pixel(s_share));
    expect(fact, view, "reflectance of o (p)", 1.0, one_crystal_surface(), of_pixel(p_share));
    expect(fact, view, "S2", xy.re, one_crystal_surface(), of_pixel(s2));
    expect(fact, view, "S3", xy.im, one_crystal_surface(), of_pixel(s3));
    return fact;
}

Fact lamp_inside_crystal() {
    Fact fact{"T55", "A lamp inside calcite shines out by o and by e, each dimmed by its own T and N^2.",
              "PHYSICS.md 2.3: N^2 = n_o^2 for o, n_e^4 n_o^2/n_r^4 for e, n_r the ray index"};
    const double across = e_index(radians(45.0));
    // tan rho = (eps_o - eps_e)/(eps_o + eps_e) at 45 degrees (T23); n_r = n cos rho.
    const double walk_off = std::atan((eps_o - eps_e) / (eps_o + eps_e));
    const double ray_index = across * std::cos(walk_off);
    const double of_o = 0.5 * (1.0 - normal_reflectance(n_o)) / eps_o;
    const double of_e = 0.5 * (1.0 - normal_reflectance(across)) * std::pow(ray_index, 4) / (eps_e * eps_e * eps_o);
    const std::size_t view =
        add_view(fact, "axis at 45 degrees",
                 camera_along({0.0, 0.0, -1.0}) + picture() + "media: {crystal: " + calcite({1.0, 0.0, 1.0}) +
                     "}\nobjects:\n" + box("block", {40.0, 40.0, 4.0}, {0.0, 0.0, -2.0}, "crystal") +
                     lamp("lamp", {0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}, 2.0));
    expect(fact, view, "radiance of o (s)", 2.0 * of_o, one_crystal_surface(), of_pixel(s_share));
    expect(fact, view, "radiance of e (p)", 2.0 * of_e, one_crystal_surface(), of_pixel(p_share));
    return fact;
}

/// A camera above the xy plane whose x and y are those of the world, 3 wide.
std::string camera_above() {
    return "camera: {type: orthographic, position: [0, 0, 9], target: [0, 0, 0], up: [0, 1, 0], width: 3}\n" +
           picture();
}

Fact virtual_plate() {
    Fact fact{"T56", "A plate that passes one ray of a crystal halves the light: e along the axis, o across it.",
              "Debelov & Kozlov, section 5.3; E of e lies in the plane of the axis"};
    for (const auto& [ray, sign] : {std::pair{"e", 1.0}, std::pair{"o", -1.0}}) {
        const std::size_t view = add_view(
            fact, std::string("plate passes ") + ray,
            camera_above() + "media: {crystal: " + calcite({1.0, 0.0, 0.0}) +
                "}\nobjects:\n  - {name: lamp, shape: {rectangle: {size: 4}}, emission: {radiance: 1, polarization: "
                "{crystal_plate: {medium: crystal, axis: [1, 0, 0], ray: " +
                ray + ", fresnel: off}}}}\n");
        expect(fact, view, "radiance", 0.5, one_crystal_surface(), of_pixel(s0));
        expect(fact, view, "S1", 0.5 * sign, one_crystal_surface(), of_pixel(s1));
    }
    return fact;
}

Fact front_and_back() {
    Fact fact{"T57", "A lamp shines from its front; only a two-sided one shines from its back.",
              "definition, assets/scenes/README.md"};
    for (const auto& [name, emission, radiance] :
         {std::tuple{"one-sided, from behind", "radiance: 1", 0.0},
          std::tuple{"two-sided, from behind", "radiance: 1, two_sided: on", 1.0}}) {
        const std::size_t view = add_view(
            fact, name, camera_above() + "objects:\n" + lamp("lamp", {0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, 4.0, emission));
        expect(fact, view, "radiance", radiance, exact(), of_pixel(s0));
    }
    return fact;
}

Fact upright_picture() {
    Fact fact{"T58", "What is up and right in the scene is up and right in the picture; row 0 is the top row.",
              "frame of the camera, PHYSICS.md 1"};
    // Pixel (22, 4) of 33 x 33 over a width of 3 has its centre at ((22.5 - 16.5), (16.5 - 4.5)) 3/33.
    const std::string scene =
        camera_above() + "objects:\n" + lamp("lamp", {6.0 * 3.0 / 33.0, 12.0 * 3.0 / 33.0, 0.0}, {0.0, 0.0, 1.0}, 0.3);
    for (const auto& [name, x, y, radiance] :
         {std::tuple{"up and right", 22, 4, 1.0}, std::tuple{"up and left", 10, 4, 0.0},
          std::tuple{"down and right", 22, 28, 0.0}}) {
        fact.views.push_back({name, scene, x, y});
        expect(fact, fact.views.size() - 1, "radiance", radiance, exact(), of_pixel(s0));
    }
    return fact;
}

}  // namespace

std::vector<Fact> lamp_facts() {
    return {between_two_critical_angles(), lamp_inside_crystal(), virtual_plate(), front_and_back(), upright_picture()};
}

}  // namespace pol::verify
