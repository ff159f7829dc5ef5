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

/// Light that a leaf hands to its start: the emitter's coherence matrix in the field basis, absorption included.
std::vector<CoherenceMatrix<double>> leaf_source(const Plan& plan, const TraceTask& task, const RayTreeNode& leaf) {
    // The light of the leaf at the camera is M J M^H; written with M = 1 the same functions give J itself.
    Node unit_node = leaf.end;
    unit_node.throughput = Throughput::identity();
    if (unit_node.wave.kind != WaveKind::pair) unit_node.throughput.m[1][1] = Complex<double>(0.0);
    const WavelengthGroup& group = plan.groups[static_cast<std::size_t>(task.group)];
    const double kept = leaf.start.weight > 0.0 ? leaf.end.weight / leaf.start.weight : 0.0;
    const auto& camera_medium =
        group.media[static_cast<std::size_t>(plan.regions[static_cast<std::size_t>(task.region)].medium)];
    std::vector<Stokes<double>> light(group.wavelengths.size());
    if (leaf.reason == LeafReason::background) {
        background_light(plan, group, unit_node, camera_medium.dielectric.n, light);
    } else if (leaf.reason == LeafReason::emitter) {
        const auto& role = std::get<EmitterRole>(plan.surface(leaf.crossing.body).role);
        emitter_light(plan, task.group, plan.emitters[static_cast<std::size_t>(role.emitter)], unit_node, leaf.crossing,
                      camera_medium.dielectric.n, light);
    }
    std::vector<CoherenceMatrix<double>> source;
    for (const Stokes<double>& s : light) source.push_back(to_coherence(kept * s));
    return source;
}

/// Matrices of the forward steps from each child's start to its parent's start: the step repeated with M = 1.
Throughput step_matrix(const Plan& plan, const TraceTask& task, const RayTreeNode& parent, const RayTreeNode& child) {
    Node node = parent.end;
    const bool single = node.wave.kind != WaveKind::pair;
    node.throughput = Throughput::identity();
    if (single) node.throughput.m[1][1] = Complex<double>(0.0);
    const double kept = parent.start.weight > 0.0 ? std::sqrt(parent.end.weight / parent.start.weight) : 0.0;
    Throughput step;
    if (child.interaction == Interaction::sheet) {
        const auto& role = std::get<SheetRole>(plan.surface(parent.crossing.body).role);
        step = through_sheet(node, role.sheet, {}).throughput;
    } else {
        const auto& media = plan.groups[static_cast<std::size_t>(task.group)].media;
        const auto medium = [&](int region) -> const Dielectric<double>& {
            return media[static_cast<std::size_t>(plan.regions[static_cast<std::size_t>(region)].medium)].dielectric;
        };
        const FarSide far = far_side(plan, node.region, parent.crossing, node.origin);
        const double sense = dot(parent.crossing.normal, node.wave.ray) < 0.0 ? -1.0 : 1.0;
        Branches branches;
        cross_boundary(node, medium(node.region), medium(far.region), parent.crossing.normal * sense, branches);
        for (int i = 0; i < branches.count; ++i) {
            const bool reflected = branches.side[i] == Side::reflected;
            if (reflected == (child.interaction == Interaction::reflected) &&
                branches.node[i].wave.k == child.start.wave.k)
                step = branches.node[i].throughput;
        }
    }
    step.scale(kept);
    return step;
}

CoherenceMatrix<double> through(const Throughput& step, const CoherenceMatrix<double>& light) {
    return to_coherence(step.gather(light));
}

/// Children are born after their parents, so one sweep from the back gathers the light.
void gather(const Plan& plan, const TraceTask& task, RayTree& tree) {
    const std::size_t wavelengths = plan.groups[static_cast<std::size_t>(task.group)].wavelengths.size();
    for (auto node = tree.nodes.rbegin(); node != tree.nodes.rend(); ++node) {
        node->share.assign(wavelengths, {});
        for (std::size_t w = 0; w < node->light.size(); ++w) node->share[w] += node->light[w];
        for (const int child : node->children)
            for (std::size_t w = 0; w < wavelengths; ++w)
                node->share[w] += tree.nodes[static_cast<std::size_t>(child)].share[w];
        if (node->estimated) continue;
        if (node->reason) {
            node->arriving = leaf_source(plan, task, *node);
            continue;
        }
        node->arriving.assign(wavelengths, {});
        for (const int child_index : node->children) {
            const RayTreeNode& child = tree.nodes[static_cast<std::size_t>(child_index)];
            if (child.estimated) continue;
            const Throughput step = step_matrix(plan, task, *node, child);
            for (std::size_t w = 0; w < wavelengths; ++w) node->arriving[w] += through(step, child.arriving[w]);
        }
    }
}

}  // namespace

Explanation explain(const Plan& plan, int x, int y, std::uint32_t sample, int wavelength) {
    POL_EXPECTS(x >= 0 && y >= 0 && x < plan.settings.width && y < plan.settings.height);
    Explanation out;
    out.x = x;
    out.y = y;
    out.sample = sample;
    out.wavelength = wavelength;
    const int group_index = plan.group_of_wavelength[static_cast<std::size_t>(wavelength)];
    const std::vector<int>& members = plan.groups[static_cast<std::size_t>(group_index)].wavelengths;
    out.place = static_cast<int>(std::find(members.begin(), members.end(), wavelength) - members.begin());
    out.task = sample_task(plan, x, y, sample, group_index);

    TreeRecorder recorder;
    std::vector<Stokes<double>> recorded(members.size());
    out.result = trace_with(plan, out.task, recorder, recorded);
    out.tree = std::move(recorder.tree);
    gather(plan, out.task, out.tree);

    Silent silent;
    std::vector<Stokes<double>> rendered(members.size());
    trace_with(plan, out.task, silent, rendered);
    const auto place = static_cast<std::size_t>(out.place);
    out.sample_light = rendered[place];
    for (const int leaf : out.tree.leaves) {
        const std::vector<Stokes<double>>& light = out.tree.nodes[static_cast<std::size_t>(leaf)].light;
        if (!light.empty()) out.leaf_sum += light[place];
    }
    return out;
}

}  // namespace pol
