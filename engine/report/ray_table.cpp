// SPDX-License-Identifier: Apache-2.0
#include "report/ray_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "core/number_text.h"
#include "core/units.h"
#include "tracer/tree_names.h"

namespace pol {

namespace {

using Number = std::optional<double>;

/// Without the two, a column would need a name for every member that it shows.
template <auto get>
constexpr RayTable::Column number(std::string_view name, std::string_view help) {
    return {name, help, [](const RayTable& t, int i) -> Number { return get(t, i); }, nullptr};
}
template <auto get>
constexpr RayTable::Column text(std::string_view name, std::string_view help) {
    return {name, help, nullptr, [](const RayTable& t, int i) -> std::string { return get(t, i); }};
}

Number if_arrived(const RayTable& t, int i, double value) {
    return t.node(i).arrived ? Number(value) : std::nullopt;
}

template <int axis>
Number end_point(const RayTable& t, int i) {
    return if_arrived(t, i, t.node(i).end.origin[axis]);
}
template <int axis>
Number ray(const RayTable& t, int i) {
    return t.node(i).start.wave.ray[axis];
}
template <int axis>
Number wave_vector(const RayTable& t, int i) {
    return t.node(i).start.wave.k[axis];
}
template <int which, int axis>
Number field(const RayTable& t, int i) {
    return t.node(i).start.wave.field[which][axis];
}
template <int row, int mode, bool imaginary>
Number matrix(const RayTable& t, int i) {
    const Node& start = t.node(i).start;
    if (mode >= start.wave.mode_count()) return std::nullopt;
    const Complex<double>& m = start.throughput.m[row][mode];
    return imaginary ? m.im : m.re;
}
template <double Stokes<double>::*component>
Number share(const RayTable& t, int i) {
    return t.node(i).share.*component;
}
template <double Stokes<double>::*component>
Number arriving(const RayTable& t, int i) {
    const RayTreeNode& node = t.node(i);
    return node.arriving ? Number(to_stokes(*node.arriving).*component) : std::nullopt;
}

constexpr auto parent = [](const RayTable& t, int i) { return Number(t.node(i).parent); };
constexpr auto itself = [](const RayTable&, int i) { return Number(i); };
constexpr auto interaction = [](const RayTable& t, int i) -> std::string {
    return interaction_of(t.plan, t.explanation, i);
};
constexpr auto surface = [](const RayTable& t, int i) -> std::string {
    return t.node(i).arrived ? t.plan.body_name(t.node(i).crossing.body) : std::string();
};
constexpr auto facet = [](const RayTable& t, int i) { return if_arrived(t, i, t.node(i).crossing.facet); };
constexpr auto medium = [](const RayTable& t, int i) { return medium_name(t.plan, t.node(i).start.region); };
constexpr auto mode = [](const RayTable& t, int i) { return std::string(mode_of(t.node(i).start.wave)); };
constexpr auto index = [](const RayTable& t, int i) { return Number(index_of(t.node(i))); };
constexpr auto angle = [](const RayTable& t, int i) { return if_arrived(t, i, degrees(t.node(i).angle)); };
constexpr auto weight = [](const RayTable& t, int i) { return Number(t.node(i).start.weight); };
constexpr auto path = [](const RayTable& t, int i) { return t.optical_path(i); };
constexpr auto ended = [](const RayTable& t, int i) {
    return std::string(t.node(i).reason ? name_of(*t.node(i).reason) : "");
};

using S = Stokes<double>;

constexpr std::array table{
    number<itself>("#", "Branch, in order of discovery; 0 is the camera ray"),
    number<parent>("parent", "Branch that it grew from"),
    text<interaction>("interaction", "How the branch came to be"),
    text<surface>("surface", "Object that it meets"),
    number<facet>("facet", "Facet of that object"),
    number<end_point<0>>("X", "Point where it ends, scene units"),
    number<end_point<1>>("Y", "Point where it ends, scene units"),
    number<end_point<2>>("Z", "Point where it ends, scene units"),
    number<ray<0>>("L", "Unit direction of the backward ray (energy), x"),
    number<ray<1>>("M", "Unit direction of the backward ray (energy), y"),
    number<ray<2>>("N", "Unit direction of the backward ray (energy), z"),
    number<wave_vector<0>>("k_x", "Wave vector of the backward ray in units of omega/c"),
    number<wave_vector<1>>("k_y", "Wave vector of the backward ray in units of omega/c"),
    number<wave_vector<2>>("k_z", "Wave vector of the backward ray in units of omega/c"),
    number<index>("n", "Refractive index that it sees, |k|"),
    text<medium>("medium", "Medium that it goes through"),
    text<mode>("mode", "s/p: both polarizations; o, e: one mode of a crystal"),
    number<angle>("angle_deg", "Angle of incidence where it ends, degrees"),
    number<weight>("weight", "Share of the pixel that unpolarized light on it can bring, at its start"),
    number<share<&S::s0>>("share_S0", "What it and all that grew from it bring to the pixel, in the pixel's frame"),
    number<share<&S::s1>>("share_S1", "What it and all that grew from it bring to the pixel, in the pixel's frame"),
    number<share<&S::s2>>("share_S2", "What it and all that grew from it bring to the pixel, in the pixel's frame"),
    number<share<&S::s3>>("share_S3", "What it and all that grew from it bring to the pixel, in the pixel's frame"),
    number<arriving<&S::s0>>("light_S0",
                             "Light that arrives at its start, on its way to the camera, in the frame E1, E2"),
    number<arriving<&S::s1>>("light_S1",
                             "Light that arrives at its start, on its way to the camera, in the frame E1, E2"),
    number<arriving<&S::s2>>("light_S2",
                             "Light that arrives at its start, on its way to the camera, in the frame E1, E2"),
    number<arriving<&S::s3>>("light_S3",
                             "Light that arrives at its start, on its way to the camera, in the frame E1, E2"),
    number<path>("OPL", "Optical path from the camera to its end, sum of k . dr, scene units"),
    number<field<0, 0>>("E1_x", "x axis of the light's right-handed frame E1, E2, -(L, M, N): s, or a mode's field"),
    number<field<0, 1>>("E1_y", "x axis of the light's right-handed frame E1, E2, -(L, M, N): s, or a mode's field"),
    number<field<0, 2>>("E1_z", "x axis of the light's right-handed frame E1, E2, -(L, M, N): s, or a mode's field"),
    number<field<1, 0>>("E2_x", "y axis of the light's right-handed frame E1, E2, -(L, M, N): p"),
    number<field<1, 1>>("E2_y", "y axis of the light's right-handed frame E1, E2, -(L, M, N): p"),
    number<field<1, 2>>("E2_z", "y axis of the light's right-handed frame E1, E2, -(L, M, N): p"),
    number<matrix<0, 0, false>>("M_x1_re", "Matrix from E1, E2 to the camera's x, y"),
    number<matrix<0, 0, true>>("M_x1_im", "Matrix from E1, E2 to the camera's x, y"),
    number<matrix<1, 0, false>>("M_y1_re", "Matrix from E1, E2 to the camera's x, y"),
    number<matrix<1, 0, true>>("M_y1_im", "Matrix from E1, E2 to the camera's x, y"),
    number<matrix<0, 1, false>>("M_x2_re", "Matrix from E1, E2 to the camera's x, y"),
    number<matrix<0, 1, true>>("M_x2_im", "Matrix from E1, E2 to the camera's x, y"),
    number<matrix<1, 1, false>>("M_y2_re", "Matrix from E1, E2 to the camera's x, y"),
    number<matrix<1, 1, true>>("M_y2_im", "Matrix from E1, E2 to the camera's x, y"),
    text<ended>("ended", "Why it ended; empty: it branched"),
};

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

/// A blank would begin another name.
std::string obj_group(PathKind kind) {
    std::string name = name_of(kind);
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

}  // namespace

RayTable::RayTable(const Plan& the_plan, const Explanation& the_explanation)
    : plan(the_plan), explanation(the_explanation) {
    optical_path_.reserve(explanation.tree.nodes.size());
    for (const RayTreeNode& node : explanation.tree.nodes) {
        const double before = node.parent < 0 ? 0.0 : optical_path_[static_cast<std::size_t>(node.parent)];
        optical_path_.push_back(before + dot(node.start.wave.k, node.end.origin - node.start.origin));
    }
}

std::span<const RayTable::Column> RayTable::columns() {
    return table;
}

std::optional<double> RayTable::optical_path(int branch) const {
    return if_arrived(*this, branch, optical_path_[static_cast<std::size_t>(branch)]);
}

std::string ray_table_as_csv(const Plan& plan, const Explanation& explanation) {
    const RayTable rays(plan, explanation);
    std::string out;
    for (const RayTable::Column& column : table)
        out += std::string(&column == table.data() ? "" : ",") + std::string(column.name);
    for (int i = 0; i < rays.size(); ++i) {
        out += "\r\n";
        for (const RayTable::Column& column : table) {
            if (&column != table.data()) out += ',';
            if (column.text != nullptr)
                out += csv_field(column.text(rays, i));
            else if (const auto value = column.number(rays, i))
                out += number_text(*value);
        }
    }
    return out + "\r\n";
}

std::string paths_as_obj(const Plan& plan, const Explanation& explanation) {
    const std::vector<RayTreeNode>& nodes = explanation.tree.nodes;
    std::string out;
    auto to = std::back_inserter(out);
    fmt::format_to(to, "# backward paths of pixel {},{} sample {} at {} nm\n", explanation.x, explanation.y,
                   explanation.sample, plan.wavelengths_nm[static_cast<std::size_t>(explanation.wavelength)]);
    // Vertex 1 is the camera, vertex i + 2 the end of branch i.
    const auto vertex = [&](const DVec3& p) {
        fmt::format_to(to, "v {} {} {}\n", number_text(p.x), number_text(p.y), number_text(p.z));
    };
    vertex(explanation.task.ray.origin);
    for (const RayTreeNode& node : nodes)
        vertex(node.arrived ? node.end.origin : node.start.origin + node.start.wave.ray * plan.length_scale);
    for (const PathKind kind : all_path_kinds) {
        bool open = false;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (kind_of(nodes[i]) != kind) continue;
            if (!open) fmt::format_to(to, "g {}\n", obj_group(kind));
            open = true;
            fmt::format_to(to, "l {} {}\n", nodes[i].parent + 2, i + 2);
        }
    }
    return out;
}

}  // namespace pol
