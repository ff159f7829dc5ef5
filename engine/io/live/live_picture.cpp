// SPDX-License-Identifier: Apache-2.0
#include "io/live/live_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/contract.h"
#include "core/result.h"
#include "io/live/utf8.h"
#include "io/pictures/stokes_channels.h"

namespace pol {
namespace {

/// One "key=value" of a name; false if it is none.
bool read_wish(std::string_view wish, LiveName& name) {
    StokesConvention convention = name.convention.value_or(StokesConvention{});
    if (wish == "handedness=left" || wish == "handedness=right") {
        convention.left_handed = wish.ends_with("left");
    } else if (wish == "y=down" || wish == "y=up") {
        convention.y_down = wish.ends_with("down");
    } else if (wish == "zero=up" || wish == "zero=right") {
        convention.azimuth_zero_deg = wish.ends_with("up") ? 90.0 : 0.0;
    } else {
        constexpr std::string_view layout = "layout=";
        if (!wish.starts_with(layout) || wish.size() == layout.size()) return false;
        name.layout = wish.substr(layout.size());
        return true;
    }
    name.convention = convention;
    return true;
}

/// Which channel of an update brings which component.
using Sources = std::array<std::optional<std::size_t>, 4>;

/// The numbers of one band. The convention is taken back first: one component of ours may need two of theirs.
void apply_band(const tev::UpdateImage& update, const Sources& sources, std::size_t band, StokesImage& image) {
    const StokesConvention& convention = image.origin.convention;
    const bool is_ours = convention == StokesConvention{};
    std::size_t i = 0;
    for (int y = update.rect.y0; y < update.rect.y1; ++y) {
        for (int x = update.rect.x0; x < update.rect.x1; ++x, ++i) {
            Stokes<double>& ours = image.stokes[band * image.pixel_count() + image.pixel(x, y)];
            Stokes<double> theirs = is_ours ? ours : convention.from_ours(ours);
            for (std::size_t s = 0; s < sources.size(); ++s)
                if (sources[s]) theirs.*stokes_components[s] = static_cast<double>(update.at(*sources[s], i));
            ours = is_ours ? theirs : convention.to_ours(theirs);
        }
    }
}

}  // namespace

LiveName read_live_name(std::string_view name) {
    LiveName read;
    read.shown = name;
    const std::size_t bar = name.rfind('|');
    if (bar == std::string_view::npos) return read;
    std::string_view rest = name.substr(bar + 1);
    LiveName understood;
    understood.shown = name.substr(0, bar);
    while (true) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        if (!read_wish(rest.substr(0, comma), understood)) {
            read.problem = fmt::format("{} in the name was not understood, and taken for a part of the name",
                                       tev::quoted_name(rest.substr(0, comma)));
            return read;
        }
        if (comma == rest.size()) return understood;
        rest.remove_prefix(comma + 1);
    }
}

LivePicture::LivePicture(const tev::CreateImage& message)
    : key_(message.name), name_(read_live_name(message.name)), width_(message.width), height_(message.height) {
    for (const std::string& channel : message.channels) channels_[channel] = std::nullopt;
    const auto found = find_stokes_channels(message.channels, "", name_.layout);
    if (found) {
        origin_ = found.value().origin;
        for (const BandChannels& one : found.value().bands) {
            for (unsigned s = 0; s < stokes_components.size(); ++s) {
                const auto channel = channels_.find(one.names[s]);
                if (one.band.known.has(s) && channel != channels_.end()) channel->second = Slot{bands_.size(), s};
            }
            bands_.push_back(one.band);
        }
    } else {
        show_colour(message.channels);
        const Error& why = found.error();
        origin_.remarks.push_back(
            fmt::format("shown without polarization: {}{}{}", why.what, why.hint.empty() ? "" : "; ", why.hint));
    }
    if (name_.convention) origin_.convention = *name_.convention;
    if (!name_.problem.empty()) origin_.remarks.push_back(name_.problem);
}

void LivePicture::show_colour(const std::vector<std::string>& names) {
    constexpr std::size_t most = 16;
    std::vector<std::string> shown{"R", "G", "B"};
    const auto is_there = [&](const std::string& name) { return channels_.contains(name); };
    if (!std::all_of(shown.begin(), shown.end(), is_there))
        shown.assign(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(most, names.size())));
    for (const std::string& name : shown) {
        channels_[name] = Slot{bands_.size(), 0};
        bands_.push_back(named_band(name, StokesComponents::s0()));
    }
    origin_.layout = "colour, sent by another program";
    if (names.size() > shown.size())
        origin_.remarks.push_back(
            fmt::format("{} of its {} channels are not shown", names.size() - shown.size(), names.size()));
}

double LivePicture::bytes() const {
    return static_cast<double>(width_) * static_cast<double>(height_) * static_cast<double>(bands_.size()) *
           static_cast<double>(sizeof(Stokes<double>));
}

StokesImage LivePicture::blank() const {
    StokesImage image;
    image.width = width_;
    image.height = height_;
    image.bands = bands_;
    image.origin = origin_;
    image.stokes.resize(image.pixel_count() * bands_.size());
    return image;
}

std::optional<tev::Fault> LivePicture::fault_of(const tev::UpdateImage& update) const {
    if (update.rect.x1 > width_ || update.rect.y1 > height_) return tev::Fault::rectangle;
    const auto is_missing = [&](const std::string& name) { return !channels_.contains(name); };
    if (std::any_of(update.channels.begin(), update.channels.end(), is_missing)) return tev::Fault::channel;
    return std::nullopt;
}

bool LivePicture::apply(const tev::UpdateImage& update, StokesImage& image) const {
    POL_EXPECTS(!fault_of(update) && image.width == width_ && image.height == height_ &&
                image.stokes.size() == image.pixel_count() * bands_.size());
    std::map<std::size_t, Sources> by_band;
    for (std::size_t c = 0; c < update.channels.size(); ++c)
        if (const auto& slot = channels_.find(update.channels[c])->second) by_band[slot->band][slot->component] = c;
    for (const auto& [band, sources] : by_band) apply_band(update, sources, band, image);
    return !by_band.empty();
}

void LivePicture::apply(const tev::Attributes& attributes, StokesImage& image) const {
    const std::size_t most = tev::MessageLimits{}.attributes;
    for (const auto& [key, value] : attributes.texts)
        if (image.attributes.size() < most || image.attributes.contains(key)) image.attributes[key] = value;
    for (const auto& [key, value] : attributes.texts) {
        if (key != "polarisationHandedness" || (value != "left" && value != "right")) continue;
        StokesConvention convention = image.origin.convention;
        convention.left_handed = value == "left";
        read_in(image, convention);
    }
}

}  // namespace pol
