// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "io/live/tev_message.h"

namespace pol::tev {

/// Cuts what a connection brings into messages. Memory grows with what has arrived, never with what a length promises;
/// messages of unknown types are skipped without being kept.
class MessageStream {
public:
    explicit MessageStream(const MessageLimits& limits) : limits_(limits) {}

    /// Hands over each message that is complete with these bytes, from its length on. `message` gets no bytes for one
    /// of unknown type, of which only the beginning was looked at. False: a length is below 6 or above the limit, and
    /// nothing that follows has a meaning; then nothing more may be fed.
    [[nodiscard]] bool feed(std::span<const std::byte> bytes,
                            const std::function<void(std::vector<std::byte>)>& message);

    /// Bytes of an incomplete message.
    [[nodiscard]] std::size_t waiting() const { return bytes_.size(); }

private:
    MessageLimits limits_;
    std::vector<std::byte> bytes_;  // of the message that is under way
    std::size_t skip_ = 0;          // of one that nobody wants
};

}  // namespace pol::tev
