// SPDX-License-Identifier: Apache-2.0
// Reciprocity: camera and end of a path exchange places, and the amplitudes are transposed (PHYSICS.md 2.8).
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tracer/explain.h"
#include "verify/facts/tree_paths.h"
#include "verify/invariants/invariants.h"
#include "verify/invariants/scene_twins.h"

namespace pol::verify {

namespace {

/// Interfaces on the longest path that is reversed.
constexpr int longest = 4;
/// Paths that are tried, over the picture: each needs a plan of its own.
constexpr int paths_a_side = 8;
/// Directions of the two paths agree to rounding; amplitudes have slopes up to 1e3 near critical angles.
constexpr double path_tolerance = 1e-9;

/// Branches from the camera ray to `leaf`.
std::vector<const RayTreeNode*> branches_to(const RayTree& tree, int leaf) {
    std::vector<const RayTreeNode*> branches;
    for (int i = leaf; i >= 0; i = tree.nodes[static_cast<std::size_t>(i)].parent)
        branches.push_back(&tree.nodes[static_cast<std::size_t>(i)]);
    return {branches.rbegin(), branches.rend()};
}

bool absorbs(const Plan& plan, int region) {
    const int medium = plan.regions[static_cast<std::size_t>(region)].medium;
    return plan.groups[0].media[static_cast<std::size_t>(medium)].absorption.absorbs();
}

/// The heaviest path from a light to the camera that met something, is not too long, and whose ends do not absorb.
std::vector<const RayTreeNode*> heaviest_path(const Plan& plan, const Explanation& e) {
    std::vector<const RayTreeNode*> best;
    for (const int leaf : e.tree.leaves) {
        const RayTreeNode& end = e.tree.nodes[static_cast<std::size_t>(leaf)];
        const bool lit = end.reason == LeafReason::emitter || end.reason == LeafReason::background;
        if (!lit || end.estimated || end.parent < 0 || end.start.wave.kind != WaveKind::pair) continue;
        if (!best.empty() && end.start.weight <= best.back()->start.weight) continue;
        const auto branches = branches_to(e.tree, leaf);
        if (branches.size() > longest + 1 || absorbs(plan, e.task.region) || absorbs(plan, end.start.region)) continue;
        best = branches;
    }
    return best;
}

/// The route of find_branch() from the end of the path back to its camera.
std::string reversed_route(const std::vector<const RayTreeNode*>& branches) {
    std::string route;
    for (std::size_t i = branches.size() - 1; i > 0; --i) {
        const Interaction interaction = branches[i]->interaction;
        route += interaction == Interaction::reflected ? 'R' : interaction == Interaction::transmitted ? 'T' : 'S';
        const WaveKind kind = branches[i - 1]->start.wave.kind;
        if (kind != WaveKind::pair) route += kind == WaveKind::ordinary ? 'o' : 'e';
    }
    return route;
}

/// Largest difference between the amplitudes of a path and those of its reverse, transposed. `back` is the branch that
/// reaches the camera of `path` from the camera of `reversed`.
double asymmetry(const Explanation& forward, const RayTreeNode& leaf, const Explanation& reversed,
                 const RayTreeNode& back) {
    const DVec3 camera[2] = {forward.task.ray.x, forward.task.ray.y};
    const DVec3 other[2] = {reversed.task.ray.x, reversed.task.ray.y};
    double worst = 0.0;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
            Complex<double> expected;
            for (int l = 0; l < 2; ++l)
                for (int k = 0; k < 2; ++k)
                    expected += leaf.start.throughput.m[l][k] *
                                (dot(other[i], leaf.start.wave.field[k]) * dot(back.start.wave.field[j], camera[l]));
            worst = std::max(worst, abs(back.start.throughput.m[i][j] - expected));
        }
    return worst;
}

}  // namespace

InvariantResult is_reciprocal(const SceneUnderTest& test) {
    if (test.scene.render.unpolarized) return does_not_apply("light that forgets its polarization has no amplitudes");
    Scene scene = cut_by_depth(test.scene, longest);
    const auto there = under_test(scene);
    if (!there) return does_not_apply(there.error().what);
    const Plan& plan = *there.value().plan;
    Tally tally;
    for (int row = 0; row < paths_a_side; ++row)
        for (int column = 0; column < paths_a_side; ++column) {
            const int x = column * (plan.settings.width - 1) / (paths_a_side - 1);
            const int y = row * (plan.settings.height - 1) / (paths_a_side - 1);
            const Explanation e = explain(plan, x, y, 0, 0);
            const auto branches = heaviest_path(plan, e);
            if (branches.empty()) continue;
            const RayTreeNode& leaf = *branches.back();
            const DVec3 ray = leaf.start.wave.ray;
            const double along = leaf.reason == LeafReason::emitter
                                     ? 0.5 * std::sqrt(length2(leaf.end.origin - leaf.start.origin))
                                     : plan.length_scale;
            Scene turned = scene;
            turned.render.width = turned.render.height = 1;
            turned.render.mode = SampleMode::point;
            turned.camera.projection = Projection::orthographic;
            turned.camera.width = 1e-6 * plan.length_scale;
            turned.camera.position = leaf.start.origin + ray * along;
            turned.camera.target = leaf.start.origin;
            turned.camera.up = any_perpendicular(ray);
            const auto reversed_plan = under_test(turned);
            if (!reversed_plan) return does_not_apply(reversed_plan.error().what);
            const Explanation reversed = explain(*reversed_plan.value().plan, 0, 0, 0, 0);
            const RayTreeNode* back = find_branch(reversed, reversed_route(branches));
            const WorstPixel at{x, y, plan.wavelengths_nm[0]};
            if (back == nullptr)
                tally.add_exact(false, at);
            else
                tally.add(asymmetry(e, leaf, reversed, *back) / path_tolerance, at);
        }
    if (tally.result().tested == 0) return does_not_apply("no light comes by way of one to four interfaces");
    return tally.result();
}

}  // namespace pol::verify
