// SPDX-License-Identifier: Apache-2.0
#include "io/live/live_desk.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace pol {
namespace {

/// The picture that a message is about. Requires: an update, attributes, or a farewell.
const std::string& named_by(const tev::Message& message) {
    if (const auto* update = std::get_if<tev::UpdateImage>(&message)) return update->name;
    if (const auto* attributes = std::get_if<tev::Attributes>(&message)) return attributes->name;
    return std::get<tev::CloseImage>(message).name;
}

}  // namespace

void LiveDesk::remove(std::map<std::string, Entry>::iterator entry) {
    bytes_ -= entry->second.bytes;
    pictures_.erase(entry);
}

LiveDesk::Answer LiveDesk::create(const tev::CreateImage& message, double message_bytes, double more_bytes) {
    Entry entry{next_, 0.0, std::make_shared<const LivePicture>(message)};
    // Names of channels may take more than a small picture.
    entry.bytes = entry.picture->bytes() + message_bytes;
    const auto former = pictures_.find(message.name);
    const bool replaces = former != pictures_.end();
    const double others = bytes_ - (replaces ? former->second.bytes : 0.0);
    if (entry.bytes > rules_.picture_bytes || others + entry.bytes + more_bytes > rules_.all_bytes ||
        (!replaces && pictures_.size() >= rules_.pictures))
        return tev::Fault::memory;
    LiveCreated created{next_++, std::nullopt, entry.picture, message.grab_focus};
    if (replaces) {
        created.replaces = former->second.id;
        remove(former);
    }
    bytes_ += entry.bytes;
    pictures_.emplace(message.name, std::move(entry));
    return std::optional<LiveEvent>(std::move(created));
}

LiveDesk::Answer LiveDesk::open(const std::string& path, bool again, bool grab_focus) const {
    namespace fs = std::filesystem;
    if (rules_.open_folder.empty()) return tev::Fault::open;
    std::error_code failed;
    const fs::path folder = fs::canonical(rules_.open_folder, failed);
    if (failed) return tev::Fault::open;
    // Links are followed before anything is compared.
    const fs::path file = fs::canonical(folder / path, failed);
    if (failed || !fs::is_regular_file(file, failed)) return tev::Fault::open;
    if (std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first != folder.end())
        return tev::Fault::open;
    return std::optional<LiveEvent>(LiveOpened{file, again, grab_focus});
}

std::variant<std::optional<LiveEvent>, tev::Fault> LiveDesk::receive(std::vector<std::byte> message,
                                                                     double more_bytes) {
    auto decoded = tev::decode(message, rules_.message);
    if (const auto* fault = std::get_if<tev::Fault>(&decoded)) return *fault;
    auto& what = std::get<tev::Message>(decoded);

    if (const auto* create_it = std::get_if<tev::CreateImage>(&what))
        return create(*create_it, static_cast<double>(message.size()), more_bytes);
    if (const auto* open_it = std::get_if<tev::OpenImage>(&what))
        return open(open_it->path, false, open_it->grab_focus);
    if (const auto* reload = std::get_if<tev::ReloadImage>(&what)) return open(reload->name, true, reload->grab_focus);
    if (std::holds_alternative<tev::VectorGraphics>(what)) return std::optional<LiveEvent>();

    const auto entry = pictures_.find(named_by(what));
    if (entry == pictures_.end()) return tev::Fault::picture;
    const LivePictureId id = entry->second.id;
    if (auto* attributes = std::get_if<tev::Attributes>(&what))
        return std::optional<LiveEvent>(LiveDescribed{id, std::move(*attributes)});
    if (auto* update = std::get_if<tev::UpdateImage>(&what)) {
        if (const auto fault = entry->second.picture->fault_of(*update)) return *fault;
        return std::optional<LiveEvent>(std::in_place, std::in_place_type<LiveUpdated>, id, std::move(message),
                                        std::move(*update));
    }
    remove(entry);
    return std::optional<LiveEvent>(LiveClosed{id});
}

void LiveDesk::forget(LivePictureId id) {
    const auto is_it = [&](const auto& entry) { return entry.second.id == id; };
    const auto entry = std::find_if(pictures_.begin(), pictures_.end(), is_it);
    if (entry != pictures_.end()) remove(entry);
}

}  // namespace pol
