// SPDX-License-Identifier: Apache-2.0
#include "tracer/explain.h"

#include <algorithm>
#include <cmath>

#include "tracer/sample_task.h"
#include "tracer/trace_sample.h"

namespace pol {

namespace {

constexpr std::size_t branches_between_questions = 256;

const Dielectric<double>& medium_of(const Plan& plan, int group, int region) {
    const auto medium = static_cast<std::size_t>(plan.regions[static_cast<std::size_t>(region)].medium);
    return plan.groups[static_cast<std::size_t>(group)].media[medium].dielectric;
}

/// Index of a wavelength among those of its group.
std::size_t place_in_group(const WavelengthGroup& group, int wavelength) {
    const std::vector<int>& members = group.wavelengths;
    return static_cast<std::size_t>(std::find(members.begin(), members.end(), wavelength) - members.begin());
}

/// `node` as if the camera looked straight at it: the kernel's functions then give the light on it and the single step.
Node with_unit_throughput(Node node) {
    node.throughput = Throughput<double>::identity();
    if (node.wave.kind != WaveKind::pair) node.throughput.m[1][1] = Complex<double>(0.0);
    return node;
}

/// Share of the weight that absorption leaves between the start of a branch and its end.
double kept(const RayTreeNode& node) {
    return node.start.weight > 0.0 ? node.end.weight / node.start.weight : 0.0;
}

/// The step at the end of `parent` once more, with M = 1: its branches carry the matrices from their starts to the end
/// of the parent, in the kernel's frames.
void repeat_step(const Plan& plan, int group, const RayTreeNode& parent, Branches& branches) {
    const Node node = with_unit_throughput(parent.end);
    if (!plan.is_solid(parent.crossing.body)) {
        const auto& role = std::get<SheetRole>(plan.surface(parent.crossing.body).role);
        branches.clear();
        branches.node[0] = through_sheet(node, role.sheet, parent.crossing.normal, {});
        branches.count = 1;
        return;
    }
    const FarSide far = far_side(plan, node.region, parent.crossing, node.origin);
    const double sense = dot(parent.crossing.normal, node.wave.ray) < 0.0 ? -1.0 : 1.0;
    cross_boundary(node, medium_of(plan, group, node.region), medium_of(plan, group, far.region),
                   parent.crossing.normal * sense, branches);
}

/// The branch of the step that `child` is: there are none or one of a kind.
const Node* same_branch(const Branches& branches, const RayTreeNode& child) {
    for (int i = 0; i < branches.count; ++i) {
        const bool reflected = branches.side[i] == Side::reflected;
        if (child.interaction == Interaction::sheet || (reflected == (child.interaction == Interaction::reflected) &&
                                                        branches.node[i].wave.k == child.start.wave.k))
            return &branches.node[i];
    }
    return nullptr;
}

/// Light that the branches of `parent` bring to its start. `branches` is scratch.
CoherenceMatrix<double> light_of_children(const Plan& plan, const Explanation& explanation, const RayTreeNode& parent,
                                          Branches& branches) {
    CoherenceMatrix<double> sum;
    if (parent.children.empty()) return sum;
    repeat_step(plan, explanation.task.group, parent, branches);
    for (const int index : parent.children) {
        const RayTreeNode& child = explanation.tree.nodes[static_cast<std::size_t>(index)];
        const Node* branch = same_branch(branches, child);
        if (child.estimated || branch == nullptr) continue;
        Throughput<double> step = in_frame_of_light(*branch).throughput;
        step.scale(std::sqrt(kept(parent)));
        CoherenceMatrix<double> light = *child.arriving;
        if (child.start.wave.kind != WaveKind::pair) light = {trace(light), 0.0, {}};
        sum += to_coherence(step.gather(light));
    }
    return sum;
}

/// Children are born after their parents, so one sweep from the back gathers the light. False: not wanted any more.
bool gather(const Plan& plan, Explanation& explanation, const KeepGoing& keep_going) {
    RayTree& tree = explanation.tree;
    Branches branches;
    std::size_t done = 0;
    for (auto node = tree.nodes.rbegin(); node != tree.nodes.rend(); ++node) {
        if (++done % branches_between_questions == 0 && !keep_going(tree.nodes.size())) return false;
        node->share += node->light;
        for (const int child : node->children) node->share += tree.nodes[static_cast<std::size_t>(child)].share;
        if (node->estimated) continue;
        node->arriving = node->reason ? kept(*node) * leaf_source(plan, explanation, *node, node->end.wave)
                                      : light_of_children(plan, explanation, *node, branches);
        if (plan.settings.unpolarized) node->arriving = CoherenceMatrix<double>::unpolarized(trace(*node->arriving));
    }
    return true;
}

}  // namespace

CoherenceMatrix<double> leaf_source(const Plan& plan, const Explanation& explanation, const RayTreeNode& leaf,
                                    const Wave<double>& wave) {
    const int index = explanation.task.group;
    const WavelengthGroup& group = plan.groups[static_cast<std::size_t>(index)];
    Node node = leaf.end;
    node.wave = wave;
    node = with_unit_throughput(node);
    std::vector<Stokes<double>> light(group.wavelengths.size());
    const double camera_n = medium_of(plan, index, explanation.task.region).n;
    if (leaf.reason == LeafReason::background) {
        background_light(plan, group, node, camera_n, light);
    } else if (leaf.reason == LeafReason::emitter) {
        const auto& role = std::get<EmitterRole>(plan.surface(leaf.crossing.body).role);
        emitter_light(plan, index, plan.emitters[static_cast<std::size_t>(role.emitter)], node, leaf.crossing, camera_n,
                      light);
    }
    return to_coherence(light[place_in_group(group, explanation.wavelength)]);
}

std::optional<Explanation> explain(const Plan& plan, int x, int y, std::uint32_t sample, int wavelength,
                                   const KeepGoing& keep_going) {
    POL_EXPECTS(x >= 0 && y >= 0 && x < plan.settings.width && y < plan.settings.height);
    Explanation out;
    out.x = x;
    out.y = y;
    out.sample = sample;
    out.wavelength = wavelength;
    const int group = plan.group_of_wavelength[static_cast<std::size_t>(wavelength)];
    const WavelengthGroup& wavelengths = plan.groups[static_cast<std::size_t>(group)];
    const std::size_t place = place_in_group(wavelengths, wavelength);
    out.task = sample_task(plan, x, y, sample, group);

    TreeRecorder recorder(place, keep_going);
    std::vector<Stokes<double>> sums(wavelengths.wavelengths.size());
    out.result = with_kernel(
        plan, [&](auto plan_for_kernel) { return Tracer(plan_for_kernel, recorder).trace(out.task, sums); });
    if (out.result.cancelled) return std::nullopt;
    out.tree = std::move(recorder.tree);
    if (!gather(plan, out, keep_going)) return std::nullopt;

    const std::size_t branches = out.tree.nodes.size();
    sums.assign(wavelengths.wavelengths.size(), {});
    if (trace_sample(plan, out.task, sums, [&](std::size_t) { return keep_going(branches); }).cancelled)
        return std::nullopt;
    out.sample_light = sums[place];
    for (const int leaf : out.tree.leaves) {
        const RayTreeNode& node = out.tree.nodes[static_cast<std::size_t>(leaf)];
        if (node.brings_light()) out.leaf_sum += node.light;
    }
    return out;
}

Explanation explain(const Plan& plan, int x, int y, std::uint32_t sample, int wavelength) {
    return *explain(plan, x, y, sample, wavelength, [](std::size_t) { return true; });
}

}  // namespace pol
