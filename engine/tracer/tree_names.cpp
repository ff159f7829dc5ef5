// SPDX-License-Identifier: Apache-2.0
#include "tracer/tree_names.h"

#include <algorithm>
#include <cmath>

namespace pol {

const char* name_of(Interaction interaction, bool is_total) {
    switch (interaction) {
        case Interaction::camera:
            return "camera";
        case Interaction::reflected:
            return is_total ? "totally reflected" : "reflected";
        case Interaction::transmitted:
            return "transmitted";
        case Interaction::sheet:
            return "through sheet";
    }
    return "";
}

const char* interaction_of(const Plan& plan, const Explanation& explanation, int branch) {
    return name_of(explanation.tree.nodes[static_cast<std::size_t>(branch)].interaction,
                   is_total_reflection(plan, explanation, branch));
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
            return "residual";
        case LeafReason::depth:
            return "depth limit";
        case LeafReason::node_budget:
            return "node budget";
        case LeafReason::tail_limit:
            return "tail limit";
        case LeafReason::failure:
            return "numerical failure";
    }
    return "";
}

const char* help_of(LeafReason reason) {
    switch (reason) {
        case LeafReason::emitter:
            return "on an emitter, whose light it brings";
        case LeafReason::background:
            return "in the background, whose light it brings";
        case LeafReason::absorbed:
            return "in or on something that absorbs all and brings no light";
        case LeafReason::residual:
            return "the share still open fell below --residual";
        case LeafReason::depth:
            return "it met as many interfaces as --depth allows";
        case LeafReason::node_budget:
            return "--node-budget was used up, the random tail stands for it";
        case LeafReason::tail_limit:
            return "the random tail did not come to an end";
        case LeafReason::failure:
            return "a number went bad or a solid leaked: please report it";
    }
    return "";
}

PathKind kind_of(const RayTreeNode& node) {
    if (node.reason && is_not_followed(*node.reason)) return PathKind::not_followed;
    if (node.start.wave.kind == WaveKind::ordinary) return PathKind::ordinary;
    if (node.start.wave.kind == WaveKind::extraordinary) return PathKind::extraordinary;
    switch (node.interaction) {
        case Interaction::camera:
            return PathKind::camera;
        case Interaction::reflected:
            return PathKind::reflected;
        case Interaction::transmitted:
            return PathKind::transmitted;
        case Interaction::sheet:
            return PathKind::sheet;
    }
    return PathKind::camera;
}

const char* name_of(PathKind kind) {
    switch (kind) {
        case PathKind::camera:
            return name_of(Interaction::camera, false);
        case PathKind::reflected:
            return name_of(Interaction::reflected, false);
        case PathKind::transmitted:
            return name_of(Interaction::transmitted, false);
        case PathKind::sheet:
            return name_of(Interaction::sheet, false);
        case PathKind::ordinary:
            return "o";
        case PathKind::extraordinary:
            return "e";
        case PathKind::not_followed:
            return "not followed";
    }
    return "";
}

const char* handedness_of(const Measures<double>& m) {
    if (std::isnan(m.dop)) return "not a number";
    if (!m.has_light) return "none";
    if (!m.has_polarization) return "unpolarized";
    return m.handedness > 0 ? "right" : m.handedness < 0 ? "left" : "linear";
}

Measures<double> measure_arriving(const Explanation& explanation, const RayTreeNode& node) {
    return measure(to_stokes(*node.arriving),
                   noise_threshold(static_cast<double>(explanation.tree.nodes.size()) + 1.0));
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
    return !group.media[medium].dielectric.is_complex();
}

bool is_not_followed(LeafReason reason) {
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
