// SPDX-License-Identifier: Apache-2.0
#include "io/live/sockets.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <memory>
#include <system_error>
#include <vector>

namespace pol {
namespace {

/// One end that an address stands for.
struct Endpoint {
    sockaddr_storage storage{};
    socklen_t length = 0;
    [[nodiscard]] const sockaddr* address() const { return reinterpret_cast<const sockaddr*>(&storage); }
    [[nodiscard]] int family() const { return storage.ss_family; }
};

std::string reason(int error) {
    return std::generic_category().message(error);
}

Endpoint unix_place(const std::string& path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, path.data(), std::min(path.size(), sizeof address.sun_path - 1));
    Endpoint place;
    std::memcpy(&place.storage, &address, sizeof address);
    place.length = sizeof address;
    return place;
}

/// IPv4 first: "localhost" is where tev's clients look, and most of them do with IPv4.
Result<std::vector<Endpoint>> places_of(const LiveAddress& address, ErrorKind kind) {
    if (!address.unix_path.empty()) return std::vector<Endpoint>{unix_place(address.unix_path)};
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    const int status = getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &hints, &found);
    if (status != 0)
        return Error{kind,
                     fmt::format("there is no machine '{}': {}", address.host, gai_strerror(status)),
                     {},
                     {},
                     "check its name, or give its number, such as 127.0.0.1"};
    const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owner(found, freeaddrinfo);
    std::vector<Endpoint> places;
    for (const addrinfo* one = found; one != nullptr; one = one->ai_next) {
        if (one->ai_addrlen > sizeof(sockaddr_storage)) continue;
        Endpoint place;
        std::memcpy(&place.storage, one->ai_addr, one->ai_addrlen);
        place.length = one->ai_addrlen;
        places.push_back(place);
    }
    std::stable_partition(places.begin(), places.end(), [](const Endpoint& p) { return p.family() == AF_INET; });
    return places;
}

bool is_loopback(const Endpoint& place) {
    if (place.family() == AF_UNIX) return true;
    if (place.family() == AF_INET) {
        sockaddr_in address{};
        std::memcpy(&address, &place.storage, sizeof address);
        return ntohl(address.sin_addr.s_addr) >> 24U == 127U;
    }
    sockaddr_in6 address{};
    std::memcpy(&address, &place.storage, sizeof address);
    return IN6_IS_ADDR_LOOPBACK(&address.sin6_addr) != 0;
}

Descriptor new_socket(const Endpoint& place) {
    return Descriptor(::socket(place.family(), SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
}

/// Removes the socket that a program left behind which is no more: one that nobody answers.
void remove_stale(const Endpoint& place, const std::string& path) {
    struct stat status {};
    if (::lstat(path.c_str(), &status) != 0 || !S_ISSOCK(status.st_mode)) return;
    const Descriptor probe = new_socket(place);
    if (::connect(probe.number(), place.address(), place.length) != 0 && errno == ECONNREFUSED) ::unlink(path.c_str());
}

std::uint16_t port_of(const Descriptor& socket) {
    Endpoint place;
    place.length = sizeof place.storage;
    getsockname(socket.number(), reinterpret_cast<sockaddr*>(&place.storage), &place.length);
    if (place.family() == AF_INET6) {
        sockaddr_in6 address{};
        std::memcpy(&address, &place.storage, sizeof address);
        return ntohs(address.sin6_port);
    }
    sockaddr_in address{};
    std::memcpy(&address, &place.storage, sizeof address);
    return ntohs(address.sin_port);
}

Error not_listening(const LiveAddress& address, int error) {
    if (error != EADDRINUSE)
        return {ErrorKind::usage,
                fmt::format("cannot listen at {}: {}", address.text(), reason(error)),
                {},
                {},
                "an address of this machine, for example 127.0.0.1:14158"};
    if (!address.unix_path.empty())
        return {ErrorKind::usage,
                fmt::format("{} is there already", address.unix_path),
                {},
                {},
                "another program listens there, or it is no socket; choose another path"};
    LiveAddress other = address;
    other.port = static_cast<std::uint16_t>(address.port == 65535 ? tev::default_port : address.port + 1);
    return {ErrorKind::usage,
            fmt::format("tev or another program has port {}", address.port),
            {},
            {},
            fmt::format("use --listen {}", other.text())};
}

/// 0, or why not.
int bind_and_listen(const Descriptor& socket, const Endpoint& place, const LiveAddress& address) {
    constexpr int waiting = 16;
    const int on = 1;
    // Whoever restarts need not wait until old connections are forgotten; two listeners are still impossible.
    if (place.family() != AF_UNIX) setsockopt(socket.number(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    if (::bind(socket.number(), place.address(), place.length) != 0) return errno;
    // Before anybody can connect: for this user alone.
    if (!address.unix_path.empty() && ::chmod(address.unix_path.c_str(), S_IRUSR | S_IWUSR) != 0) return errno;
    return ::listen(socket.number(), waiting) == 0 ? 0 : errno;
}

/// 0, or why not. Waits in slices, so that `give_up` is heard.
int finish_connecting(const Descriptor& socket, double seconds, const std::function<bool()>& give_up) {
    constexpr int slice_ms = 100;
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    do {
        pollfd waiting{socket.number(), POLLOUT, 0};
        if (::poll(&waiting, 1, slice_ms) > 0) {
            int error = 0;
            socklen_t length = sizeof error;
            getsockopt(socket.number(), SOL_SOCKET, SO_ERROR, &error, &length);
            return error;
        }
    } while (!give_up() && std::chrono::steady_clock::now() < end);
    return ETIMEDOUT;
}

}  // namespace

Descriptor::~Descriptor() {
    if (number_ >= 0) ::close(number_);
}

Result<Descriptor> listen_at(LiveAddress& address, bool anywhere) {
    POL_TRY(const auto places, places_of(address, ErrorKind::usage));
    if (!anywhere && !std::all_of(places.begin(), places.end(), is_loopback))
        return Error{ErrorKind::usage,
                     fmt::format("{} can be reached from other machines, and nobody is asked who he is", address.host),
                     {},
                     {},
                     "use 127.0.0.1, or --listen-anywhere if that is meant"};
    int error = EADDRNOTAVAIL;
    for (const Endpoint& place : places) {
        if (place.family() == AF_UNIX) remove_stale(place, address.unix_path);
        Descriptor socket = new_socket(place);
        error = socket ? bind_and_listen(socket, place, address) : errno;
        if (error != 0) continue;
        if (place.family() != AF_UNIX) address.port = port_of(socket);
        return socket;
    }
    return not_listening(address, error);
}

Result<Descriptor> connect_to(const LiveAddress& address, double seconds, const std::function<bool()>& give_up) {
    POL_TRY(const auto places, places_of(address, ErrorKind::output));
    int error = EADDRNOTAVAIL;
    for (const Endpoint& place : places) {
        Descriptor socket = new_socket(place);
        if (!socket) {
            error = errno;
            continue;
        }
        error = ::connect(socket.number(), place.address(), place.length) == 0 ? 0 : errno;
        if (error == EINPROGRESS) error = finish_connecting(socket, seconds, give_up);
        if (error == 0) return socket;
    }
    return Error{ErrorKind::output,
                 fmt::format("nobody listens at {}: {}", address.text(), reason(error)),
                 {},
                 {},
                 "start tev, or polariscope view --listen"};
}

}  // namespace pol
