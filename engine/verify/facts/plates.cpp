// SPDX-License-Identifier: Apache-2.0
// T4 to T8 and T14: piles of glass plates, and glass in uniform surroundings.
#include <cmath>
#include <limits>

#include "core/units.h"
#include "verify/facts/chapters.h"
#include "verify/facts/closed_forms.h"
#include "verify/facts/scene_text.h"
#include "verify/facts/tree_paths.h"

namespace pol::verify {

namespace {

constexpr double n_plate = 1.5;
constexpr double thickness = 0.1;
const double plate_brewster = std::atan(n_plate);

const Tolerance many_surfaces = rounding(200.0, "20 surfaces");

/// `count` wide horizontal plates under the camera, 0.1 thick and 0.1 apart, over an unpolarized lamp of radiance 1.
/// So wide that a ray has lost all its energy long before it comes to the side of a plate.
std::string pile(int count, double i, const std::string& settings) {
    std::string yaml = camera_along(downward(i)) + picture(settings) + "media: {glass: " + text(n_plate) +
                       "}\nobjects:\n" + lamp("lamp", {0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}, 1000.0);
    for (int k = 0; k < count; ++k)
        yaml += box("plate " + std::to_string(k), {400.0, 400.0, thickness}, {0.0, 0.0, -thickness * (0.5 + 2.0 * k)},
                    "glass");
    return yaml;
}

std::string plates_text(int count) {
    return std::to_string(count) + (count == 1 ? " plate" : " plates");
}

Fact straight_path_through_pile() {
    Fact fact{"T4", "N plates at Brewster's angle polarize the straight path by the product of their 2 N faces.",
              "Fresnel: T_s = (2n/(1 + n^2))^2 per face, T_p = 1"};
    for (const int count : {1, 2, 5, 10}) {
        // The straight path is the heaviest at every step, so a small budget reaches its end.
        const std::size_t view = add_view(fact, plates_text(count), pile(count, plate_brewster, "node_budget: 200"));
        const double t_s = std::pow(2.0 * n_plate / (1.0 + n_plate * n_plate), 4.0 * count);
        const std::string straight(2 * static_cast<std::size_t>(count), 'T');
        expect(fact, view, "degree of polarization", dop_of(1.0, t_s), many_surfaces, along(straight, dop));
        expect(fact, view, "transmittance of s", t_s, many_surfaces, along(straight, s_share));
    }
    return fact;
}

Fact all_passes_through_pile() {
    Fact fact{"T5", "With all passes to and fro the pile polarizes less: P = N/(N + (2n/(n^2 - 1))^2).", "Stokes 1862"};
    struct Cut {
        int count;
        double residual;
        const char* settings;
    };
    // Of more than two plates the tree is too large to be followed to its end.
    for (const Cut& cut : {Cut{1, 1e-13, "residual: 1e-13"}, Cut{2, 1e-6, "residual: 1e-6, node_budget: 100000"}}) {
        const std::size_t view = add_view(fact, plates_text(cut.count), pile(cut.count, plate_brewster, cut.settings));
        const double spread = std::pow(2.0 * n_plate / (n_plate * n_plate - 1.0), 2);
        // P falls by at most (1 + P)/S0 < 2.6 per missing S0.
        expect(fact, view, "degree of polarization", cut.count / (cut.count + spread),
               residual_bound(cut.residual, 2.6, many_surfaces), of_pixel(dop));
        expect(fact, view, "transmittance of p", 1.0, many_surfaces, of_pixel(p_share));
    }
    return fact;
}

Fact plate_by_angle() {
    Fact fact{"T6", "A plate polarizes more along the straight path than with all passes, at any angle.",
              "Fresnel; all passes (1 - R)/(1 + R) per polarization"};
    for (const double angle : {30.0, 60.0, 75.0}) {
        const ClosedFresnel f(n_plate, radians(angle));
        const std::string name = std::to_string(static_cast<int>(angle)) + " degrees";
        const std::size_t view = add_view(fact, name, pile(1, radians(angle), "residual: 1e-13"));
        expect(fact, view, "degree of polarization, straight path",
               dop_of(std::pow(1.0 - f.R_s(), 2), std::pow(1.0 - f.R_p(), 2)), many_surfaces, along("TT", dop));
        expect(fact, view, "degree of polarization, all passes",
               dop_of(pile_transmittance(1, f.R_s()), pile_transmittance(1, f.R_p())),
               residual_bound(1e-13, 3.0, many_surfaces), of_pixel(dop));
    }
    return fact;
}

Fact plate_head_on() {
    Fact fact{"T7", "A glass plate passes 12/13 at normal incidence, unpolarized.", "T = 2n/(n^2 + 1), all passes"};
    const std::size_t view = add_view(fact, "", pile(1, 0.0, "residual: 1e-13"));
    const Tolerance tolerance = residual_bound(1e-13, 1.0, many_surfaces);
    expect(fact, view, "transmittance", plate_transmittance(n_plate), tolerance, of_pixel(s0));
    expect(fact, view, "degree of polarization", 0.0, many_surfaces, of_pixel(dop));
    return fact;
}

Fact lateral_shift() {
    Fact fact{"T8", "A plate at 45 degrees shifts a ray sideways by a third of its thickness and keeps its direction.",
              "Snell: sin(i - t)/cos t"};
    const double i = radians(45.0);
    const std::size_t view = add_view(fact, "", pile(1, i, "residual: 1e-3"));
    const double inside = std::asin(std::sin(i) / n_plate);
    expect(fact, view, "shift over thickness", std::sin(i - inside) / std::cos(inside),
           rounding(20.0 / thickness, "points 5 from the ray's origin, over the thickness"), [](const Explanation& e) {
               const auto branches = path(e, "TT");
               if (branches.empty()) return std::numeric_limits<double>::quiet_NaN();
               const DVec3 in = branches[0]->start.wave.ray;
               const DVec3 along = branches[2]->start.origin - branches[1]->start.origin;
               return std::sqrt(length2(along - dot(along, in) * in)) / thickness;
           });
    expect(fact, view, "angle between exit and entry", 0.0, rounding(8.0, "a direction"), [](const Explanation& e) {
        const auto branches = path(e, "TT");
        if (branches.empty()) return std::numeric_limits<double>::quiet_NaN();
        return angle_between(branches[0]->start.wave.ray, branches[2]->start.wave.ray);
    });
    return fact;
}

Fact plate_in_a_furnace() {
    Fact fact{"T14", "In uniform surroundings glass lacks what a depth limit cuts off, and is invisible without one.",
              "1 - (1 - R) R^(D-1) per polarization, R of the local angle"};
    const double degree = 60.0;
    const ClosedFresnel f(n_plate, radians(degree));
    const std::pair<std::string, std::string> objects[] = {
        {"plate", box("plate", {4000.0, 4000.0, 0.1}, {0.0, 0.0, -0.05}, "glass")},
        {"ball",
         "  - {name: ball, shape: {sphere: {radius: 1}}, transform: [{translate: [0, 0, -1]}], medium: glass}\n"}};
    for (const auto& [name, object] : objects) {
        const auto scene = [&, &object = object](int depth) {
            return camera_along(downward(radians(degree))) + picture("depth: " + std::to_string(depth)) +
                   "background: 1\nmedia: {glass: 1.5}\nobjects:\n" + object;
        };
        for (const int depth : {1, 2, 5}) {
            const std::string title = name + ", depth " + std::to_string(depth);
            const std::size_t view = add_view(fact, title, scene(depth));
            const auto seen = [&](double r) { return 1.0 - (1.0 - r) * std::pow(r, depth - 1); };
            expect(fact, view, "light of s", seen(f.R_s()), many_surfaces, of_pixel(s_share));
            expect(fact, view, "light of p", seen(f.R_p()), many_surfaces, of_pixel(p_share));
        }
        // R^D of s, R = 0.18, is below 1e-16 for D = 60; the paths are few: one leaf per surface.
        const std::size_t view = add_view(fact, name + ", depth 60", scene(60));
        expect(fact, view, "radiance", 1.0, many_surfaces, of_pixel(s0));
        expect(fact, view, "degree of polarization", 0.0, many_surfaces, of_pixel(dop));
    }
    return fact;
}

}  // namespace

std::vector<Fact> plate_facts() {
    return {straight_path_through_pile(), all_passes_through_pile(), plate_by_angle(), plate_head_on(), lateral_shift(),
            plate_in_a_furnace()};
}

}  // namespace pol::verify
