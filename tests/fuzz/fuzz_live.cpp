// SPDX-License-Identifier: Apache-2.0
// What a connection brings: whatever it is, messages come out whole, and pictures take only what fits them.
#include <cstdlib>
#include <map>
#include <memory>
#include <span>
#include <variant>

#include "fuzz/fuzz_input.h"
#include "io/live/live_picture.h"
#include "io/live/message_stream.h"

namespace pol {
namespace {

struct Shown {
    LivePicture picture;
    StokesImage image;
};

void show(const tev::Message& message, std::map<std::string, Shown>& pictures) {
    constexpr double most_bytes = 1e6;
    if (const auto* create = std::get_if<tev::CreateImage>(&message)) {
        const LivePicture picture(*create);
        if (picture.bytes() > most_bytes || pictures.size() > 8) return;
        pictures.insert_or_assign(create->name, Shown{picture, picture.blank()});
        if (tev::encode(*create).size() < tev::shortest_message) std::abort();
    } else if (const auto* update = std::get_if<tev::UpdateImage>(&message)) {
        const auto found = pictures.find(update->name);
        if (found == pictures.end() || found->second.picture.fault_of(*update)) return;
        found->second.picture.apply(*update, found->second.image);
    } else if (const auto* attributes = std::get_if<tev::Attributes>(&message)) {
        const auto found = pictures.find(attributes->name);
        if (found != pictures.end()) found->second.picture.apply(*attributes, found->second.image);
    }
}

}  // namespace
}  // namespace pol

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = std::as_bytes(std::span(data, size));
    std::map<std::string, pol::Shown> pictures;
    pol::tev::MessageStream stream(pol::tev::MessageLimits{});
    const auto take = [&](const std::vector<std::byte>& message) {
        if (message.empty()) return;
        const auto decoded = pol::tev::decode(message);
        if (const auto* good = std::get_if<pol::tev::Message>(&decoded)) pol::show(*good, pictures);
    };
    // Cut in two: where must not matter for anything but what memory is touched.
    const std::size_t middle = size / 2;
    if (stream.feed(bytes.first(middle), take)) static_cast<void>(stream.feed(bytes.subspan(middle), take));
    if (stream.waiting() > size) std::abort();
    return 0;
}
