// SPDX-License-Identifier: Apache-2.0
#include "verify/facts/tree_paths.h"

#include <cmath>

#include "core/complex.h"

namespace pol::verify {

namespace {

const RayTreeNode& node_at(const RayTree& tree, int index) {
    return tree.nodes[static_cast<std::size_t>(index)];
}

}  // namespace

std::string route(const RayTree& tree, int leaf) {
    std::string letters;
    for (int i = leaf; i > 0; i = node_at(tree, i).parent) {
        switch (node_at(tree, i).interaction) {
            case Interaction::reflected:
                letters += 'R';
                break;
            case Interaction::transmitted:
                letters += 'T';
                break;
            case Interaction::sheet:
                letters += 'S';
                break;
            case Interaction::camera:
                break;
        }
    }
    return {letters.rbegin(), letters.rend()};
}

std::vector<const RayTreeNode*> path(const Explanation& explanation, std::string_view letters) {
    const RayTree& tree = explanation.tree;
    std::vector<const RayTreeNode*> branches;
    for (const int leaf : tree.leaves) {
        const RayTreeNode& end = node_at(tree, leaf);
        if (end.estimated || !end.brings_light() || route(tree, leaf) != letters) continue;
        if (!branches.empty()) return {};
        for (int i = leaf; i >= 0; i = node_at(tree, i).parent) branches.push_back(&node_at(tree, i));
    }
    return {branches.rbegin(), branches.rend()};
}

Stokes<double> light_along(const Explanation& explanation, std::string_view letters) {
    const auto branches = path(explanation, letters);
    if (branches.empty()) return {nan, nan, nan, nan};
    return branches.back()->light;
}

const RayTreeNode* find_branch(const Explanation& explanation, std::string_view route) {
    const RayTree& tree = explanation.tree;
    const RayTreeNode* at = &tree.nodes.front();
    for (std::size_t i = 0; i < route.size(); ++i) {
        if (route[i] == ' ') continue;
        const Interaction interaction = route[i] == 'R'   ? Interaction::reflected
                                        : route[i] == 'T' ? Interaction::transmitted
                                                          : Interaction::sheet;
        WaveKind kind = WaveKind::pair;
        if (i + 1 < route.size() && (route[i + 1] == 'o' || route[i + 1] == 'e'))
            kind = route[++i] == 'o' ? WaveKind::ordinary : WaveKind::extraordinary;
        const RayTreeNode* next = nullptr;
        for (const int child : at->children) {
            const RayTreeNode& node = node_at(tree, child);
            if (node.interaction == interaction && node.start.wave.kind == kind) next = &node;
        }
        if (next == nullptr) return nullptr;
        at = next;
    }
    return at;
}

double share(const Explanation& explanation, std::string_view route) {
    const RayTreeNode* found = find_branch(explanation, route);
    return found == nullptr ? 0.0 : found->start.weight;
}

double kept(const Explanation& explanation, std::string_view child, std::string_view parent) {
    const RayTreeNode* found = find_branch(explanation, parent);
    return found == nullptr ? nan : share(explanation, child) / found->start.weight;
}

std::function<double(const Explanation&)> kept_by(const char* child, const char* parent) {
    return [child, parent](const Explanation& e) { return kept(e, child, parent); };
}

double share_along(const Explanation& explanation, std::string_view route, const DVec3& direction) {
    const RayTreeNode* found = find_branch(explanation, route);
    if (found == nullptr) return 0.0;
    double sum = 0.0;
    for (int row = 0; row < 2; ++row) {
        Complex<double> amplitude;
        for (int mode = 0; mode < found->start.wave.mode_count(); ++mode)
            amplitude += found->start.throughput.m[row][mode] * dot(found->start.wave.field[mode], direction);
        sum += norm2(amplitude);
    }
    return 0.5 * sum;
}

double angle_between(const DVec3& a, const DVec3& b) {
    return std::atan2(std::sqrt(length2(cross(a, b))), dot(a, b));
}

}  // namespace pol::verify
