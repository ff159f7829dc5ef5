// SPDX-License-Identifier: Apache-2.0
// Trees of one pixel that end on a lamp of a known state, behind plates, mirrors, crystals and sheets, with the closed
// form of the light on their branches.
#pragma once

#include <string>
#include <vector>

#include "physics/crystal_scene.h"

namespace pol::test {

/// Light that arrives at the start of the branch `route` (verify::find_branch), in the right-handed frame about it
/// whose x axis is `x`.
struct BranchLight {
    std::string route;
    Stokes<double> light;
    DVec3 x{};
};

struct LitTree {
    std::string name;
    std::string yaml;
    std::vector<BranchLight> branches;
};

/// At most four surfaces and the turn of a frame, of which each is good to surface_rounding.
constexpr double lit_rounding = 5.0 * surface_rounding;

/// The six states of the sphere's axes and a partially polarized ellipse, S0 = 1.
inline const std::vector<Stokes<double>>& six_states_and_one() {
    static const std::vector<Stokes<double>> states{{1.0, 1.0, 0.0, 0.0},  {1.0, -1.0, 0.0, 0.0}, {1.0, 0.0, 1.0, 0.0},
                                                    {1.0, 0.0, -1.0, 0.0}, {1.0, 0.0, 0.0, 1.0},  {1.0, 0.0, 0.0, -1.0},
                                                    {1.0, 0.3, -0.4, 0.5}};
    return states;
}

/// Light whose s and p fields are multiplied by a and b.
inline Stokes<double> multiplied(const Stokes<double>& s, const Complex<double>& a, const Complex<double>& b) {
    return to_stokes(transform(JonesMatrix<double>{{{a, {}}, {{}, b}}}, to_coherence(s)));
}

/// Amplitudes t_s, t_p of the energy that passes a surface between lossless isotropic media: positive and real.
inline Stokes<double> passed(const Stokes<double>& s, const ClosedFresnel& f) {
    return multiplied(s, std::sqrt(1.0 - f.R_s()), std::sqrt(1.0 - f.R_p()));
}

inline Stokes<double> mirrored(const Stokes<double>& s, const ClosedFresnel& f) {
    return multiplied(s, f.r_s, f.r_p);
}

/// All trees of a lamp in the state `s`. Trees are cut where their light would come to and fro.
inline std::vector<LitTree> lit_trees(const Stokes<double>& s) {
    const std::string state = polarized("[" + text(s.s1) + ", " + text(s.s2) + ", " + text(s.s3) + "]");
    const auto cut_after = [](int depth) { return "render: {depth: " + std::to_string(depth) + ", residual: 0}\n"; };
    const DVec3 y(0.0, -1.0, 0.0);  // x axis of cameras and lamps, s of all surfaces across the plane y = 0
    const auto below = [&](const std::string& emission) {
        return lamp("lamp", {0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}, 40.0, emission);
    };
    std::vector<LitTree> trees;

    for (const double i : {0.0, radians(50.0)}) {
        const ClosedFresnel f(1.5, i);
        trees.push_back({"glass plate at " + text(degrees(i)),
                         camera_along(downward(i)) + cut_after(2) + "media: {glass: 1.5}\nobjects:\n" +
                             plate("plate", "glass") + below(state),
                         {{"", passed(passed(s, f), f), y}, {"T", passed(s, f), y}, {"T T", s, y}}});
    }
    // Below and above Brewster's angle, and a metal.
    const auto mirror = [&](const std::string& name, const std::string& medium, const ClosedFresnel& f, double i) {
        trees.push_back({name,
                         camera_along(downward(i)) + cut_after(1) + "media: {stuff: " + medium + "}\nobjects:\n" +
                             deep_block("stuff") + lamp("lamp", upward(i) * 10.0, -upward(i), std::cos(i), state),
                         {{"", mirrored(s, f), y}, {"R", s, y}}});
    };
    mirror("glass mirror at 30", "1.5", ClosedFresnel(1.5, radians(30.0)), radians(30.0));
    mirror("glass mirror at 70", "1.5", ClosedFresnel(1.5, radians(70.0)), radians(70.0));
    mirror("metal mirror", "{conductor: [0.6, 2.1]}", ClosedFresnel({0.6, 2.1}, radians(40.0)), radians(40.0));

    // A prism that turns the light by 90 degrees: in and out along the normals, once totally reflected.
    const ClosedFresnel in(1.5, 0.0);
    const ClosedFresnel total(1.0 / 1.5, radians(45.0));
    const DVec3 z(0.0, 0.0, 1.0);
    trees.push_back({"prism with total reflection",
                     verify::camera_in_plane({1.0, 0.0, 0.0}, {0.0, 0.5, 0.0}) + cut_after(3) +
                         "media: {glass: 1.5}\nobjects:\n" +
                         extruded("prism", {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}, "glass") +
                         "  - {name: lamp, shape: {rectangle: {size: 2}}, " +
                         placed({0.5, -3.0, 0.0}, {0.0, 1.0, 0.0}, z) + ", emission: {" + state + "}}\n",
                     {{"", passed(mirrored(passed(s, in), total), in), z},
                      {"T", mirrored(passed(s, in), total), z},
                      {"T R", passed(s, in), z},
                      {"T R T", s, z}}});

    // Calcite seen along its axis has pairs as glass has; across it each mode is linear along its own field.
    const ClosedFresnel along_axis(n_o, 0.0);
    trees.push_back(
        {"calcite along its axis",
         camera_along(downward(0.0)) + cut_after(2) + "media: {crystal: " + calcite(z) + "}\nobjects:\n" +
             plate("plate", "crystal") + below(state),
         {{"", passed(passed(s, along_axis), along_axis), y}, {"T", passed(s, along_axis), y}, {"T T", s, y}}});
    const double azimuth = radians(25.0);  // of the optic axis, from the lamp's x = -y towards its y, for the receiver
    const DVec3 axis(std::sin(azimuth), -std::cos(azimuth), 0.0);
    const auto along = [&](double angle) {  // power along a line, of light of S0 = 1 in the lamp's frame
        return 0.5 * (s.s0 + s.s1 * std::cos(2.0 * angle) + s.s2 * std::sin(2.0 * angle));
    };
    const double e = (1.0 - normal_reflectance(n_e)) * along(azimuth);
    const double o = (1.0 - normal_reflectance(n_o)) * along(azimuth + 0.5 * pi);
    trees.push_back(
        {"calcite across its axis",
         camera_along(downward(0.0)) + cut_after(2) + "media: {crystal: " + calcite(axis) + "}\nobjects:\n" +
             plate("plate", "crystal") + below(state),
         {{"Te", {e, e, 0.0, 0.0}, axis}, {"To", {o, o, 0.0, 0.0}, cross(z, axis)}, {"To T", s, y}, {"Te T", s, y}}});
    trees.push_back({"calcite askew",
                     camera_along(downward(radians(40.0))) + cut_after(2) +
                         "media: {crystal: " + calcite(unit(DVec3(1.0, 2.0, 3.0))) + "}\nobjects:\n" +
                         plate("plate", "crystal") + below(state),
                     {{"To T", s, y}, {"Te T", s, y}}});

    // Sheets keep the frame of the branch before them. The slow axis lags: E_y gains exp(i retardance).
    const auto sheet = [](const std::string& what) {
        return "  - {name: sheet, shape: {disk: {radius: 9}}, transform: [{translate: [0, 0, -3]}], sheet: {" + what +
               "}}\n";
    };
    const Stokes<double> retarded = multiplied(s, 1.0, unit_phase(radians(70.0)));
    const std::string retarder = sheet("retarder: {fast_axis: [0, 1, 0], retardance: 70}");
    const std::string straight = camera_along(downward(0.0));
    trees.push_back({"retarder",
                     straight + cut_after(1) + "objects:\n" + retarder + below(state),
                     {{"", retarded, y}, {"S", s, y}}});
    trees.push_back({"retarder behind glass",
                     straight + cut_after(3) + "media: {glass: 1.5}\nobjects:\n" + plate("plate", "glass") + retarder +
                         below(state),
                     {{"", passed(passed(retarded, in), in), y},
                      {"T", passed(retarded, in), y},
                      {"T T", retarded, y},
                      {"T T S", s, y}}});
    const double right = 0.5 * (s.s0 + s.s3);
    const Stokes<double> circular{right, 0.0, 0.0, right};
    trees.push_back({"circular polarizer behind glass",
                     straight + cut_after(3) + "media: {glass: 1.5}\nobjects:\n" + plate("plate", "glass") +
                         sheet("circular: {passes: right}") + below(state),
                     {{"", passed(passed(circular, in), in), y},
                      {"T", passed(circular, in), y},
                      {"T T", circular, y},
                      {"T T S", s, y}}});
    return trees;
}

/// The light on a branch, given in its right-handed frame with the axes e1 and e2, in the frame whose x axis is `x`.
inline Stokes<double> seen_from(const Stokes<double>& light, const DVec3& e1, const DVec3& e2, const DVec3& x) {
    return rotate_basis(light, std::atan2(dot(x, e2), dot(x, e1)));
}

/// Calls check(plan, explanation, index of the branch, BranchLight) for every branch of every tree and state.
template <class Check>
void for_each_lit_branch(const Check& check) {
    for (const Stokes<double>& state : six_states_and_one()) {
        for (const LitTree& tree : lit_trees(state)) {
            SCOPED_TRACE(tree.name + " S1 " + text(state.s1) + " S2 " + text(state.s2) + " S3 " + text(state.s3));
            Scene scene = scene_of(tree.yaml);
            scene.render.width = scene.render.height = 1;
            const auto plan = plan_of(scene);
            const Explanation e = explain(*plan, 0, 0, 0, 0);
            for (const BranchLight& expected : tree.branches) {
                SCOPED_TRACE("branch '" + expected.route + "'");
                check(*plan, e, static_cast<int>(&branch(e, expected.route) - e.tree.nodes.data()), expected);
            }
        }
    }
}

}  // namespace pol::test
