// SPDX-License-Identifier: Apache-2.0
#include "io/live/live_sender.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <span>
#include <system_error>
#include <utility>

#include "io/live/tev_message.h"

namespace pol {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto between_connections = std::chrono::seconds(1);
constexpr auto between_looks = std::chrono::milliseconds(250);
constexpr std::chrono::seconds patience(3);

Error lost_connection(const LiveAddress& address, int error) {
    return {ErrorKind::output,
            address.text() + " takes no more of the picture: " + std::generic_category().message(error),
            {},
            {},
            "was the viewer closed?"};
}

/// All bytes, unless nothing is taken for `patience`. Never SIGPIPE.
Result<Done> send_all(const Descriptor& socket, std::span<const std::byte> bytes, const LiveAddress& address,
                      const std::stop_token& stop) {
    constexpr int slice_ms = 100;
    auto end = Clock::now() + patience;
    while (!bytes.empty()) {
        const auto count = ::send(socket.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (count > 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(count));
            end = Clock::now() + patience;
        } else if (errno != EAGAIN && errno != EINTR) {
            return lost_connection(address, errno);
        } else if (Clock::now() > end || stop.stop_requested()) {
            return lost_connection(address, ETIMEDOUT);
        } else {
            pollfd waiting{socket.number(), POLLOUT, 0};
            ::poll(&waiting, 1, slice_ms);
        }
    }
    return Done{};
}

}  // namespace

LiveSender::LiveSender(LiveAddress address, LiveSource source, std::function<void(const Error&)> lost)
    : address_(std::move(address)),
      source_(std::move(source)),
      channels_(live_channels(source_.bands)),
      lost_(std::move(lost)),
      thread_([this](const std::stop_token& stop) { work(stop); }) {}

Result<Done> LiveSender::finish(double seconds) {
    std::unique_lock lock(mutex_);
    finish_ = true;
    changed_.notify_all();
    changed_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return finished_ || problem_; });
    if (finished_) return Done{};
    return problem_.value_or(lost_connection(address_, ETIMEDOUT));
}

void LiveSender::wait_until(Clock::time_point time, const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    const bool was_to_finish = finish_;
    changed_.wait_until(lock, stop, time, [&] { return finish_ != was_to_finish; });
}

/// Every tile that changed since `seen`.
Result<Done> LiveSender::send_news(const Descriptor& socket, std::vector<Version>& seen, const std::stop_token& stop) {
    seen.resize(static_cast<std::size_t>(std::max(source_.tile_count(), 0)));
    for (std::size_t tile = 0; tile < seen.size() && !stop.stop_requested(); ++tile) {
        const auto snapshot = source_.tile_if_newer(static_cast<int>(tile), seen[tile]);
        if (!snapshot || snapshot->preview) continue;
        const auto message = tev::encode_planes(source_.name, channels_, snapshot->rect, live_planes(snapshot->image));
        POL_TRY_DONE(send_all(socket, message, address_, stop));
    }
    return Done{};
}

/// One connection, until it is lost, all is sent, or nobody wants more.
Result<Done> LiveSender::send_picture(const std::stop_token& stop) {
    const double seconds = std::chrono::duration<double>(patience).count();
    POL_TRY(const auto socket, connect_to(address_, seconds, [&] { return stop.stop_requested(); }));
    const tev::CreateImage create{true, source_.name, source_.width, source_.height, channels_};
    POL_TRY_DONE(send_all(socket, tev::encode(create), address_, stop));
    {
        const std::lock_guard lock(mutex_);
        problem_.reset();
    }
    std::vector<Version> seen;
    while (!stop.stop_requested()) {
        bool last = false;
        {
            const std::lock_guard lock(mutex_);
            last = finish_;
        }
        const auto start = Clock::now();
        POL_TRY_DONE(send_news(socket, seen, stop));
        if (last) return Done{};
        // A large picture must not take a core from who renders it: at most a fifth of the time.
        wait_until(start + std::max<Clock::duration>(between_looks, 5 * (Clock::now() - start)), stop);
    }
    return Done{};
}

void LiveSender::work(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        const auto start = Clock::now();
        const auto sent = send_picture(stop);
        if (stop.stop_requested()) return;
        bool first = false;
        {
            const std::lock_guard lock(mutex_);
            if (sent) {
                finished_ = true;
                changed_.notify_all();
                return;
            }
            first = !std::exchange(told_, true);
            problem_ = sent.error();
            changed_.notify_all();
        }
        if (first && lost_) lost_(sent.error());
        wait_until(start + between_connections, stop);
    }
}

}  // namespace pol
