// SPDX-License-Identifier: Apache-2.0
#include "io/live/live_listener.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <utility>

#include "io/live/message_stream.h"

namespace pol {
namespace {

constexpr std::size_t read_at_once = std::size_t{256} << 10U;

/// What an event takes beside the bytes of its message: many small ones must count, too.
constexpr std::size_t event_bytes = 512;

constexpr std::size_t most_lines_waiting = 256;

bool make_pipe(std::array<Descriptor, 2>& ends) {
    std::array<int, 2> numbers{};
    if (::pipe2(numbers.data(), O_NONBLOCK | O_CLOEXEC) != 0) return false;
    ends[0] = Descriptor(numbers[0]);
    ends[1] = Descriptor(numbers[1]);
    return true;
}

}  // namespace

struct LiveListener::Connection {
    Descriptor socket;
    std::uint64_t number = 0;
    tev::MessageStream stream;
    std::array<std::uint64_t, tev::fault_count> faults{};
};

Result<std::unique_ptr<LiveListener>> LiveListener::start(const LiveAddress& address, const LiveRules& rules,
                                                          std::function<void()> wake) {
    LiveAddress at = address;
    POL_TRY(auto socket, listen_at(at, rules.anywhere));
    std::array<Descriptor, 2> pipe;
    if (!make_pipe(pipe))
        return Error{ErrorKind::usage, "too many files are open", {}, {}, "close some, or raise ulimit -n"};
    return std::unique_ptr<LiveListener>(
        new LiveListener(std::move(at), rules, std::move(wake), std::move(socket), std::move(pipe)));
}

LiveListener::LiveListener(LiveAddress address, const LiveRules& rules, std::function<void()> wake, Descriptor socket,
                           std::array<Descriptor, 2> pipe)
    : address_(std::move(address)),
      rules_(rules),
      wake_(std::move(wake)),
      socket_(std::move(socket)),
      pipe_(std::move(pipe)),
      scratch_(read_at_once),
      desk_(rules),
      thread_([this](const std::stop_token& stop) { listen(stop); }) {}

LiveListener::~LiveListener() {
    thread_.request_stop();
    call_thread();
    thread_.join();
    if (!address_.unix_path.empty()) ::unlink(address_.unix_path.c_str());
}

void LiveListener::call_thread() const {
    const char any = 0;
    // A full pipe calls as well.
    [[maybe_unused]] const auto written = ::write(pipe_[1].number(), &any, 1);
}

std::vector<LiveEvent> LiveListener::take(std::size_t most_bytes) {
    std::vector<LiveEvent> events;
    {
        const std::lock_guard lock(mutex_);
        std::size_t taken = 0;
        while (!waiting_.empty() && (events.empty() || taken + waiting_.front().bytes <= most_bytes)) {
            Waiting& next = waiting_.front();
            taken += next.bytes;
            if (std::holds_alternative<LiveLine>(next.event)) --lines_waiting_;
            unread_in_all_ -= next.bytes;
            if (const auto unread = unread_.find(next.connection); unread != unread_.end())
                unread->second -= next.bytes;
            events.push_back(std::move(next.event));
            waiting_.pop_front();
        }
    }
    if (!events.empty()) call_thread();
    return events;
}

void LiveListener::forget(LivePictureId id) {
    const std::lock_guard lock(mutex_);
    desk_.forget(id);
}

LiveCounts LiveListener::counts() const {
    const std::lock_guard lock(mutex_);
    return counts_;
}

void LiveListener::say(std::string line) {
    const std::lock_guard lock(mutex_);
    if (lines_waiting_ >= most_lines_waiting) return;
    ++lines_waiting_;
    has_news_ = true;
    waiting_.push_back({LiveLine{std::move(line)}, 0, 0});
}

bool LiveListener::is_over_budget() const {
    return desk_.bytes() + static_cast<double>(unread_in_all_ + buffered_) > rules_.all_bytes;
}

bool LiveListener::must_wait(const Connection& connection) const {
    const std::lock_guard lock(mutex_);
    return unread_.at(connection.number) >= rules_.unread_bytes || (unread_in_all_ > 0 && is_over_budget());
}

void LiveListener::drop(Connection& connection, tev::Fault fault) {
    const auto kind = static_cast<std::size_t>(fault);
    {
        const std::lock_guard lock(mutex_);
        ++counts_.faults[kind];
    }
    if (++connection.faults[kind] > 1) return;
    const bool ends = fault == tev::Fault::length;
    say(fmt::format("live connection {}: {}: {}", connection.number,
                    ends ? "was closed because of a message" : "a message was dropped", text(fault)));
}

void LiveListener::say_goodbye(const Connection& connection) {
    std::uint64_t dropped = 0;
    for (const std::uint64_t count : connection.faults) dropped += count;
    const bool lost_its_place = connection.faults[static_cast<std::size_t>(tev::Fault::length)] > 0;
    const bool within = connection.stream.waiting() > 0 && !lost_its_place;
    if (dropped > 1 || within)
        say(fmt::format("live connection {} ended{}; {} of its messages were dropped", connection.number,
                        within ? " within a message" : "", dropped));
}

void LiveListener::receive(Connection& connection, std::vector<std::byte> message) {
    const std::size_t bytes = message.size() + event_bytes;
    std::optional<tev::Fault> fault;
    {
        const std::lock_guard lock(mutex_);
        ++counts_.messages;
        if (message.empty()) {
            fault = tev::Fault::type;
        } else {
            auto answer = desk_.receive(std::move(message), static_cast<double>(unread_in_all_ + buffered_));
            if (const auto* why = std::get_if<tev::Fault>(&answer)) {
                fault = *why;
            } else if (auto& event = std::get<std::optional<LiveEvent>>(answer)) {
                waiting_.push_back({std::move(*event), connection.number, bytes});
                unread_[connection.number] += bytes;
                unread_in_all_ += bytes;
                has_news_ = true;
            }
        }
    }
    if (fault) drop(connection, *fault);
}

bool LiveListener::read(Connection& connection) {
    const ssize_t count = ::recv(connection.socket.number(), scratch_.data(), scratch_.size(), 0);
    if (count < 0) return errno == EAGAIN || errno == EINTR;
    if (count == 0) return false;
    const std::size_t before = connection.stream.waiting();
    bool goes_on = false;
    try {
        goes_on =
            connection.stream.feed(std::span(scratch_).first(static_cast<std::size_t>(count)),
                                   [&](std::vector<std::byte> message) { receive(connection, std::move(message)); });
        if (!goes_on) drop(connection, tev::Fault::length);
    } catch (const std::bad_alloc&) {
        drop(connection, tev::Fault::memory);
    }
    bool fits = true;
    {
        const std::lock_guard lock(mutex_);
        buffered_ = buffered_ - before + connection.stream.waiting();
        // While others wait to be taken there is hope (must_wait).
        fits = unread_in_all_ > 0 || !is_over_budget();
    }
    if (!fits) drop(connection, tev::Fault::memory);
    return goes_on && fits;
}

void LiveListener::accept_connections() {
    for (;;) {
        Descriptor socket(::accept4(socket_.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
        if (!socket) {
            // Without free descriptors the caller stays at the door, and would wake us without end.
            can_accept_ = errno == EAGAIN || errno == EINTR || errno == ECONNABORTED;
            return;
        }
        if (connections_.size() >= rules_.connections) {
            if (!std::exchange(told_of_full_house_, true))
                say(fmt::format("a live connection was refused: there are {} already", rules_.connections));
            continue;
        }
        const std::lock_guard lock(mutex_);
        ++counts_.connections;
        unread_[next_connection_] = 0;
        connections_.push_back(std::make_unique<Connection>(
            Connection{std::move(socket), next_connection_++, tev::MessageStream(rules_.message)}));
    }
}

void LiveListener::listen(const std::stop_token& stop) {
    constexpr int look_again_ms = 1000;
    while (!stop.stop_requested()) {
        std::vector<pollfd> watched{{pipe_[0].number(), POLLIN, 0}, {can_accept_ ? socket_.number() : -1, POLLIN, 0}};
        // poll() looks past negative numbers: who waits there is pushed back by the system.
        for (const auto& one : connections_)
            watched.push_back({must_wait(*one) ? -1 : one->socket.number(), POLLIN, 0});
        ::poll(watched.data(), watched.size(), can_accept_ ? -1 : look_again_ms);
        while (::read(pipe_[0].number(), scratch_.data(), scratch_.size()) > 0) {
        }
        can_accept_ = true;

        for (std::size_t i = 0; i < connections_.size(); ++i) {
            Connection& connection = *connections_[i];
            if (watched[i + 2].revents == 0) continue;
            const bool goes_on = read(connection);
            if (goes_on) continue;
            say_goodbye(connection);
            const std::lock_guard lock(mutex_);
            buffered_ -= connection.stream.waiting();
            unread_.erase(connection.number);
            connections_[i] = nullptr;
            told_of_full_house_ = false;
        }
        std::erase(connections_, nullptr);
        if (watched[1].revents != 0) accept_connections();
        if (std::exchange(has_news_, false) && wake_) wake_();
    }
}

}  // namespace pol
