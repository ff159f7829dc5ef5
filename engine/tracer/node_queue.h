// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/contract.h"
#include "tracer/node.h"

namespace pol {

/// Open branches, heaviest first; of equally heavy ones the older. Memory is reused after clear().
class NodeQueue {
public:
    void clear() {
        heap_.clear();
        free_.clear();
        nodes_.clear();
        open_weight_ = 0.0;
    }

    [[nodiscard]] bool empty() const { return heap_.empty(); }

    /// Sum of the weights in the queue.
    [[nodiscard]] double open_weight() const { return open_weight_; }

    void push(const Node& node) {
        std::uint32_t slot = 0;
        if (free_.empty()) {
            slot = static_cast<std::uint32_t>(nodes_.size());
            nodes_.push_back(node);
        } else {
            slot = free_.back();
            free_.pop_back();
            nodes_[slot] = node;
        }
        heap_.push_back({node.weight, node.id, slot});
        std::push_heap(heap_.begin(), heap_.end(), lighter);
        open_weight_ += node.weight;
    }

    /// Requires: not empty.
    Node pop() {
        POL_EXPECTS(!heap_.empty());
        std::pop_heap(heap_.begin(), heap_.end(), lighter);
        const Entry top = heap_.back();
        heap_.pop_back();
        free_.push_back(top.slot);
        // A running difference would keep the rounding errors of everything that has come and gone.
        open_weight_ = heap_.empty() ? 0.0 : open_weight_ - top.weight;
        return nodes_[top.slot];
    }

    /// Calls visit(node) for every branch in the queue, in an order that depends on nothing but their history.
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (const Entry& entry : heap_) visit(nodes_[entry.slot]);
    }

private:
    struct Entry {
        double weight;
        int id;
        std::uint32_t slot;
    };
    static bool lighter(const Entry& a, const Entry& b) {
        return a.weight < b.weight || (a.weight == b.weight && a.id > b.id);
    }

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> free_;
    std::vector<Entry> heap_;
    double open_weight_ = 0.0;
};

}  // namespace pol
