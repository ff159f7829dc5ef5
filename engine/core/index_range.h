// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <iterator>

namespace pol {

/// The indices first, first + 1, ... last - 1. (std::ranges::iota_view says the same, but clang 14 cannot read it in
/// the headers of GCC 12.)
class IndexRange {
public:
    class Iterator {
    public:
        using iterator_category = std::forward_iterator_tag;
        using value_type = int;
        using difference_type = std::ptrdiff_t;
        using pointer = const int*;
        using reference = const int&;

        Iterator() = default;
        explicit Iterator(int index) : index_(index) {}
        const int& operator*() const { return index_; }
        Iterator& operator++() {
            ++index_;
            return *this;
        }
        Iterator operator++(int) {
            const Iterator before = *this;
            ++index_;
            return before;
        }
        friend bool operator==(const Iterator&, const Iterator&) = default;

    private:
        int index_ = 0;
    };

    IndexRange() = default;
    /// Requires: first <= last.
    IndexRange(int first, int last) : first_(first), last_(last) {}

    [[nodiscard]] Iterator begin() const { return Iterator(first_); }
    [[nodiscard]] Iterator end() const { return Iterator(last_); }
    [[nodiscard]] bool empty() const { return first_ == last_; }
    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(last_ - first_); }

private:
    int first_ = 0;
    int last_ = 0;
};

}  // namespace pol
