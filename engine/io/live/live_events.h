// SPDX-License-Identifier: Apache-2.0
// What connections bring, for the thread that shows it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "io/live/live_picture.h"
#include "io/live/tev_message.h"

namespace pol {

/// What strangers may ask for.
struct LiveRules {
    tev::MessageLimits message{};
    std::size_t connections = 8;
    std::size_t pictures = 64;
    double picture_bytes = 2.0 * 1024.0 * 1024.0 * 1024.0;  ///< of one picture in memory (LivePicture::bytes)
    double all_bytes = 4.0 * 1024.0 * 1024.0 * 1024.0;      ///< of pictures and messages together
    std::size_t unread_bytes = std::size_t{64} << 20U;      ///< of a connection; then it is not read until take()
    bool anywhere = false;                                  ///< listens on other addresses than loopback, too
    std::filesystem::path open_folder{};                    ///< whose files clients may have opened; empty: none
};

/// Each picture that was created has its own, also if it replaces one of the same name. Never 0, never used again.
using LivePictureId = std::uint64_t;

/// A picture is there. Its memory need not be taken before the first LiveUpdated.
struct LiveCreated {
    LivePictureId id = 0;
    std::optional<LivePictureId> replaces;  ///< a former one of the same name, to which nothing will happen any more
    std::shared_ptr<const LivePicture> picture;
    bool grab_focus = false;
};

/// An update with the bytes that it refers to; it fits its picture.
class LiveUpdated {
public:
    LiveUpdated(LivePictureId id, std::vector<std::byte> bytes, tev::UpdateImage update)
        : id_(id), bytes_(std::move(bytes)), update_(std::move(update)) {}
    // A vector that is moved keeps its bytes in their place.
    LiveUpdated(LiveUpdated&&) = default;
    LiveUpdated& operator=(LiveUpdated&&) = default;
    LiveUpdated(const LiveUpdated&) = delete;
    LiveUpdated& operator=(const LiveUpdated&) = delete;
    ~LiveUpdated() = default;

    [[nodiscard]] LivePictureId id() const { return id_; }
    /// For LivePicture::apply; its rect is what changes.
    [[nodiscard]] const tev::UpdateImage& update() const { return update_; }

private:
    LivePictureId id_;
    std::vector<std::byte> bytes_;
    tev::UpdateImage update_;
};

/// For LivePicture::apply.
struct LiveDescribed {
    LivePictureId id = 0;
    tev::Attributes attributes;
};

/// The client closed the picture.
struct LiveClosed {
    LivePictureId id = 0;
};

/// A client wants a file to be opened, or read again. The path is canonical and lies in LiveRules::open_folder.
struct LiveOpened {
    std::filesystem::path path;
    bool again = false;
    bool grab_focus = false;
};

/// A line for the log: who came and went, and what was dropped and why. UTF-8, without control characters.
struct LiveLine {
    std::string text;
};

using LiveEvent = std::variant<LiveCreated, LiveUpdated, LiveDescribed, LiveClosed, LiveOpened, LiveLine>;

}  // namespace pol
