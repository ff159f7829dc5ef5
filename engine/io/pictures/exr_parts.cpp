// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/exr_parts.h"

#include <ImfCompression.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include "io/pictures/picture_reading.h"

namespace pol::exr {
namespace {

std::string window_text(const Imath::Box2i& window) {
    return fmt::format("({}, {}) to ({}, {})", window.min.x, window.min.y, window.max.x, window.max.y);
}

/// The DWA kinds make halves of these channels and pack them; they keep all others (OpenEXR 3.1, rules of channels of
/// its DWA compressor).
bool is_packed_by_dwa(const std::string& name) {
    constexpr std::array<std::string_view, 6> packed{"R", "G", "B", "Y", "RY", "BY"};
    const std::size_t dot = name.rfind('.');
    const std::string_view last = std::string_view(name).substr(dot == std::string::npos ? 0 : dot + 1);
    return std::find(packed.begin(), packed.end(), last) != packed.end();
}

/// PXR24 drops the last 8 bits of floats, B44 and B44A pack halves; neither touches the other types.
StoredNumbers stored_as(const std::string& name, Imf::PixelType type, Imf::Compression compression) {
    if (type == Imf::UINT) return {32, {}, 1.0};
    const bool is_dwa = compression == Imf::DWAA_COMPRESSION || compression == Imf::DWAB_COMPRESSION;
    if (is_dwa && is_packed_by_dwa(name)) return {16, compression == Imf::DWAA_COMPRESSION ? "DWAA" : "DWAB"};
    if (type == Imf::FLOAT) return {compression == Imf::PXR24_COMPRESSION ? 24 : 32, {}};
    if (compression == Imf::B44_COMPRESSION) return {16, "B44"};
    if (compression == Imf::B44A_COMPRESSION) return {16, "B44A"};
    return {16, {}};
}

}  // namespace

Parts::Parts(const Imf::MultiPartInputFile& file) {
    for (int part = 0; part < file.parts(); ++part) {
        const Imf::Header& header = file.header(part);
        headers_.emplace(part, header);
        for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
            Found& found = channels_[channel.name()];
            found.parts.push_back(part);
            found.channel = channel.channel();
        }
    }
}

std::vector<std::string> Parts::names() const {
    std::vector<std::string> names;
    for (const auto& [name, found] : channels_) names.push_back(name);
    return names;
}

std::vector<std::string> Parts::texts(const std::string& attribute) const {
    std::vector<std::string> values;
    for (const auto& [part, header] : headers_) {
        const auto* found = header.findTypedAttribute<Imf::StringAttribute>(attribute);
        if (found != nullptr && std::find(values.begin(), values.end(), found->value()) == values.end())
            values.push_back(found->value());
    }
    return values;
}

std::string Parts::text(const std::string& attribute) const {
    const std::vector<std::string> values = texts(attribute);
    return values.empty() ? std::string() : values.front();
}

Result<std::map<std::string, int>> Parts::locate(const std::vector<std::string>& channels) const {
    std::map<std::string, int> places;
    for (const std::string& name : channels) {
        const Found& found = channels_.at(name);
        const int part = found.parts.front();
        if (found.parts.size() > 1)
            return input_error(fmt::format("parts {} and {} both have a channel {}", part, found.parts[1], name),
                               "write each picture or view into a file of its own");
        if (header(part).hasType() && !Imf::isImage(header(part).type()))
            return input_error(fmt::format("channel {} is deep: any number of samples a pixel", name),
                               "write it flattened: one value a pixel is read");
        const Imf::Channel& channel = found.channel;
        if (channel.xSampling != 1 || channel.ySampling != 1)
            return input_error(fmt::format("channel {} has sampling {} x {}; only full resolution is read", name,
                                           channel.xSampling, channel.ySampling),
                               "write all channels at full resolution");
        places.emplace(name, part);
        const int first = places.at(channels.front());
        if (header(part).dataWindow() != header(first).dataWindow())
            return input_error(
                fmt::format("part {} holds the pixels {}, part {} {}", first, window_text(header(first).dataWindow()),
                            part, window_text(header(part).dataWindow())),
                "S0 to S3 must be there in the same pixels: give their parts one data window");
    }
    return places;
}

StoredNumbers Parts::stored(const std::vector<std::string>& channels) const {
    StoredNumbers coarsest;
    for (const std::string& name : channels) {
        const Found& found = channels_.at(name);
        StoredNumbers stored = stored_as(name, found.channel.type, header(found.parts.front()).compression());
        coarsest.bits = std::min(coarsest.bits, stored.bits);
        coarsest.spacing = std::max(coarsest.spacing, stored.spacing);
        if (coarsest.lossy.empty()) coarsest.lossy = std::move(stored.lossy);
    }
    return coarsest;
}

}  // namespace pol::exr
