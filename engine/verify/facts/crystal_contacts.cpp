// SPDX-License-Identifier: Apache-2.0
// T26, T36, T37: Huygens' two plates, crystals in contact with each other, and a crystal in a matching liquid.
#include <cmath>
#include <limits>

#include "core/units.h"
#include "verify/facts/chapters.h"
#include "verify/facts/closed_forms.h"
#include "verify/facts/scene_text.h"
#include "verify/facts/tree_paths.h"

namespace pol::verify {

namespace {

const Tolerance four_surfaces = rounding(240.0, "four surfaces of crystals");
const Tolerance nothing{std::pow(60.0 * epsilon, 2), "amplitude of 60 epsilon, squared"};

/// Two plates with axes at 45 degrees to their faces, the lower one turned by `alpha`, `gap` between them.
std::string two_plates(double alpha, double gap) {
    return camera_along(downward(0.0)) + picture("residual: 1e-6") + "media: {crystal: " + calcite({1.0, 0.0, 1.0}) +
           "}\nobjects:\n" + plate("upper", "crystal") + plate("lower", "crystal", -1.0 - gap, degrees(alpha)) +
           lamp("lamp", {0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}, 20.0);
}

/// Share of an o wave that crosses from a plate with principal section along x into one turned by alpha, as o and as e.
/// At normal incidence H_t = Y E_t, Y = n_o o o^T + n_45 e e^T with the two field directions, so that
/// E_t = 2 (Y1 + Y2)^-1 Y1 E_i.
DVec2 contact_shares_of_o(double alpha) {
    const double n_45 = e_index(radians(45.0));
    const DVec2 o1(0.0, 1.0);
    const DVec2 e2(std::cos(alpha), std::sin(alpha));
    const DVec2 o2(-std::sin(alpha), std::cos(alpha));
    const double xx = n_45 + n_45 * e2.x * e2.x + n_o * o2.x * o2.x;
    const double xy = n_45 * e2.x * e2.y + n_o * o2.x * o2.y;
    const double yy = n_o + n_45 * e2.y * e2.y + n_o * o2.y * o2.y;
    const DVec2 in = 2.0 * n_o * o1;
    const DVec2 t = DVec2(yy * in.x - xy * in.y, xx * in.y - xy * in.x) / (xx * yy - xy * xy);
    return {std::pow(t.x * o2.x + t.y * o2.y, 2), n_45 / n_o * std::pow(t.x * e2.x + t.y * e2.y, 2)};
}

Measurement share_of(const char* branch) {
    return [branch](const Explanation& e) { return share(e, branch); };
}
Fact huygens() {
    Fact fact{"T26", "Huygens' two plates: four images, bright as cos^2 and sin^2 of the angle between their sections.",
              "Huygens 1690 with Fresnel's losses; in contact E_t = 2 (Y1 + Y2)^-1 Y1 E_i"};
    const double alpha = radians(30.0);
    const double t_o = std::pow(1.0 - normal_reflectance(n_o), 2);
    const double t_e = std::pow(1.0 - normal_reflectance(e_index(radians(45.0))), 2);
    const double same = std::pow(std::cos(alpha), 2);
    const double other = std::pow(std::sin(alpha), 2);
    const std::size_t air = add_view(fact, "through air, 30 degrees", two_plates(alpha, 0.3));
    expect(fact, air, "o then o", 0.5 * t_o * t_o * same, four_surfaces, share_of("To T To T"));
    expect(fact, air, "e then e", 0.5 * t_e * t_e * same, four_surfaces, share_of("Te T Te T"));
    expect(fact, air, "o then e", 0.5 * t_o * t_e * other, four_surfaces, share_of("To T Te T"));
    expect(fact, air, "e then o", 0.5 * t_e * t_o * other, four_surfaces, share_of("Te T To T"));
    const DVec2 shares = contact_shares_of_o(alpha);
    const std::size_t contact = add_view(fact, "in contact, 30 degrees", two_plates(alpha, 0.0));
    expect(fact, contact, "o to o", shares.x, four_surfaces, kept_by("To To", "To"));
    expect(fact, contact, "o to e", shares.y, four_surfaces, kept_by("To Te", "To"));
    return fact;
}

Fact invisible_contacts() {
    Fact fact{"T36",
              "A liquid of the ordinary index hides calcite from the o ray, and like crystals in contact are one.",
              "equal indices reflect nothing; axes that differ in sign are one axis"};
    const double i = radians(35.0);
    const std::size_t liquid =
        add_view(fact, "plate in a liquid",
                 camera_along(downward(i)) + "ambient: liquid\n" + picture("residual: 1e-14") +
                     "media: {liquid: " + text(n_o) + ", crystal: " + calcite({0.0, 1.0, 0.0}) + "}\nobjects:\n" +
                     box("plate", {8.0, 8.0, 0.5}, {0.0, 0.0, -0.25}, "crystal") +
                     lamp("lamp", {0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}, 20.0));
    const Tolerance passes = residual_bound(1e-14, 1.0, rounding(720.0, "a dozen surfaces of a crystal"));
    expect(fact, liquid, "transmittance of p (o)", 1.0, passes, of_pixel(p_share));
    expect(fact, liquid, "transmittance of s (e)", pile_transmittance(1, ClosedFresnel(n_e / n_o, i).R_s()), passes,
           of_pixel(s_share));
    expect(fact, liquid, "o reflected", 0.0, nothing,
           [i](const Explanation& e) { return share_along(e, "R", cross(upward(i), DVec3(0.0, 1.0, 0.0))); });
    expect(fact, liquid, "o deviated, radians", 0.0, rounding(8.0, "a direction"), [i](const Explanation& e) {
        const RayTreeNode* out = find_branch(e, "To T");
        return out == nullptr ? std::numeric_limits<double>::quiet_NaN()
                              : angle_between(out->start.wave.ray, downward(i));
    });
    const std::size_t halves = add_view(fact, "two halves",
                                        camera_along(downward(0.6)) + picture("residual: 1e-6") + "media: {upper: " +
                                            calcite({1.0, 2.0, 3.0}) + ", lower: " + calcite({-1.0, -2.0, -3.0}) +
                                            "}\nobjects:\n" + box("a", {8.0, 8.0, 0.5}, {0.0, 0.0, -0.25}, "upper") +
                                            box("b", {8.0, 8.0, 0.5}, {0.0, 0.0, -0.75}, "lower") +
                                            lamp("lamp", {0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}, 20.0));
    for (const auto& [name, branch] : {std::pair{"o", "To"}, std::pair{"e", "Te"}}) {
        const std::string twice = std::string(branch) + " " + branch;
        expect(fact, halves, std::string(name) + " kept at the seam", 1.0, exact(),
               [twice, branch = branch](const Explanation& e) { return kept(e, twice, branch); });
        expect(fact, halves, std::string(name) + ": rays behind the seam", 1.0, exact(),
               [branch = branch](const Explanation& e) {
                   const RayTreeNode* found = find_branch(e, branch);
                   return found == nullptr ? 0.0 : static_cast<double>(found->children.size());
               });
    }
    return fact;
}

Fact crossed_plates() {
    Fact fact{"T37", "Crossed calcite plates in contact: every o becomes e and every e becomes o, but for 0.3 %.",
              "Fresnel at normal incidence: R = ((n_o - n_e)/(n_o + n_e))^2"};
    const std::size_t view =
        add_view(fact, "",
                 camera_along(downward(0.0)) + picture("residual: 1e-14, node_budget: 100000") +
                     "media: {upper: " + calcite({1.0, 0.0, 0.0}) + ", lower: " + calcite({0.0, 1.0, 0.0}) +
                     "}\nobjects:\n" + box("a", {8.0, 8.0, 0.5}, {0.0, 0.0, -0.25}, "upper") +
                     box("b", {8.0, 8.0, 0.5}, {0.0, 0.0, -0.75}, "lower") +
                     lamp("lamp", {0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}, 20.0));
    const double seam = std::pow((n_o - n_e) / (n_o + n_e), 2);
    expect(fact, view, "o reflected at the seam", seam, one_crystal_surface(), kept_by("To Ro", "To"));
    expect(fact, view, "o to e", 1.0 - seam, one_crystal_surface(), kept_by("To Te", "To"));
    expect(fact, view, "o to o", 0.0, nothing, kept_by("To To", "To"));
    expect(fact, view, "e reflected at the seam", seam, one_crystal_surface(), kept_by("Te Re", "Te"));
    expect(fact, view, "e to o", 1.0 - seam, one_crystal_surface(), kept_by("Te To", "Te"));
    expect(fact, view, "e to e", 0.0, nothing, kept_by("Te Te", "Te"));
    // Incoherent passes through parallel lossless surfaces: 1/T - 1 is the sum of R/(1 - R).
    const auto odds = [](double r) { return r / (1.0 - r); };
    const double t = 1.0 / (1.0 + odds(normal_reflectance(n_o)) + odds(seam) + odds(normal_reflectance(n_e)));
    const Tolerance passes = residual_bound(1e-14, 1.0, rounding(2400.0, "40 surfaces of crystals"));
    expect(fact, view, "transmittance, all passes", t, passes, of_pixel(s0));
    expect(fact, view, "degree of polarization", 0.0, passes, of_pixel(dop));
    return fact;
}

}  // namespace

std::vector<Fact> crystal_contact_facts() {
    return {huygens(), invisible_contacts(), crossed_plates()};
}

}  // namespace pol::verify
