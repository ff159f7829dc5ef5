// SPDX-License-Identifier: Apache-2.0
#include "tracer/explain.h"

#include <algorithm>
#include <cmath>

#include "tracer/observers.h"
#include "tracer/sample_task.h"

namespace pol {

namespace {

template <class Observer>
TraceResult trace_with(const Plan& plan, const TraceTask& task, Observer& observer, std::span<Stokes<double>> sums) {
    const auto run = [&]<bool anisotropic, bool absorbing>() {
        return Tracer<anisotropic, absorbing, Observer>(plan, observer).trace(task, sums);
    };
    if (plan.features.anisotropic)
        return plan.features.absorbing ? run.template operator()<true, true>() : run.template operator()<true, false>();
    return plan.features.absorbing ? run.template operator()<false, true>() : run.template operator()<false, false>();
}

/// Silent, but for asking whether anybody still waits.
struct Patient : Silent {
    const KeepGoing& keep_going;
    std::size_t branches = 0;
    [[nodiscard]] bool cancelled() const { return !keep_going(branches); }
};

constexpr std::size_t branches_between_questions = 256;

/// What the sweep over a finished tree needs to know.
struct Gathering {
    const Plan& plan;
    const TraceTask& task;
    std::size_t place;  ///< of the wavelength in its group
    const WavelengthGroup& group = plan.groups[static_cast<std::size_t>(task.group)];

    [[nodiscard]] const Dielectric<double>& medium(int region) const {
        return group.media[static_cast<std::size_t>(plan.regions[static_cast<std::size_t>(region)].medium)].dielectric;
    }
};

/// `node` as if the camera looked straight at it: the kernel's functions then give the light on it and the single step.
Node with_unit_throughput(Node node) {
    node.throughput = Throughput::identity();
    if (node.wave.kind != WaveKind::pair) node.throughput.m[1][1] = Complex<double>(0.0);
    return node;
}

/// Share of the weight that absorption leaves between the start of a branch and its end.
double kept(const RayTreeNode& node) {
    return node.start.weight > 0.0 ? node.end.weight / node.start.weight : 0.0;
}

/// Light that a leaf hands to its start: the emitter's coherence matrix in the field basis, absorption included.
CoherenceMatrix<double> leaf_source(const Gathering& g, const RayTreeNode& leaf) {
    const Node node = with_unit_throughput(leaf.end);
    std::vector<Stokes<double>> light(g.group.wavelengths.size());
    const double camera_n = g.medium(g.task.region).n;
    if (leaf.reason == LeafReason::background) {
        background_light(g.plan, g.group, node, camera_n, light);
    } else if (leaf.reason == LeafReason::emitter) {
        const auto& role = std::get<EmitterRole>(g.plan.surface(leaf.crossing.body).role);
        emitter_light(g.plan, g.task.group, g.plan.emitters[static_cast<std::size_t>(role.emitter)], node,
                      leaf.crossing, camera_n, light);
    }
    return to_coherence(kept(leaf) * light[g.place]);
}

/// The step at the end of `parent` once more, with M = 1: its branches carry the matrices from their starts to the end
/// of the parent.
void repeat_step(const Gathering& g, const RayTreeNode& parent, Branches& branches) {
    const Node node = with_unit_throughput(parent.end);
    if (!g.plan.is_solid(parent.crossing.body)) {
        const auto& role = std::get<SheetRole>(g.plan.surface(parent.crossing.body).role);
        branches.clear();
        branches.node[0] = through_sheet(node, role.sheet, {});
        branches.count = 1;
        return;
    }
    const FarSide far = far_side(g.plan, node.region, parent.crossing, node.origin);
    const double sense = dot(parent.crossing.normal, node.wave.ray) < 0.0 ? -1.0 : 1.0;
    cross_boundary(node, g.medium(node.region), g.medium(far.region), parent.crossing.normal * sense, branches);
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
CoherenceMatrix<double> light_of_children(const Gathering& g, const RayTree& tree, const RayTreeNode& parent,
                                          Branches& branches) {
    CoherenceMatrix<double> sum;
    if (parent.children.empty()) return sum;
    repeat_step(g, parent, branches);
    for (const int index : parent.children) {
        const RayTreeNode& child = tree.nodes[static_cast<std::size_t>(index)];
        const Node* branch = same_branch(branches, child);
        if (child.estimated || branch == nullptr) continue;
        Throughput step = branch->throughput;
        step.scale(std::sqrt(kept(parent)));
        sum += to_coherence(step.gather(*child.arriving));
    }
    return sum;
}

/// The same power without its polarization; a single mode holds all of it in xx.
CoherenceMatrix<double> depolarized(const CoherenceMatrix<double>& c, WaveKind kind) {
    const double power = c.xx + c.yy;
    if (kind != WaveKind::pair) return {power, 0.0, {}};
    return CoherenceMatrix<double>::unpolarized(power);
}

/// Children are born after their parents, so one sweep from the back gathers the light. False: not wanted any more.
bool gather(const Gathering& g, RayTree& tree, const KeepGoing& keep_going) {
    Branches branches;
    std::size_t done = 0;
    for (auto node = tree.nodes.rbegin(); node != tree.nodes.rend(); ++node) {
        if (++done % branches_between_questions == 0 && !keep_going(tree.nodes.size())) return false;
        node->share += node->light;
        for (const int child : node->children) node->share += tree.nodes[static_cast<std::size_t>(child)].share;
        if (node->estimated) continue;
        node->arriving = node->reason ? leaf_source(g, *node) : light_of_children(g, tree, *node, branches);
        if (g.plan.settings.unpolarized) node->arriving = depolarized(*node->arriving, node->start.wave.kind);
    }
    return true;
}

}  // namespace

std::optional<Explanation> explain(const Plan& plan, int x, int y, std::uint32_t sample, int wavelength,
                                   const KeepGoing& keep_going) {
    POL_EXPECTS(x >= 0 && y >= 0 && x < plan.settings.width && y < plan.settings.height);
    Explanation out;
    out.x = x;
    out.y = y;
    out.sample = sample;
    out.wavelength = wavelength;
    const int group = plan.group_of_wavelength[static_cast<std::size_t>(wavelength)];
    const std::vector<int>& members = plan.groups[static_cast<std::size_t>(group)].wavelengths;
    const auto place =
        static_cast<std::size_t>(std::find(members.begin(), members.end(), wavelength) - members.begin());
    out.task = sample_task(plan, x, y, sample, group);

    TreeRecorder recorder(place, keep_going);
    std::vector<Stokes<double>> sums(members.size());
    out.result = trace_with(plan, out.task, recorder, sums);
    if (out.result.cancelled) return std::nullopt;
    out.tree = std::move(recorder.tree);
    if (!gather({plan, out.task, place}, out.tree, keep_going)) return std::nullopt;

    Patient silent{{}, keep_going, out.tree.nodes.size()};
    sums.assign(members.size(), {});
    if (trace_with(plan, out.task, silent, sums).cancelled) return std::nullopt;
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
