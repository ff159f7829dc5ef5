// SPDX-License-Identifier: Apache-2.0
#include "io/live/message_stream.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace pol::tev {

bool MessageStream::feed(std::span<const std::byte> bytes, const std::function<void(std::vector<std::byte>)>& message) {
    constexpr std::size_t length_and_type = 5;
    const auto take = [&](std::size_t wanted) {
        const std::span<const std::byte> more = bytes.first(std::min(wanted, bytes.size()));
        bytes_.insert(bytes_.end(), more.begin(), more.end());
        bytes = bytes.subspan(more.size());
    };
    while (!bytes.empty()) {
        if (skip_ > 0) {
            const std::size_t skipped = std::min(skip_, bytes.size());
            bytes = bytes.subspan(skipped);
            skip_ -= skipped;
            continue;
        }
        if (bytes_.size() < length_and_type) {
            take(length_and_type - bytes_.size());
            if (bytes_.size() < sizeof(std::uint32_t)) return true;
        }
        std::uint32_t length = 0;
        std::memcpy(&length, bytes_.data(), sizeof length);
        if (length < shortest_message || length > limits_.bytes) return false;
        if (bytes_.size() < length_and_type) return true;
        if (!is_known_type(static_cast<std::uint8_t>(bytes_[sizeof length]))) {
            skip_ = length - bytes_.size();
            bytes_.clear();
            message({});
            continue;
        }
        take(length - bytes_.size());
        if (bytes_.size() == length) message(std::exchange(bytes_, {}));
    }
    return true;
}

}  // namespace pol::tev
