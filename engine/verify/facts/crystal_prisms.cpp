// SPDX-License-Identifier: Apache-2.0
// T27 to T29: prisms, polarizers with a gap, and beam splitters made of crystals.
#include <cmath>

#include "core/units.h"
#include "verify/facts/chapters.h"
#include "verify/facts/closed_forms.h"
#include "verify/facts/scene_text.h"
#include "verify/facts/tree_paths.h"

namespace pol::verify {

namespace {

const Tolerance one_steep_surface = rounding(240.0, "one surface of a crystal with slopes of order 4");
const Tolerance fully = rounding(4.0, "a ratio of Stokes components");

Measurement rays_along(const char* branch) {
    return [branch](const Explanation& e) { return find_branch(e, branch) == nullptr ? 0.0 : 1.0; };
}

Fact calcite_prism() {
    Fact fact{"T27", "A calcite prism with its axis along the edge sends out two beams, each fully polarized.",
              "minimum deviation: sin((D + 60)/2) = n sin 30 with n_o and n_e"};
    for (const auto& [name, branch, n, sign] :
         {std::tuple{"o", "To T", n_o, 1.0}, std::tuple{"e", "Te T", n_e, -1.0}}) {
        const double i = std::asin(0.5 * n);
        // The lamp is 2 wide and 20 away, in this beam alone: the two are 16 degrees apart.
        const DVec3 in(std::cos(i - radians(30.0)), std::sin(i - radians(30.0)), 0.0);
        const DVec3 out(in.x, -in.y, 0.0);
        const DVec3 left_face(-0.5, 0.5 * std::sqrt(3.0), 0.0);
        const DVec3 right_face(0.5, 0.5 * std::sqrt(3.0), 0.0);
        const std::size_t view = add_view(
            fact, std::string(name) + " at minimum deviation",
            camera_in_plane(in, left_face) + picture() + "media: {crystal: " + calcite({0.0, 0.0, 1.0}) +
                "}\nobjects:\n" + extruded("prism", {{-1.0, 0.0}, {1.0, 0.0}, {0.0, std::sqrt(3.0)}}, "crystal") +
                lamp_in_plane(right_face + out * 20.0, -out, 2.0));
        expect(
            fact, view, "deviation", degrees(2.0 * i) - 60.0,
            rounding(64.0 * 60.0, "two refractions with slopes up to 4, in degrees"),
            [branch = branch](const Explanation& e) {
                const RayTreeNode* found = find_branch(e, branch);
                return found == nullptr
                           ? nan
                           : degrees(angle_between(e.tree.nodes.front().start.wave.ray, found->start.wave.ray));
            },
            "deg");
        const ClosedFresnel face(n, i);
        expect(fact, view, "share of the beam", 0.5 * std::pow(1.0 - (sign > 0.0 ? face.R_p() : face.R_s()), 2),
               one_steep_surface, [branch = branch](const Explanation& e) { return share(e, branch); });
        expect(fact, view, "S1 over S0", sign, fully, of_pixel([](const Stokes<double>& s) { return s.s1 / s.s0; }));
    }
    return fact;
}

/// Two prisms with a gap between faces that the light along -x meets at the angle `cut`. The gap lies across the plane
/// z = 0 and is filled with `filling`, if any, which then touches both prisms.
std::string glan(double cut, const DVec3& axis, const std::string& residual, const std::string& filling = "") {
    const double slope = std::tan(cut);
    const double half_gap = 0.001;
    const double length = slope + 0.5;
    std::string objects =
        extruded("near prism", {{-slope + half_gap, -1.0}, {length, -1.0}, {length, 1.0}, {slope + half_gap, 1.0}},
                 "crystal") +
        extruded("far prism", {{-length, -1.0}, {-slope - half_gap, -1.0}, {slope - half_gap, 1.0}, {-length, 1.0}},
                 "crystal");
    if (!filling.empty())
        objects += extruded(
            "layer",
            {{-slope - half_gap, -1.0}, {-slope + half_gap, -1.0}, {slope + half_gap, 1.0}, {slope - half_gap, 1.0}},
            "filling");
    return camera_in_plane({-1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}) +
           picture("residual: " + residual + ", node_budget: 200000") + "media: {crystal: " + calcite(axis) +
           (filling.empty() ? "" : ", filling: " + filling) + "}\nobjects:\n" + objects +
           lamp_in_plane({-1000.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 2.0);
}

const DVec3 foucault(0.0, 0.0, 1.0);  // axis across the plane of incidence at the gap
const DVec3 taylor(0.0, 1.0, 0.0);    // axis in it, along the entrance face
const double glan_cut = radians(38.5);

/// Transmittance of one face of the gap for e. Foucault: s light in a medium of index n_e. Taylor: p light; the ratio
/// of tangential E and H of an e wave is sqrt(eps_o eps_e (n.eps n - k_t^2))/(eps_o eps_e) (PHYSICS.md 2.7).
double foucault_face() {
    return 1.0 - ClosedFresnel(1.0 / n_e, glan_cut).R_s();
}
double taylor_face() {
    const double k_t = n_e * std::sin(glan_cut);
    const double n_eps_n = eps_o + (eps_e - eps_o) * std::pow(std::sin(glan_cut), 2);
    const double crystal = std::sqrt(eps_o * eps_e * (n_eps_n - k_t * k_t)) / (eps_o * eps_e);
    const double air = std::sqrt(1.0 - k_t * k_t);
    return 1.0 - std::pow((crystal - air) / (crystal + air), 2);
}

/// What the first `passes` ways to and fro in the gap bring to the far prism, per light of e that meets the gap.
Measurement sum_of_passes(int passes) {
    return [passes](const Explanation& e) {
        double sum = 0.0;
        std::string to_and_fro = "Te T";
        for (int i = 0; i < passes; ++i, to_and_fro += " R R") sum += kept(e, to_and_fro + " Te", "Te");
        return sum;
    };
}

Fact glan_and_nicol() {
    Fact fact{"T28", "A Glan polarizer reflects o totally at its air gap and passes e; a Nicol does so at its balsam.",
              "critical angles asin(1/n_o), asin(1/n_e), asin(1.55/n_o); T^2 (1 + (1 - T)^2 + ...) = T/(2 - T)"};
    for (const auto& [name, axis, face, passes, sign] : {std::tuple{"Foucault", foucault, foucault_face(), 6, -1.0},
                                                         std::tuple{"Taylor", taylor, taylor_face(), 2, 1.0}}) {
        const std::size_t view = add_view(fact, std::string(name) + ", cut 38.5 degrees", glan(glan_cut, axis, "1e-9"));
        expect(fact, view, "o reflected at the gap", 1.0, one_crystal_surface(), kept_by("To Ro", "To"));
        expect(fact, view, "e passed by a face", face, one_steep_surface, kept_by("Te T", "Te"));
        const double q = std::pow(1.0 - face, 2);
        expect(fact, view, "e passed by the gap", face / (2.0 - face) * (1.0 - std::pow(q, passes)),
               rounding(480.0, "two surfaces with slopes of order 4"), sum_of_passes(passes));
        expect(fact, view, "S1 over S0", sign, fully, of_pixel([](const Stokes<double>& s) { return s.s1 / s.s0; }));
    }
    struct Critical {
        const char* name;
        double angle;
        const char* branch;
        const char* filling;
    };
    for (const Critical& row : {Critical{"o at air", std::asin(1.0 / n_o), "To T", ""},
                                Critical{"e at air", std::asin(1.0 / n_e), "Te T", ""},
                                Critical{"o at balsam", std::asin(1.55 / n_o), "To T", "1.55"}}) {
        for (const auto& [side, step, out] :
             {std::tuple{" 1e-12 rad inside", -1e-12, 1.0}, std::tuple{" 1e-12 rad beyond", 1e-12, 0.0}}) {
            const std::string name = row.name + std::string(side);
            const std::size_t view = add_view(fact, name, glan(row.angle + step, foucault, "0.01", row.filling));
            expect(fact, view, "refracted rays", out, exact(), rays_along(row.branch));
        }
    }
    // For e balsam is the denser medium: it always passes.
    const double critical = std::asin(1.55 / n_o) + 1e-12;
    const std::size_t nicol = add_view(fact, "Nicol", glan(critical, foucault, "0.01", "1.55"));
    expect(fact, nicol, "e passed by balsam", 1.0 - ClosedFresnel(1.55 / n_e, critical).R_s(), one_steep_surface,
           kept_by("Te T", "Te"));
    return fact;
}

/// Two wedges in contact, the nearer one with its axis in the plane of the picture's x axis, the farther one along z.
std::string wollaston(double wedge, const std::string& near_medium, const std::string& far_medium) {
    const double slope = std::tan(wedge);
    const double length = slope + 0.5;
    return camera_in_plane({-1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}) + picture("residual: 1e-6, wavelengths: 589.3") +
           "background: 1\nmedia:\n  near: " + near_medium + "\n  far: " + far_medium + "\nobjects:\n" +
           extruded("near wedge", {{-slope, -1.0}, {length, -1.0}, {length, 1.0}, {slope, 1.0}}, "near") +
           extruded("far wedge", {{-length, -1.0}, {-slope, -1.0}, {slope, 1.0}, {-length, 1.0}}, "far");
}

/// Snell's law at the seam from n_1 to n_2, then at the exit face.
double exit_angle_by_snell(double wedge, double n_1, double n_2) {
    const double seam = std::asin(n_1 / n_2 * std::sin(wedge));
    return std::asin(n_2 * std::sin(wedge - seam));
}

/// From the beam straight on, positive towards +y.
Measurement exit_angle(const char* branch) {
    return [branch](const Explanation& e) {
        const RayTreeNode* found = find_branch(e, branch);
        if (found == nullptr) return nan;
        const DVec3 d = found->start.wave.ray;
        return degrees(std::atan2(d.y, -d.x));
    };
}

/// Ghosh 1999 at 589.3 nm: n^2 = 1 + b0 + b1 L/(L - c1) + b2 L/(L - c2), L in square micrometres.
double ghosh(double b0, double b1, double c1, double b2, double c2) {
    const double l = 0.5893 * 0.5893;
    return std::sqrt(1.0 + b0 + b1 * l / (l - c1) + b2 * l / (l - c2));
}

Fact wollaston_prism() {
    Fact fact{"T29", "A Wollaston prism splits a beam into two that have exchanged their roles at the seam.",
              "Snell at the seam and at the exit face; quartz after Ghosh 1999"};
    const double quartz_o = ghosh(0.28604141, 1.07044083, 1.00585997e-2, 1.10202242, 100.0);
    const double quartz_e = ghosh(0.28851804, 1.09509924, 1.02101864e-2, 1.15662475, 100.0);
    struct Row {
        const char* name;
        double wedge, o, e;
        std::string near_medium, far_medium;
    };
    for (const Row& row : {Row{"calcite", radians(15.0), n_o, n_e, calcite({0.0, 1.0, 0.0}), calcite({0.0, 0.0, 1.0})},
                           Row{"quartz", radians(45.0), quartz_o, quartz_e, "{crystal: quartz, axis: [0, 1, 0]}",
                               "{crystal: quartz, axis: [0, 0, 1]}"}}) {
        const Tolerance angle = rounding(32.0 * 60.0, "three refractions, in degrees");
        const std::size_t view = add_view(fact, row.name, wollaston(row.wedge, row.near_medium, row.far_medium), 589.3);
        expect(fact, view, "e then o leaves at", degrees(exit_angle_by_snell(row.wedge, row.e, row.o)), angle,
               exit_angle("Te To T"), "deg");
        expect(fact, view, "o then e leaves at", degrees(exit_angle_by_snell(row.wedge, row.o, row.e)), angle,
               exit_angle("To Te T"), "deg");
        expect(fact, view, "o that stays o", 0.0, {std::pow(60.0 * epsilon, 2), "amplitude of 60 epsilon, squared"},
               [](const Explanation& e) { return share(e, "To To"); });
    }
    return fact;
}

}  // namespace

std::vector<Fact> crystal_prism_facts() {
    return {calcite_prism(), glan_and_nicol(), wollaston_prism()};
}

}  // namespace pol::verify
