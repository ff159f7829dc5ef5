// SPDX-License-Identifier: Apache-2.0
// T30 to T34, T38 and T39: single faces of a crystal, and conservation.
#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "verify/facts/chapters.h"
#include "verify/facts/closed_forms.h"
#include "verify/facts/scene_text.h"
#include "verify/facts/tree_paths.h"

namespace pol::verify {

namespace {

constexpr const char* oracle = "tests/optics/oracle.py (110 digits)";

Fact brewster_angles() {
    Fact fact{"T30", "Calcite has a Brewster angle for every cut, where it reflects no p.",
              "Lekner 1991: tan^2 i = eps_e (eps_o - 1)/(eps_e - 1); eps_o (eps_e - 1)/(eps_o - 1); eps_o"};
    const struct {
        const char* name;
        DVec3 axis;
        double i, n_s;  // n_s: index that s sees
    } rows[] = {
        {"axis along the normal", {0.0, 0.0, 1.0}, std::atan(std::sqrt(eps_e * (eps_o - 1.0) / (eps_e - 1.0))), n_o},
        {"axis in face and plane", {1.0, 0.0, 0.0}, std::atan(std::sqrt(eps_o * (eps_e - 1.0) / (eps_o - 1.0))), n_o},
        {"axis across the plane", {0.0, 1.0, 0.0}, std::atan(n_o), n_e}};
    for (const auto& row : rows) {
        const std::size_t view = add_view(
            fact, row.name,
            camera_along(downward(row.i)) + picture() + "media: {crystal: " + calcite(row.axis) + "}\nobjects:\n" +
                deep_block("crystal") + lamp("lamp", upward(row.i) * 10.0, -upward(row.i), 0.5));
        expect(fact, view, "reflectance of p", 0.0, one_crystal_surface(), of_pixel(p_share));
        expect(fact, view, "reflectance of s", ClosedFresnel(row.n_s, row.i).R_s(), one_crystal_surface(),
               of_pixel(s_share));
    }
    return fact;
}

/// Inside a crystal with its axis along (1, 1, 1): a wave normal meets the face z = 0 from below at the angle `i` in
/// the plane y = 0. The light came in through a face across that wave normal. Extrusions lie along z, so everything is
/// turned: (x, y, z) of the fact is (x, z, -y) of the scene.
std::string inside_calcite(double i) {
    const DVec3 s(std::sin(i), std::cos(i), 0.0);
    const DVec2 corner(-1.0, 0.0);
    const DVec2 along_face(std::cos(i), -std::sin(i));
    return "camera: {type: orthographic, position: " + text(s * -5.0) +
           ", target: [0, 0, 0], up: [0, 0, 1], width: 1}\n" + picture("depth: 2") + "background: 1\n" +
           "media: {crystal: " + calcite({1.0, 1.0, -1.0}) + "}\nobjects:\n" +
           extruded("wedge", {corner, corner + along_face * 1.5, {3.0, 0.0}}, "crystal");
}

Fact end_of_the_e_sheet() {
    Fact fact{"T31", "Inside calcite, beyond the end of the e sheet, all power stays in the reflected o wave.",
              "PHYSICS.md 2.5: disc = 0 at k_t^2 = eps_e (2 eps_o + eps_e)/(eps_o + 2 eps_e)"};
    const std::size_t steep = add_view(fact, "o at 75 degrees", inside_calcite(radians(75.0)));
    expect(fact, steep, "o reflected as o", 1.0, one_crystal_surface(), kept_by("To Ro", "To"));
    const double end = std::sqrt(eps_e * (2.0 * eps_o + eps_e) / (eps_o + 2.0 * eps_e));
    const double last = std::asin(end / n_o);
    for (const auto& [name, step, rays] :
         {std::tuple{"1e-12 rad inside the end", -1e-12, 1.0}, std::tuple{"1e-12 rad beyond the end", 1e-12, 0.0}}) {
        const std::size_t view = add_view(fact, name, inside_calcite(last + step));
        expect(fact, view, "e rays", rays, exact(),
               [](const Explanation& e) { return find_branch(e, "To Re") == nullptr ? 0.0 : 1.0; });
    }
    return fact;
}

Fact conversion_by_total_reflection() {
    Fact fact{"T32", "Total reflection inside calcite turns a third of the o wave into e.", oracle};
    const std::size_t view = add_view(fact, "", inside_calcite(radians(60.0)));
    const Tolerance printed = last_printed_digit(7, oracle);
    expect(fact, view, "o to o", 0.6648153, printed, kept_by("To Ro", "To"));
    expect(fact, view, "o to e", 0.3351847, printed, kept_by("To Re", "To"));
    expect(fact, view, "both", 1.0, one_crystal_surface(),
           [](const Explanation& e) { return kept(e, "To Ro", "To") + kept(e, "To Re", "To"); });
    expect(fact, view, "tangential k of the e wave", n_o * std::sin(radians(60.0)), rounding(16.0, "a wave vector"),
           [](const Explanation& e) {
               const RayTreeNode* found = find_branch(e, "To Re");
               return found == nullptr ? nan : found->start.wave.k.x;
           });
    return fact;
}

// Seen from below through a polarizer, so that s or p alone is traced: the scene's z axis points into the crystal.
Fact oblique_axis() {
    Fact fact{"T33", "At a calcite face with an oblique axis s and p each go into all four waves.", oracle};
    const double i = radians(40.0);
    const DVec3 d(std::sin(i), 0.0, std::cos(i));
    const DVec3 s(0.0, 1.0, 0.0);
    const DVec3 p_reflected = cross(DVec3(d.x, 0.0, -d.z), s);
    const Tolerance printed = last_printed_digit(10, oracle);
    const struct {
        const char *name, *passes;
        double r_s, r_p, t_o, t_e;
    } rows[] = {{"s", "[1, 0, 0]", .0988192860, .0003862017, .0136222293, .8871722831},
                {"p", "[0, 1, 0]", .0000051598, .0260771219, .9598073577, .0141103606}};
    for (const auto& row : rows) {
        const std::size_t view = add_view(
            fact, row.name,
            camera_along(d) + picture("depth: 2") + "background: 1\nmedia: {crystal: " + calcite({1.0, 2.0, 3.0}) +
                "}\nobjects:\n" + box("block", {40.0, 40.0, 4.0}, {0.0, 0.0, 2.0}, "crystal") +
                "  - {name: polarizer, shape: {disk: {radius: 1}}, " + placed(d * -2.0, d, s) +
                ", sheet: {polarizer: {axis: " + row.passes + "}}}\n");
        expect(fact, view, "reflected s", row.r_s, printed,
               [s](const Explanation& e) { return share_along(e, "S R", s) / share(e, "S"); });
        expect(fact, view, "reflected p", row.r_p, printed,
               [p_reflected](const Explanation& e) { return share_along(e, "S R", p_reflected) / share(e, "S"); });
        expect(fact, view, "o", row.t_o, printed, kept_by("S To", "S"));
        expect(fact, view, "e", row.t_e, printed, kept_by("S Te", "S"));
        const DVec3 ray(.4125141726, -.1022513741, .9051942962);
        for (int axis = 0; axis < 3; ++axis)
            expect(fact, view, "e ray, " + std::string(1, "xyz"[axis]), ray[axis], printed,
                   [axis](const Explanation& e) {
                       const RayTreeNode* found = find_branch(e, "S Te");
                       return found == nullptr ? nan : found->start.wave.ray[axis];
                   });
    }
    return fact;
}

Fact refraction_of_the_e_ray() {
    Fact fact{
        "T34", "The e ray follows its own law of refraction, which depends on the cut; the o ray follows Snell.",
        "PHYSICS.md 5, T34: tan r = n_o s/(n_e sqrt(eps_e - s^2)), tan r = n_e s/(n_o sqrt(eps_o - s^2)), s = sin i"};
    for (const double degree : {30.0, 60.0}) {
        const double i = radians(degree);
        const double s = std::sin(i);
        const struct {
            const char* name;
            DVec3 axis;
            double e_angle;
        } cuts[] = {{"axis along the normal", {0.0, 0.0, 1.0}, std::atan(n_o * s / (n_e * std::sqrt(eps_e - s * s)))},
                    {"axis in the face", {1.0, 0.0, 0.0}, std::atan(n_e * s / (n_o * std::sqrt(eps_o - s * s)))}};
        for (const auto& cut : cuts) {
            const std::string name = cut.name + std::string(degree == 30.0 ? ", 30 degrees" : ", 60 degrees");
            const std::size_t view = add_view(fact, name,
                                              camera_along(downward(i)) + picture() +
                                                  "background: 1\nmedia: {crystal: " + calcite(cut.axis) +
                                                  "}\nobjects:\n" + deep_block("crystal"));
            const Tolerance tolerance = rounding(60.0 * 60.0, "one surface of a crystal, in degrees");
            for (const auto& [mode, branch, angle] :
                 {std::tuple{"e ray", "Te", cut.e_angle}, std::tuple{"o ray", "To", std::asin(s / n_o)}})
                expect(
                    fact, view, mode, degrees(angle), tolerance,
                    [branch = branch](const Explanation& e) {
                        const RayTreeNode* found = find_branch(e, branch);
                        return found == nullptr ? nan : degrees(angle_between(found->start.wave.ray, downward(0.0)));
                    },
                    "deg");
        }
    }
    return fact;
}

Fact crystal_in_a_furnace() {
    Fact fact{"T38", "In uniform unpolarized surroundings a crystal is invisible: J = L/2, P = 0.",
              "PHYSICS.md 2.8: |S|^2 is doubly stochastic"};
    const std::size_t view =
        add_view(fact, "",
                 camera_along(downward(0.7)) + picture("residual: 1e-13, node_budget: 200000") +
                     "background: 1\nmedia: {crystal: " + calcite({1.0, 2.0, 3.0}) + "}\nobjects:\n" +
                     box("plate", {1000.0, 1000.0, 0.5}, {0.0, 0.0, 0.0}, "crystal"));
    const Tolerance tolerance = residual_bound(1e-13, 1.0, rounding(3000.0, "50 surfaces of crystals"));
    expect(fact, view, "radiance", 1.0, tolerance, of_pixel(s0));
    expect(fact, view, "degree of polarization", 0.0, tolerance, of_pixel(dop));
    return fact;
}

Fact conservation() {
    Fact fact{"T39", "At every interface what is reflected and transmitted adds up to what came in.",
              "the flux normal to a lossless interface is continuous"};
    const std::size_t view =
        add_view(fact, "calcite jewel",
                 "camera: {position: [0.35, -4, 3.2], target: [0, 0, -0.1], fov: 32}\nbackground: 1\n" +
                     picture("residual: 0.05, node_budget: 20000") + "media: {crystal: " + calcite({1.0, 2.0, 3.0}) +
                     "}\nobjects:\n  - {name: stone, shape: {brilliant: {diameter: 2}}, medium: crystal}\n");
    // Of hundreds of interfaces a few are close to grazing or critical.
    expect(fact, view, "worst |R + T - 1| of all interfaces", 0.0,
           {1e-11, "60 operations with slopes up to 1e3 near critical angles"}, [](const Explanation& e) {
               double worst = 0.0;
               for (const RayTreeNode& node : e.tree.nodes) {
                   if (node.reason || node.children.empty()) continue;
                   double sum = 0.0;
                   for (const int child : node.children)
                       sum += e.tree.nodes[static_cast<std::size_t>(child)].start.weight;
                   worst = std::max(worst, std::abs(sum / node.end.weight - 1.0));
               }
               return worst;
           });
    expect(fact, view, "resolved, absorbed and open weight", 1.0,
           {1e-12, "sum of 20000 weights: epsilon each, 1 in all"},
           [](const Explanation& e) { return e.result.resolved + e.result.absorbed + e.result.residual; });
    return fact;
}

}  // namespace

std::vector<Fact> crystal_face_facts() {
    return {brewster_angles(), end_of_the_e_sheet(),      conversion_by_total_reflection(),
            oblique_axis(),    refraction_of_the_e_ray(), crystal_in_a_furnace(),
            conservation()};
}

}  // namespace pol::verify
