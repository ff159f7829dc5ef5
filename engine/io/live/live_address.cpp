// SPDX-License-Identifier: Apache-2.0
#include "io/live/live_address.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

namespace pol {
namespace {

std::optional<std::uint16_t> port_of(std::string_view text) {
    std::uint16_t port = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), port);
    if (text.empty() || status != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return port;
}

}  // namespace

std::string LiveAddress::text() const {
    if (!unix_path.empty()) return "unix:" + unix_path;
    const bool brackets = host.find(':') != std::string::npos;
    return fmt::format("{}{}{}:{}", brackets ? "[" : "", host, brackets ? "]" : "", port);
}

Result<LiveAddress> read_live_address(std::string_view text) {
    const auto error = [&] {
        return Error{ErrorKind::usage,
                     fmt::format("'{}' is no address to send pictures to", text),
                     {},
                     {},
                     "HOST:PORT, for example 127.0.0.1:14158, or unix:PATH"};
    };
    LiveAddress address;
    if (text.empty()) return address;
    constexpr std::string_view unix_socket = "unix:";
    constexpr std::size_t longest_path = 107;  // sockaddr_un has 108 bytes with the zero
    if (text.starts_with(unix_socket)) {
        address.unix_path = text.substr(unix_socket.size());
        if (address.unix_path.empty() || address.unix_path.size() > longest_path) return error();
        return address;
    }
    std::string_view host = text;
    std::string_view port;
    if (text.starts_with('[')) {
        const std::size_t end = text.find(']');
        if (end == std::string_view::npos || (end + 1 < text.size() && text[end + 1] != ':')) return error();
        host = text.substr(1, end - 1);
        port = end + 1 < text.size() ? text.substr(end + 2) : std::string_view{};
        if (end + 1 < text.size() && !port_of(port)) return error();
    } else if (const std::size_t colon = text.find(':'); colon != std::string_view::npos) {
        host = text.substr(0, colon);
        port = text.substr(colon + 1);
        if (!port_of(port)) return error();
    } else if (std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; })) {
        host = address.host;
        port = text;
    }
    if (host.empty()) return error();
    address.host = host;
    if (!port.empty()) {
        const auto number = port_of(port);
        if (!number) return error();
        address.port = *number;
    }
    return address;
}

}  // namespace pol
