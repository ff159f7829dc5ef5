// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/result.h"
#include "io/live/tev_message.h"

namespace pol {

/// Where pictures are sent to and listened for.
struct LiveAddress {
    std::string host = "127.0.0.1";  ///< a name or a number
    std::uint16_t port = tev::default_port;
    std::string unix_path{};  ///< of a socket in the file system; then the others mean nothing

    /// "127.0.0.1:14158", "[::1]:14158" or "unix:/run/user/1000/pictures": read_live_address() reads it back.
    [[nodiscard]] std::string text() const;
};

/// HOST:PORT, HOST, PORT or unix:PATH; an IPv6 address in brackets, and nothing for 127.0.0.1:14158. Error (kind
/// usage).
Result<LiveAddress> read_live_address(std::string_view text);

}  // namespace pol
