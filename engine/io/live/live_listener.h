// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/result.h"
#include "io/live/live_address.h"
#include "io/live/live_desk.h"
#include "io/live/live_events.h"
#include "io/live/sockets.h"

namespace pol {

/// What came so far.
struct LiveCounts {
    std::uint64_t connections = 0;                       ///< ever accepted
    std::uint64_t messages = 0;                          ///< good and bad ones
    std::array<std::uint64_t, tev::fault_count> faults;  ///< messages that were dropped, by tev::Fault
};

/// Takes pictures from programs that speak tev's protocol, on a thread of its own.
///
/// The thread reads, decodes and checks; what it finds waits in order for take(). Whoever takes applies the updates to
/// its pictures (LivePicture), typically before it draws a frame. While more than LiveRules::unread_bytes of a
/// connection wait, nothing is read from it, so that its program has to wait, and memory does not grow.
///
/// Bad messages are dropped with one LiveLine per connection and reason, and counted; a bad length ends its connection.
/// Thread safety: all members from any thread; `wake` is called from the listener's, after something came.
class LiveListener {
public:
    /// Error (kind usage): the address is taken, is not of this machine, or others could reach it
    /// (LiveRules::anywhere). Port 0: any free one.
    static Result<std::unique_ptr<LiveListener>> start(const LiveAddress& address, const LiveRules& rules,
                                                       std::function<void()> wake);
    /// Closes all connections and joins.
    ~LiveListener();
    LiveListener(const LiveListener&) = delete;
    LiveListener& operator=(const LiveListener&) = delete;

    /// Where it listens, with the port that it got.
    [[nodiscard]] const LiveAddress& address() const { return address_; }

    /// What came since the last call, in order, until it takes more than `most_bytes` of messages: at least one event,
    /// if there is any, so that a large one gets through. The rest stays, and no further `wake` tells of it.
    std::vector<LiveEvent> take(std::size_t most_bytes = static_cast<std::size_t>(-1));

    /// The picture is shown no more: its name and memory are free, and updates of it are dropped. Events of it that
    /// are waiting still come.
    void forget(LivePictureId id);

    [[nodiscard]] LiveCounts counts() const;

private:
    struct Connection;
    struct Waiting {
        LiveEvent event;
        std::uint64_t connection = 0;
        std::size_t bytes = 0;  ///< that it counts for
    };

    LiveListener(LiveAddress address, const LiveRules& rules, std::function<void()> wake, Descriptor socket,
                 std::array<Descriptor, 2> pipe);
    void listen(const std::stop_token& stop);
    void accept_connections();
    /// False: the connection is over.
    [[nodiscard]] bool read(Connection& connection);
    void receive(Connection& connection, std::vector<std::byte> message);
    void drop(Connection& connection, tev::Fault fault);
    void say_goodbye(const Connection& connection);
    void say(std::string line);
    [[nodiscard]] bool must_wait(const Connection& connection) const;
    [[nodiscard]] bool is_over_budget() const;
    void call_thread() const;

    const LiveAddress address_;
    const LiveRules rules_;
    const std::function<void()> wake_;
    const Descriptor socket_;
    const std::array<Descriptor, 2> pipe_;  // read end, write end: interrupts the thread's wait

    // Of the thread alone.
    std::vector<std::unique_ptr<Connection>> connections_;
    std::vector<std::byte> scratch_;
    std::uint64_t next_connection_ = 1;
    bool told_of_full_house_ = false;
    bool can_accept_ = true;
    bool has_news_ = false;  // that `wake` has not told of

    mutable std::mutex mutex_;  // guards the members below
    LiveDesk desk_;
    std::deque<Waiting> waiting_;
    std::size_t lines_waiting_ = 0;
    std::map<std::uint64_t, std::size_t> unread_;  // by connection
    std::size_t unread_in_all_ = 0;
    std::size_t buffered_ = 0;  // bytes of incomplete messages
    LiveCounts counts_{};

    std::jthread thread_;
};

}  // namespace pol
