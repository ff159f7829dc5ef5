// SPDX-License-Identifier: Apache-2.0
// The few calls of the system that both ends of a connection need.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "core/result.h"
#include "io/live/live_address.h"

namespace pol {

/// A file descriptor that closes itself.
class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor();

    [[nodiscard]] int number() const { return number_; }
    explicit operator bool() const { return number_ >= 0; }

private:
    int number_ = -1;
};

/// A socket that listens there, without blocking; `address` gets the port if it was 0. Error: as LiveListener::start.
Result<Descriptor> listen_at(LiveAddress& address, bool anywhere);

/// A connection, without blocking. `give_up` is asked every 0.1 s. Error (kind output): nobody is there, or not within
/// `seconds`.
Result<Descriptor> connect_to(const LiveAddress& address, double seconds, const std::function<bool()>& give_up);

}  // namespace pol
