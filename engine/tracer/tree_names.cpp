// SPDX-License-Identifier: Apache-2.0
#include "tracer/tree_names.h"

#include <algorithm>
#include <cmath>

namespace pol {

const char* name_of(Interaction interaction) {
    switch (interaction) {
        case Interaction::camera:
            return "camera";
        case Interaction::reflected:
            return "reflected";
        case Interaction::transmitted:
            return "transmitted";
        case Interaction::sheet:
            return "through sheet";
    }
    return "";
}

const char* name_of(LeafReason reason) {
    switch (reason) {
        case LeafReason::emitter:
            return "emitter";
        case LeafReason::background:
            return "background";
        case LeafReason::absorbed:
            return "absorbed";
        case LeafReason::residual:
            return "residual (--residual)";
        case LeafReason::depth:
            return "residual (--depth)";
        case LeafReason::node_budget:
            return "residual (--node-budget), left to the random tail";
        case LeafReason::tail_limit:
            return "residual (tail too long)";
        case LeafReason::failure:
            return "numerical failure";
    }
    return "";
}

const char* mode_of(const Wave<double>& wave) {
    switch (wave.kind) {
        case WaveKind::pair:
            return "s/p";
        case WaveKind::ordinary:
            return "o";
        case WaveKind::extraordinary:
            return "e";
    }
    return "";
}

const std::string& medium_name(const Plan& plan, int region) {
    return plan.medium_names[static_cast<std::size_t>(plan.regions[static_cast<std::size_t>(region)].medium)];
}

double index_of(const RayTreeNode& node) {
    return std::sqrt(length2(node.start.wave.k));
}

bool is_total_reflection(const Plan& plan, const Explanation& explanation, int branch) {
    const std::vector<RayTreeNode>& nodes = explanation.tree.nodes;
    const RayTreeNode& node = nodes[static_cast<std::size_t>(branch)];
    if (node.interaction != Interaction::reflected) return false;
    const RayTreeNode& parent = nodes[static_cast<std::size_t>(node.parent)];
    const bool gets_through = std::any_of(parent.children.begin(), parent.children.end(), [&](int child) {
        return nodes[static_cast<std::size_t>(child)].interaction == Interaction::transmitted;
    });
    if (gets_through) return false;
    const FarSide far = far_side(plan, parent.end.region, parent.crossing, parent.end.origin);
    if (far.region < 0) return false;
    const auto& group = plan.groups[static_cast<std::size_t>(explanation.task.group)];
    const auto medium = static_cast<std::size_t>(plan.regions[static_cast<std::size_t>(far.region)].medium);
    return group.media[medium].dielectric.kind != MediumKind::conductor;
}

bool is_unresolved(LeafReason reason) {
    switch (reason) {
        case LeafReason::emitter:
        case LeafReason::background:
        case LeafReason::absorbed:
            return false;
        case LeafReason::residual:
        case LeafReason::depth:
        case LeafReason::node_budget:
        case LeafReason::tail_limit:
        case LeafReason::failure:
            return true;
    }
    return true;
}

}  // namespace pol
