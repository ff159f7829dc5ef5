// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "io/live/live_events.h"

namespace pol {

/// Knows which pictures there are, and makes events of messages. Knows no connections: names are common to all of them,
/// as in tev.
class LiveDesk {
public:
    explicit LiveDesk(const LiveRules& rules) : rules_(rules) {}

    /// What a message means, or why it is dropped; empty if it is fine and changes nothing that we show (drawings).
    /// `more_bytes` are those that others hold, for LiveRules::all_bytes.
    std::variant<std::optional<LiveEvent>, tev::Fault> receive(std::vector<std::byte> message, double more_bytes);

    void forget(LivePictureId id);

    /// Memory of all pictures, once they are shown.
    [[nodiscard]] double bytes() const { return bytes_; }

private:
    struct Entry {
        LivePictureId id = 0;
        double bytes = 0.0;
        std::shared_ptr<const LivePicture> picture;
    };
    using Answer = std::variant<std::optional<LiveEvent>, tev::Fault>;

    Answer create(const tev::CreateImage& message, double message_bytes, double more_bytes);
    [[nodiscard]] Answer open(const std::string& path, bool again, bool grab_focus) const;
    void remove(std::map<std::string, Entry>::iterator entry);

    LiveRules rules_;
    std::map<std::string, Entry> pictures_;  // by name
    double bytes_ = 0.0;
    LivePictureId next_ = 1;
};

}  // namespace pol
