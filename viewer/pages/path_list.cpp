// SPDX-License-Identifier: Apache-2.0
#include "viewer/pages/path_list.h"

#include <algorithm>

#include "tracer/tree_names.h"

namespace pol {

void PathList::set_tree(std::shared_ptr<const Plan> plan, std::shared_ptr<const Explanation> explanation) {
    plan_ = std::move(plan);
    explanation_ = std::move(explanation);
    // A body of the plan before is another one in this plan.
    if (filter_.body && *filter_.body >= plan_->solid_count() + static_cast<int>(plan_->surfaces.size()))
        filter_.body.reset();
    constexpr int first_steps = 3;
    open_.assign(explanation_->tree.nodes.size(), false);
    for (std::size_t i = 0; i < open_.size(); ++i) open_[i] = node(static_cast<int>(i)).start.depth < first_steps;
    find_facts();
    apply_filter();
}

void PathList::set_filter(const PathFilter& filter) {
    if (filter == filter_) return;
    const bool other_body = filter.body != filter_.body;
    filter_ = filter;
    if (explanation_ == nullptr) return;
    if (other_body) find_facts();
    apply_filter();
}

void PathList::set_order(PathOrder order) {
    rows_stale_ |= order != order_;
    order_ = order;
}

void PathList::set_open(int branch, bool open) {
    open_[static_cast<std::size_t>(branch)] = open;
    rows_stale_ = true;
}

void PathList::open_all(bool open) {
    open_.assign(open_.size(), open);
    rows_stale_ = true;
}

void PathList::reveal(int branch) {
    for (int above = node(branch).parent; above >= 0; above = node(above).parent)
        if (!is_open(above)) set_open(above, true);
}

bool PathList::touches(int branch, int body) const {
    const RayTreeNode& n = node(branch);
    return (n.arrived && n.crossing.body == body) ||
           plan_->regions[static_cast<std::size_t>(n.start.region)].owner == body;
}

void PathList::find_facts() {
    facts_.assign(explanation_->tree.nodes.size(), {});
    for (std::size_t i = 0; i < facts_.size(); ++i) {  // parents come before children
        const int branch = static_cast<int>(i);
        const RayTreeNode& n = node(branch);
        Facts& facts = facts_[i];
        if (n.parent >= 0) facts = facts_[static_cast<std::size_t>(n.parent)];
        facts.total = pol::is_total_reflection(*plan_, *explanation_, branch);
        facts.had_total |= facts.total;
        facts.had_e |= n.start.wave.kind == WaveKind::extraordinary;
        facts.had_o |= n.start.wave.kind == WaveKind::ordinary;
        facts.had_body |= filter_.body && touches(branch, *filter_.body);
    }
}

bool PathList::passes(int leaf) const {
    const Facts& facts = facts_[static_cast<std::size_t>(leaf)];
    if (filter_.only_e && (!facts.had_e || facts.had_o)) return false;
    if (filter_.total_reflection && !facts.had_total) return false;
    if (filter_.body && !facts.had_body) return false;
    if (filter_.not_followed && !is_not_followed(*node(leaf).reason)) return false;
    const double s0 = node(leaf).light.s0;
    return !filter_.bright || (s0 > 0.0 && s0 >= filter_.least_share * explanation_->sample_light.s0);
}

void PathList::apply_filter() {
    const auto add = [&](PathCount& count, int leaf) {
        ++count.leaves;
        count.s0 += node(leaf).light.s0;
        count.weight += node(leaf).end.weight;
    };
    listed_.assign(explanation_->tree.nodes.size(), !filter_.any());
    shown_ = all_ = {};
    for (const int leaf : explanation_->tree.leaves) {
        add(all_, leaf);
        if (!passes(leaf)) continue;
        add(shown_, leaf);
        for (int above = leaf; above >= 0 && filter_.any() && !listed(above); above = node(above).parent)
            listed_[static_cast<std::size_t>(above)] = true;
    }
    rows_stale_ = true;
}

std::vector<int> PathList::sorted_children(int branch) const {
    const auto& range = node(branch).children;
    std::vector<int> children(range.begin(), range.end());
    const auto before = [&](int a, int b) {
        return order_ == PathOrder::weight ? node(a).start.weight > node(b).start.weight
                                           : node(a).share.s0 > node(b).share.s0;
    };
    if (order_ != PathOrder::traced) std::stable_sort(children.begin(), children.end(), before);
    return children;
}

const std::vector<PathList::Row>& PathList::rows() {
    if (!rows_stale_) return rows_;
    rows_stale_ = false;
    rows_.clear();
    std::vector<Row> open_ends;
    if (listed(0)) open_ends.push_back({0, 0});
    while (!open_ends.empty()) {
        const Row row = open_ends.back();
        open_ends.pop_back();
        rows_.push_back(row);
        if (!is_open(row.branch)) continue;
        const std::vector<int> children = sorted_children(row.branch);
        for (auto child = children.rbegin(); child != children.rend(); ++child)
            if (listed(*child)) open_ends.push_back({*child, row.indent + 1});
    }
    return rows_;
}

std::optional<std::size_t> PathList::row_of(int branch) {
    const std::vector<Row>& all = rows();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Row& row) { return row.branch == branch; });
    return found == all.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - all.begin()));
}

}  // namespace pol
