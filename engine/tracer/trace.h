// SPDX-License-Identifier: Apache-2.0
// The kernel: one sample of one pixel, followed backward as a tree that is cut by energy (CUTTING.md 1 and 2).
// Every open branch carries the matrix that takes light on it to the camera, and the weight w = tr(M^H M)/2 of that
// matrix. At a lossless interface the weights of the children add to the parent's, so at every moment
//     resolved + absorbed + open = 1,
// and the light still missing from the pixel is positive semidefinite with trace at most open * L_max. A branch that
// surely goes to a lamp, the background or a black surface ends when it is born; of the others (one at most in a convex
// glass stone) the heaviest is followed first (NodeQueue) as long as determined.h says. Where the budget ends above the
// residual, one random path, chosen with probability proportional to weight, estimates the rest without bias. Picture
// and explanation run this same function, with different observers (tracer/observers.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/random.h"
#include "optics/elements.h"
#include "optics/wave.h"
#include "plan/plan.h"
#include "tracer/crossing.h"
#include "tracer/determined.h"
#include "tracer/leaf_light.h"
#include "tracer/node.h"
#include "tracer/node_queue.h"
#include "tracer/step.h"
#include "tracer/trace_task.h"
#include "tracer/with_kernel.h"

namespace pol {

/// Traces samples of one plan; keeps its memory between samples. Not for sharing between threads.
/// anisotropic, absorbing: what the plan needs (with_kernel); the rest is not compiled in.
template <bool anisotropic, bool absorbing, class Observer>
class Tracer {
public:
    /// The plan must outlive the tracer.
    Tracer(PlanForKernel<anisotropic, absorbing> plan, Observer& observer) : plan_(plan.plan()), observer_(observer) {}

    /// Adds the light of the sample to `sums`, one Stokes vector per wavelength of the group.
    TraceResult trace(const TraceTask& task, std::span<Stokes<double>> sums) {
        prepare(task, sums);
        open_root(task, current_);
        // Where only some pixels' rays start inside one: compiling has refused what it found.
        const bool going = medium_of(task.region).dielectric.kind == MediumKind::isotropic;
        if (!going) fail(current_);
        return follow_all(task, going);
    }

    /// Goes on with a sample of which `result` and `sums` hold what has ended, and `node` is the only open branch.
    TraceResult resume(const TraceTask& task, const Node& node, const TraceResult& result,
                       std::span<Stokes<double>> sums) {
        prepare(task, sums);
        result_ = result;
        current_ = node;
        return follow_all(task, true);
    }

private:
    void prepare(const TraceTask& task, std::span<Stokes<double>> sums) {
        group_ = &plan_.groups[static_cast<std::size_t>(task.group)];
        group_index_ = task.group;
        sums_ = sums;
        result_ = {};
        next_id_ = 0;
        camera_n_ = medium_of(task.region).dielectric.n;
        queue_.clear();
    }

    /// From current_ on, if it is `going`.
    TraceResult follow_all(const TraceTask& task, bool going) {
        Node& node = current_;
        const auto budget = static_cast<std::uint32_t>(task.node_budget);
        LeafReason cut = LeafReason::residual;
        std::uint32_t asked = 0;
        const auto open_weight = [&] { return node.weight + queue_.open_weight(); };
        while (going && is_followed(task.residual, task.until_determined, *group_, result_, open_weight())) {
            if (result_.nodes >= budget) {
                if (open_weight() > task.residual) cut = LeafReason::node_budget;
                break;
            }
            if (result_.nodes - asked >= nodes_between_questions) {
                asked = result_.nodes;
                if (observer_.cancelled()) {
                    result_.cancelled = true;
                    return result_;
                }
            }
            follow(node);
            end_short_branches();
            going = go_on(node);
        }
        if (going) queue_.push(node);
        const double open = close_queue(cut);
        if (cut == LeafReason::node_budget)
            follow_tail(task, open);
        else
            result_.residual += open;

        const double total = result_.resolved + result_.absorbed + result_.residual + result_.tail;
        if (!(std::abs(total - 1.0) <= energy_tolerance)) ++result_.failures;
        return result_;
    }

    [[nodiscard]] const Region& region(int index) const { return plan_.regions[static_cast<std::size_t>(index)]; }
    [[nodiscard]] const MediumAt& medium_of(int region_index) const {
        return group_->media[static_cast<std::size_t>(region(region_index).medium)];
    }

    void open_root(const TraceTask& task, Node& root) {
        root = {};
        root.origin = task.ray.origin;
        root.wave.ray = task.ray.direction;
        root.wave.k = task.ray.direction * camera_n_;
        root.wave.field[0] = task.ray.x;
        root.wave.field[1] = task.ray.y;
        root.throughput = Throughput<double>::identity();
        root.weight = 1.0;
        root.region = task.region;
        root.id = next_id_++;
        observer_.opened(root, -1, Interaction::camera);
    }

    void leaf(const Node& node, LeafReason reason, std::span<const Stokes<double>> light = {}) {
        observer_.ended(node, reason, light);
    }

    /// Takes the heaviest open branch out of children_ and the queue; false: there is none. A child goes before
    /// branches of its bucket, so that the kernel stays in a stone that traps light.
    bool go_on(Node& node) {
        int heaviest = 0;
        for (int i = 1; i < children_.count; ++i)
            if (children_.node[i].weight > children_.node[heaviest].weight) heaviest = i;
        if (!queue_.empty() &&
            (children_.count == 0 || queue_.top() > NodeQueue::bucket(children_.node[heaviest].weight))) {
            queue_.pop(node);
            for (int i = 0; i < children_.count; ++i) queue_.push(children_.node[i]);
            return true;
        }
        if (children_.count == 0) return false;
        for (int i = 0; i < children_.count; ++i)
            if (i != heaviest) queue_.push(children_.node[i]);
        node = children_.node[heaviest];
        return true;
    }

    /// Ends the children that surely have no interface ahead of them.
    void end_short_branches() {
        int kept = 0;
        for (int i = 0; i < children_.count; ++i) {
            Node& child = children_.node[i];
            const Region& here = region(child.region);
            if (here.is_open && misses_solids(plan_, here, child.origin, child.wave.ray, child.left)) {
                ++result_.nodes;
                advance(child);
                continue;
            }
            if (kept != i) children_.node[kept] = child;
            ++kept;
        }
        children_.count = kept;
    }

    /// Follows a ray to its next interface; leaves go into the sums, branches into children_.
    void follow(Node& node) {
        ++result_.nodes;
        children_.count = 0;
        advance(node);
    }

    void advance(Node& node) {
        const int depth_limit = plan_.settings.depth.value_or(-1);
        for (;;) {
            const Region& here = region(node.region);
            const Crossing crossing = next_crossing(plan_, here, node.origin, node.wave.ray, node.left);
            if constexpr (absorbing) {
                if (!attenuate(node, crossing)) return;
            }
            if (crossing.body < 0) {
                if (here.members.empty()) return end_on_background(node);
                return fail(node);  // a solid must have a way out
            }
            node.origin += node.wave.ray * crossing.distance;
            observer_.reached(node, crossing);
            if (!plan_.is_solid(crossing.body)) return meet_surface(node, crossing, depth_limit);

            const FarSide far = far_side(plan_, node.region, crossing, node.origin);
            if (far.region < 0) return fail(node);
            if (region(far.region).owner != here.owner) {
                if (far.black) return absorb(node);
                if (depth_limit >= 0 && node.depth >= depth_limit) return cut_by_depth(node);
                const double sense = dot(crossing.normal, node.wave.ray) < 0.0 ? -1.0 : 1.0;
                return meet_boundary(node, crossing, far, crossing.normal * sense);
            }
            node.region = far.region;  // the same medium goes on behind this boundary
            node.left = far.left;
        }
    }

    void fail(const Node& node) {
        ++result_.failures;
        result_.residual += node.weight;
        leaf(node, LeafReason::failure);
    }

    void cut_by_depth(const Node& node) {
        result_.residual += node.weight;
        leaf(node, LeafReason::depth);
    }

    void absorb(const Node& node) {
        result_.absorbed += node.weight;
        leaf(node, LeafReason::absorbed);
    }

    /// Beer-Lambert along the segment. False if nothing is left because the segment has no end.
    bool attenuate(Node& node, const Crossing& crossing) {
        const MediumAt& medium = medium_of(node.region);
        if (!medium.absorption.absorbs()) return true;
        if (crossing.body < 0) {
            absorb(node);
            return false;
        }
        const Dielectric<double>& d = medium.dielectric;
        double alpha = pair_absorption(medium.absorption, d.n, node.wave.k);
        if constexpr (anisotropic) {
            if (node.wave.kind != WaveKind::pair)
                alpha = mode_absorption(medium.absorption, d.n, d.n_e, d.axis, node.wave.field[0], node.wave.k,
                                        node.wave.ray);
        }
        const Attenuation<double> along = attenuation(alpha, crossing.distance);
        const double lost = node.weight * along.lost;
        result_.absorbed += lost;
        node.throughput.scale(along.amplitude);
        node.weight -= lost;
        return true;
    }

    void end_on_background(const Node& node) {
        light_.assign(group_->wavelengths.size(), {});
        resolve(node, LeafReason::background, background_light(plan_, *group_, node, camera_n_, light_));
    }

    void resolve(const Node& node, LeafReason reason, Stokes<double> seen) {
        if (plan_.settings.unpolarized) {
            for (Stokes<double>& s : light_) s = {s.s0, 0.0, 0.0, 0.0};
            seen = {seen.s0, 0.0, 0.0, 0.0};
        }
        result_.seen += seen;
        for (std::size_t i = 0; i < light_.size(); ++i) sums_[i] += light_[i];
        result_.resolved += node.weight;
        leaf(node, reason, light_);
    }

    void meet_surface(Node& node, const Crossing& crossing, int depth_limit) {
        const Surface& surface = plan_.surface(crossing.body);
        if (const auto* role = std::get_if<EmitterRole>(&surface.role)) {
            const Emitter& emitter = plan_.emitters[static_cast<std::size_t>(role->emitter)];
            const bool front = dot(crossing.normal, node.wave.ray) < 0.0;
            if (!front && !emitter.two_sided) return absorb(node);
            if (!has_state_along(emitter, node.wave.ray)) return fail(node);
            light_.assign(group_->wavelengths.size(), {});
            return resolve(node, LeafReason::emitter,
                           emitter_light(plan_, group_index_, emitter, node, crossing, camera_n_, light_));
        }
        if (const auto* role = std::get_if<SheetRole>(&surface.role)) {
            if (depth_limit >= 0 && node.depth >= depth_limit) return cut_by_depth(node);
            children_.node[0] = through_sheet(node, role->sheet, crossing.normal,
                                              Left{crossing.body, crossing.facet, crossing.triangle});
            children_.count = 1;
            result_.absorbed += node.weight - children_.node[0].weight;
            adopt_children(node, [](int) { return Interaction::sheet; });
            return;
        }
        absorb(node);
    }

    void meet_boundary(const Node& node, const Crossing& crossing, const FarSide& far, const DVec3& normal) {
        const Dielectric<double>& from = medium_of(node.region).dielectric;
        const Dielectric<double>& to = medium_of(far.region).dielectric;
        const Left same_side{crossing.body, crossing.facet, crossing.triangle};
        if constexpr (anisotropic)
            cross_boundary(node, from, to, normal, children_);
        else
            cross_isotropic_boundary(node, from, to, normal, children_);
        if (!children_.valid) {
            children_.count = 0;
            return fail(node);
        }
        result_.absorbed += children_.absorbed;
        for (int i = 0; i < children_.count; ++i) {
            Node& child = children_.node[i];
            const bool reflected = children_.side[i] == Side::reflected;
            child.origin = node.origin;
            child.region = reflected ? node.region : far.region;
            child.left = reflected ? same_side : far.left;
        }
        adopt_children(node, [this](int i) {
            return children_.side[i] == Side::reflected ? Interaction::reflected : Interaction::transmitted;
        });
    }

    /// Numbers the children and closes the gaps left by those that carry nothing.
    template <class InteractionOf>
    void adopt_children(const Node& parent, const InteractionOf& interaction_of) {
        int kept = 0;
        for (int i = 0; i < children_.count; ++i) {
            Node& child = children_.node[i];
            child.depth = parent.depth + 1;
            if (child.weight == 0.0) continue;
            if (plan_.settings.unpolarized)
                child.throughput = Throughput<double>::of_weight(child.weight, child.wave.mode_count());
            child.id = next_id_++;
            observer_.opened(child, parent.id, interaction_of(i));
            if (!std::isfinite(child.weight)) {
                fail(child);
                continue;
            }
            if (kept != i) children_.node[kept] = child;
            ++kept;
        }
        children_.count = kept;
    }

    /// Ends what is still open; returns its weight.
    double close_queue(LeafReason reason) {
        double open = 0.0;
        queue_.for_each([&](const Node& node) {
            open += node.weight;
            if (reason == LeafReason::residual) leaf(node, reason);
        });
        return open;
    }

    /// One random path stands for all open branches: chosen with probability w / open at the root and at every
    /// branching, and rescaled so that it always weighs `open`. Its estimate then never exceeds open * L_max
    /// (CUTTING.md 2.2).
    void follow_tail(const TraceTask& task, double open) {
        std::uint32_t dimension = first_tail_dimension;
        double pick = random_unit(task.key, dimension++) * open;
        Node node;
        node.id = -1;
        queue_.for_each([&](const Node& candidate) {
            if (node.id < 0 && pick < candidate.weight)
                node = candidate;
            else
                leaf(candidate, LeafReason::node_budget);
            pick -= candidate.weight;
        });
        if (node.id < 0) {  // a rounding error beyond the last one
            result_.residual += open;
            return;
        }

        const TraceResult head = result_;
        observer_.tail_begins(node);
        bool ended = false;
        for (int step = 0; step < tail_limit(task.node_budget) && !ended; ++step) {
            node.throughput.scale(std::sqrt(open / node.weight));
            node.weight = open;
            const std::uint32_t failures = result_.failures;
            const double residual = result_.residual;
            follow(node);
            if (result_.failures != failures || result_.residual != residual) break;  // ended without an answer
            double u = random_unit(task.key, dimension++) * open;
            int branch = 0;
            while (branch < children_.count && u >= children_.node[branch].weight) u -= children_.node[branch++].weight;
            ended = branch >= children_.count;  // a leaf, or absorbed with the probability of absorption
            for (int i = 0; i < children_.count; ++i)
                if (i != branch) leaf(children_.node[i], LeafReason::node_budget);
            if (!ended) node = children_.node[branch];
        }
        const TraceResult all = result_;
        result_ = head;
        result_.nodes = all.nodes;
        result_.failures = all.failures;
        (ended ? result_.tail : result_.residual) += open;
        if (!ended && all.residual == head.residual) leaf(node, LeafReason::tail_limit);
    }

    static constexpr std::uint32_t first_tail_dimension = 16;
    static constexpr std::uint32_t nodes_between_questions = 256;

    const Plan& plan_;
    Observer& observer_;
    const WavelengthGroup* group_ = nullptr;
    int group_index_ = 0;
    std::span<Stokes<double>> sums_;
    TraceResult result_{};
    int next_id_ = 0;
    double camera_n_ = 1.0;
    Node current_;
    NodeQueue queue_;
    Branches children_;
    std::vector<Stokes<double>> light_;
};

}  // namespace pol
