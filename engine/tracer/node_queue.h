// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/contract.h"
#include "tracer/node.h"

namespace pol {

/// Open branches, heaviest first within a ninth: eight buckets to an octave of weight, the youngest of a bucket first.
/// A heap orders them exactly, and costs as much as the physics; how many branches a tree needs differs by 0.1 %.
/// Memory is reused after clear().
class NodeQueue {
public:
    /// Bucket of a weight: heavier ones have larger numbers. Below 2^-62 all share one.
    static std::uint32_t bucket(double weight) {
        const std::uint64_t exponent_and_eighth = std::bit_cast<std::uint64_t>(weight) >> 49U;
        if (exponent_and_eighth < first_eighth) return 0;
        const std::uint64_t index = exponent_and_eighth - first_eighth;
        return index < bucket_count ? static_cast<std::uint32_t>(index) : bucket_count - 1;
    }

    void clear() {
        for (std::uint32_t word = 0; word < words; ++word)
            for (; filled_[word] != 0; filled_[word] &= filled_[word] - 1)
                first_[64 * word + static_cast<std::uint32_t>(std::countr_zero(filled_[word]))] = nobody;
        nodes_.clear();
        next_.clear();
        free_ = nobody;
        count_ = 0;
        open_weight_ = 0.0;
    }

    [[nodiscard]] bool empty() const { return count_ == 0; }

    /// Sum of the weights in the queue.
    [[nodiscard]] double open_weight() const { return open_weight_; }

    /// Bucket of the heaviest. Requires: not empty.
    [[nodiscard]] std::uint32_t top() const {
        for (std::uint32_t word = words; word-- > 0;)
            if (filled_[word] != 0)
                return 64 * word + 63U - static_cast<std::uint32_t>(std::countl_zero(filled_[word]));
        return 0;
    }

    /// Requires: weight >= 0 and finite.
    void push(const Node& node) {
        std::uint32_t slot = free_;
        if (slot == nobody) {
            slot = static_cast<std::uint32_t>(nodes_.size());
            nodes_.push_back(node);
            next_.push_back(nobody);
        } else {
            free_ = next_[slot];
            nodes_[slot] = node;
        }
        const std::uint32_t index = bucket(node.weight);
        next_[slot] = first_[index];
        first_[index] = slot;
        filled_[index / 64] |= std::uint64_t{1} << (index % 64);
        ++count_;
        open_weight_ += node.weight;
    }

    /// Moves the heaviest to `node`. Requires: not empty.
    void pop(Node& node) {
        POL_EXPECTS(count_ > 0);
        const std::uint32_t index = top();
        const std::uint32_t slot = first_[index];
        first_[index] = next_[slot];
        if (first_[index] == nobody) filled_[index / 64] &= ~(std::uint64_t{1} << (index % 64));
        next_[slot] = free_;
        free_ = slot;
        node = nodes_[slot];
        --count_;
        // A running difference would keep the rounding errors of everything that has come and gone.
        open_weight_ = count_ == 0 ? 0.0 : open_weight_ - node.weight;
    }

    /// Calls visit(node) for every branch in the queue, in the order in which they would be popped.
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (std::uint32_t word = words; word-- > 0;)
            for (std::uint64_t rest = filled_[word]; rest != 0;) {
                const auto bit = 63U - static_cast<std::uint32_t>(std::countl_zero(rest));
                rest &= ~(std::uint64_t{1} << bit);
                for (std::uint32_t slot = first_[64 * word + bit]; slot != nobody; slot = next_[slot])
                    visit(nodes_[slot]);
            }
    }

private:
    static constexpr std::uint32_t bucket_count = 512;  // 64 octaves, 2^-62 to 4
    static constexpr std::uint32_t words = bucket_count / 64;
    static constexpr std::uint32_t nobody = ~std::uint32_t{0};
    static constexpr std::uint64_t first_eighth = std::bit_cast<std::uint64_t>(0x1p-62) >> 49U;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> next_;  ///< by slot: the next of its bucket, or the next free slot
    std::array<std::uint32_t, bucket_count> first_ = [] {
        std::array<std::uint32_t, bucket_count> none{};
        none.fill(nobody);
        return none;
    }();
    std::array<std::uint64_t, words> filled_{};
    std::uint32_t free_ = nobody;
    std::uint32_t count_ = 0;
    double open_weight_ = 0.0;
};

}  // namespace pol
