// SPDX-License-Identifier: Apache-2.0
#include "tracer/ray_tree.h"

#include <cmath>

namespace pol {

Node in_frame_of_light(Node node) {
    Wave<double>& wave = node.wave;
    if (wave.kind != WaveKind::pair) {
        wave.field[1] = cross(wave.field[0], wave.ray);
    } else if (dot(cross(wave.field[0], wave.field[1]), wave.ray) > 0.0) {
        wave.field[1] = -wave.field[1];
        for (auto& row : node.throughput.m) row[1] = -row[1];
    }
    return node;
}

void TreeRecorder::opened(const Node& node, int parent, Interaction interaction) {
    RayTreeNode entry;
    entry.parent = parent;
    entry.interaction = interaction;
    entry.start = entry.end = in_frame_of_light(node);
    entry.estimated = in_tail_;
    tree.nodes.push_back(entry);
    if (parent < 0) return;
    auto& children = at(parent).children;
    children = {children.empty() ? node.id : *children.begin(), node.id + 1};
}

void TreeRecorder::reached(const Node& node, const Crossing& crossing) {
    RayTreeNode& entry = at(node.id);
    entry.end = in_frame_of_light(node);
    entry.crossing = crossing;
    entry.arrived = true;
    // The angle from the cross product too: acos alone loses half the digits near normal incidence.
    entry.angle = std::atan2(std::sqrt(length2(cross(crossing.normal, node.wave.ray))),
                             std::abs(dot(crossing.normal, node.wave.ray)));
}

void TreeRecorder::ended(const Node& node, LeafReason reason, std::span<const Stokes<double>> light) {
    RayTreeNode& entry = at(node.id);
    entry.end = in_frame_of_light(node);
    entry.reason = reason;
    if (!light.empty()) entry.light = light[place_];
    tree.leaves.push_back(node.id);
}

void TreeRecorder::tail_begins(const Node& node) {
    in_tail_ = true;
    at(node.id).estimated = true;
}

}  // namespace pol
