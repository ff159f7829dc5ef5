// SPDX-License-Identifier: Apache-2.0
#include "viewer/pages/branch_page.h"

#include <fmt/format.h>

#include <cmath>

#include "core/units.h"
#include "tracer/tree_names.h"
#include "viewer/pages/readout_text.h"
#include "viewer/shown/convention.h"

namespace pol {

namespace {

const RayTreeNode& node_of(const Explanation& explanation, int branch) {
    return explanation.tree.nodes[static_cast<std::size_t>(branch)];
}

/// What is nothing but rounding beside `size` is shown as 0.
PageRow number(std::string name, double value, std::string_view unit, std::string_view help, double size = 0.0) {
    return {std::move(name), short_number(value, 9, size) + std::string(unit), {}, fmt::format("{:.17g}", value), help};
}

PageRow vector(std::string name, const DVec3& v, std::string_view help) {
    return {std::move(name),
            vector_text(v, glm::length(v)),
            {},
            fmt::format("({:.17g}, {:.17g}, {:.17g})", v.x, v.y, v.z),
            help};
}

PageRow complex(std::string name, const Complex<double>& z, std::string_view help, double size) {
    return {std::move(name), complex_text(z, 7, size), {}, exact_text(z), help};
}

void add_matrix(std::vector<PageRow>& rows, const RayTreeNode& node) {
    constexpr std::string_view help = "From the branch's E1, E2 to the camera's x, y";
    const auto& m = node.start.throughput.m;
    const double size = std::sqrt(norm2(m[0][0]) + norm2(m[0][1]) + norm2(m[1][0]) + norm2(m[1][1]));
    rows.push_back(complex("M x1", m[0][0], help, size));
    rows.push_back(complex("M y1", m[1][0], help, size));
    if (node.start.wave.kind != WaveKind::pair) return;
    rows.push_back(complex("M x2", m[0][1], help, size));
    rows.push_back(complex("M y2", m[1][1], help, size));
}

void add_arriving(std::vector<PageRow>& rows, const Explanation& explanation, const RayTreeNode& node) {
    constexpr std::string_view help =
        "Light that arrives at the start of the branch, on its way to the camera, in the frame E1, E2";
    if (!node.arriving) {
        rows.push_back(word_row("light", "not known on the random tail", help));
        return;
    }
    rows.push_back(
        word_row("light in", "E1, E2: " + Convention{}.text(), "Whatever convention the page of the pixel has"));
    const Stokes<double> s = to_stokes(*node.arriving);
    rows.push_back(number("light S0", s.s0, "", help));
    rows.push_back(number("light S1", s.s1, "", help, s.s0));
    rows.push_back(number("light S2", s.s2, "", help, s.s0));
    rows.push_back(number("light S3", s.s3, "", help, s.s0));
    rows.push_back(word_row("light is", handedness_of(measure_arriving(explanation, node)),
                            "Handedness: right is clockwise for who looks along the backward ray"));
    rows.push_back(number("light J11", node.arriving->xx, "", help, s.s0));
    rows.push_back(number("light J22", node.arriving->yy, "", help, s.s0));
    rows.push_back(complex("light J12", node.arriving->xy, help, s.s0));
}

}  // namespace

std::string branch_title(const Plan& plan, const Explanation& explanation, int branch, bool is_total_reflection) {
    const RayTreeNode& node = node_of(explanation, branch);
    const bool single = node.start.wave.kind != WaveKind::pair;
    return fmt::format("{}{}{} {}", name_of(node.interaction, is_total_reflection), single ? " " : "",
                       single ? mode_of(node.start.wave) : "", medium_name(plan, node.start.region));
}

std::string branch_end(const Plan& plan, const Explanation& explanation, int branch) {
    const RayTreeNode& node = node_of(explanation, branch);
    if (node.reason && (!node.arrived || is_not_followed(*node.reason))) return name_of(*node.reason);
    const std::string& met = plan.body_name(node.crossing.body);
    return node.reason || node.crossing.facet < 0 ? met : fmt::format("{} {}", met, node.crossing.facet);
}

PageGroup make_branch_page(const Plan& plan, const Explanation& explanation, int branch) {
    const RayTreeNode& node = node_of(explanation, branch);
    PageGroup group{fmt::format("Branch {}", branch), {}};
    std::vector<PageRow>& rows = group.rows;
    rows.push_back(word_row("interaction",
                            branch_title(plan, explanation, branch, is_total_reflection(plan, explanation, branch)),
                            "Interaction, mode and medium"));
    if (node.reason) rows.push_back(word_row("ended", name_of(*node.reason), help_of(*node.reason)));
    if (node.arrived) {
        rows.push_back(word_row("meets",
                                fmt::format("{}, facet {}", plan.body_name(node.crossing.body), node.crossing.facet),
                                "Object and facet"));
        rows.push_back(vector("point", node.end.origin, "Where it meets it, scene units"));
        rows.push_back(number("angle", degrees(node.angle), "\u00b0", "Of incidence, between ray and normal"));
    }
    rows.push_back(number("index", index_of(node), "", "Refractive index that it sees, |k|"));
    rows.push_back(vector("k", node.start.wave.k, "Wave vector of the backward ray in units of omega/c"));
    rows.push_back(vector("ray", node.start.wave.ray, "Direction of the backward ray (energy)"));
    rows.push_back(vector("E1", node.start.wave.field[0], "x axis of the light's frame: s, or the field of a mode"));
    rows.push_back(vector("E2", node.start.wave.field[1], "y axis of the light's frame: p"));
    rows.push_back(vector("E1 x E2", -node.start.wave.ray, "Direction of the light, against the backward ray"));
    rows.push_back(
        number("weight", node.start.weight, "", "Share of the pixel that unpolarized light on it can bring"));
    constexpr std::string_view share_help =
        "What it and all that grew from it bring to the pixel, in the pixel's frame";
    rows.push_back(number("share S0", node.share.s0, "", share_help));
    rows.push_back(number("share S1", node.share.s1, "", share_help, node.share.s0));
    rows.push_back(number("share S2", node.share.s2, "", share_help, node.share.s0));
    rows.push_back(number("share S3", node.share.s3, "", share_help, node.share.s0));
    add_matrix(rows, node);
    add_arriving(rows, explanation, node);
    if (node.estimated) rows.push_back(word_row("estimated", "random tail", "Rescaled to stand for all that was open"));
    return group;
}

}  // namespace pol
