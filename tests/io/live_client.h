// SPDX-License-Identifier: Apache-2.0
// A program that sends bytes to a listener, and what the listener makes of them.
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "io/live/live_listener.h"

namespace pol::test {

/// Blocks where the listener does not read.
class LiveClient {
public:
    explicit LiveClient(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    }
    ~LiveClient() { close(); }
    LiveClient(const LiveClient&) = delete;
    LiveClient& operator=(const LiveClient&) = delete;

    void close() {
        if (socket_ >= 0) ::close(socket_);
        socket_ = -1;
    }
    /// Bytes that were sent, at most all of them; fewer without blocking if `flags` has MSG_DONTWAIT.
    std::size_t send(std::span<const std::byte> bytes, int flags = 0) const {
        std::size_t sent = 0;
        while (sent < bytes.size()) {
            const auto count = ::send(socket_, bytes.data() + sent, bytes.size() - sent, flags | MSG_NOSIGNAL);
            if (count < 0) break;
            sent += static_cast<std::size_t>(count);
        }
        return sent;
    }
    /// True if the listener closed the connection within some seconds.
    [[nodiscard]] bool is_closed() const {
        const timeval patience{5, 0};
        setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
        char nothing = 0;
        const auto count = ::recv(socket_, &nothing, 1, 0);
        return count == 0 || (count < 0 && errno == ECONNRESET);
    }

private:
    int socket_;
};

/// Waits until `is_so`, some seconds at most.
inline bool soon(const std::function<bool()>& is_so) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (!is_so()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

/// Does what a window does: takes events, and keeps the pictures.
struct LiveViewer {
    struct Shown {
        std::shared_ptr<const LivePicture> picture;
        StokesImage image;
        int updates = 0;
    };
    std::map<LivePictureId, Shown> pictures;
    std::vector<std::string> lines;
    std::vector<LiveOpened> opened;
    std::size_t events = 0;

    void take(LiveListener& listener, std::size_t most_bytes = static_cast<std::size_t>(-1)) {
        for (LiveEvent& event : listener.take(most_bytes)) {
            ++events;
            if (auto* created = std::get_if<LiveCreated>(&event)) {
                if (created->replaces) pictures.erase(*created->replaces);
                pictures[created->id] = {created->picture, created->picture->blank(), 0};
            } else if (auto* update = std::get_if<LiveUpdated>(&event)) {
                Shown& shown = pictures.at(update->id());
                shown.picture->apply(update->update(), shown.image);
                ++shown.updates;
            } else if (auto* described = std::get_if<LiveDescribed>(&event)) {
                Shown& shown = pictures.at(described->id);
                shown.picture->apply(described->attributes, shown.image);
            } else if (auto* closed = std::get_if<LiveClosed>(&event)) {
                pictures.erase(closed->id);
            } else if (auto* open = std::get_if<LiveOpened>(&event)) {
                opened.push_back(*open);
            } else {
                lines.push_back(std::get<LiveLine>(event).text);
            }
        }
    }
    [[nodiscard]] const Shown* named(const std::string& name) const {
        for (const auto& [id, shown] : pictures)
            if (shown.picture->name() == name) return &shown;
        return nullptr;
    }
};

/// At any free port.
inline std::unique_ptr<LiveListener> listener_with(const LiveRules& rules = {}, std::function<void()> wake = {}) {
    auto listener = LiveListener::start({"127.0.0.1", 0}, rules, std::move(wake));
    EXPECT_TRUE(listener) << to_string(listener.error());
    return std::move(listener).value();
}

}  // namespace pol::test
