// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/exr_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/result.h"
#include "io/pictures/convention_text.h"
#include "io/pictures/exr_channel.h"
#include "io/pictures/exr_origin.h"
#include "io/pictures/exr_parts.h"
#include "io/pictures/picture_reading.h"

namespace pol::exr {
namespace {

/// `names` ascend.
bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::binary_search(names.begin(), names.end(), name);
}

/// "580,000000nm" of "S0.580,000000nm": what the other layers of a band of ours have behind their dots.
std::string suffix_of(const BandChannels& band) {
    for (const std::string& name : band.names)
        if (const std::size_t dot = name.find('.'); dot != std::string::npos) return name.substr(dot + 1);
    return {};
}

/// The channels LAYER.BAND of all bands, or of none, or LAYER alone.
Result<std::vector<std::string>> share_channels(const std::vector<std::string>& names, const std::string& layer,
                                                const std::vector<BandChannels>& bands) {
    if (has(names, layer)) return std::vector<std::string>{layer};
    std::vector<std::string> channels;
    std::vector<std::string> missing;
    for (const BandChannels& band : bands) {
        const std::string name = layer + "." + suffix_of(band);
        (has(names, name) ? channels : missing).push_back(name);
    }
    if (channels.empty() || missing.empty()) return channels;
    return input_error(fmt::format("channel {} is missing", missing.front()), "render it again");
}

Result<std::vector<std::array<std::string, 4>>> error_channels(const std::vector<std::string>& names,
                                                               const std::vector<BandChannels>& bands) {
    std::vector<std::array<std::string, 4>> channels(bands.size());
    std::optional<std::string> missing;
    bool has_any = false;
    for (std::size_t b = 0; b < bands.size(); ++b) {
        for (std::size_t s = 0; s < stokes_layers.size(); ++s) {
            if (bands[b].names[s].empty()) continue;
            const std::string name =
                fmt::format("{}.{}.{}", sampling_error_layer, stokes_layers[s].name, suffix_of(bands[b]));
            const bool is_there = has(names, name);
            if (is_there) channels[b][s] = name;
            if (!is_there && !missing) missing = name;
            has_any = has_any || is_there;
        }
    }
    if (!has_any) return std::vector<std::array<std::string, 4>>();
    if (missing) return input_error(fmt::format("channel {} is missing", *missing), "render it again");
    return channels;
}

/// A part of a distributed render: sums, not a picture.
std::optional<Error> part_problem(const Parts& parts) {
    const std::string part = parts.text(part_attribute);
    if (part.empty()) return std::nullopt;
    const std::size_t slash = part.find('/');
    if (slash == std::string::npos)
        return input_error(fmt::format("this is part {} of a picture", part), "merge it with the others first");
    return input_error(fmt::format("this is part {} of {}", part.substr(0, slash), part.substr(slash + 1)),
                       "merge it with the others first");
}

Result<StokesChannels> stokes_channels_of(const Parts& parts, const Wish& wish) {
    const std::vector<std::string> names = parts.names();
    if (wish.is_one_component) return find_component_channels(names);
    if (wish.layout.empty() && !parts.text(bands_attribute).empty())
        return own_channels(parts.text(bands_attribute), names);
    POL_TRY(auto channels, find_stokes_channels(names, parts.text("generatedBy"), wish.layout));
    const std::vector<double> exact = parse_numbers(parts.text(wavelengths_attribute));
    const auto is_rounded = [](double wavelength, const BandChannels& channel) {
        return channel.band.wavelength_nm &&
               wavelength_suffix(wavelength) == wavelength_suffix(*channel.band.wavelength_nm);
    };
    if (std::equal(exact.begin(), exact.end(), channels.bands.begin(), channels.bands.end(), is_rounded))
        for (std::size_t b = 0; b < exact.size(); ++b) channels.bands[b].band.wavelength_nm = exact[b];
    return channels;
}

}  // namespace

std::vector<std::string> Layout::stokes_channels() const {
    std::vector<std::string> channels;
    for (std::size_t s = 0; s < stokes_layers.size(); ++s)
        for (const BandChannels& band : stokes.bands)
            if (!band.names[s].empty()) channels.push_back(band.names[s]);
    return channels;
}

std::vector<std::string> Layout::channels() const {
    std::vector<std::string> channels = stokes_channels();
    for (const auto* list : {&residual, &tail, &counts}) channels.insert(channels.end(), list->begin(), list->end());
    for (const auto& band : sampling_error)
        for (const std::string& name : band)
            if (!name.empty()) channels.push_back(name);
    return channels;
}

Result<Layout> layout_of(const Parts& parts, const Wish& wish) {
    if (const auto problem = part_problem(parts)) return *problem;
    Layout layout;
    POL_TRY(layout.stokes, stokes_channels_of(parts, wish));
    PictureOrigin& origin = layout.stokes.origin;
    if (!parts.text(frame_attribute).empty()) std::erase(origin.assumed, assumed_axes);
    const std::vector<std::string> handednesses = parts.texts(handedness_attribute);
    for (const std::string& handedness : handednesses) {
        layout.left_handed = handedness == "left";
        if (handedness != "left" && handedness != "right")
            return input_error(fmt::format("polarisationHandedness is '{}'", handedness), "expected left or right");
    }
    if (handednesses.size() > 1)
        return input_error("polarisationHandedness is left in one part, right in another", "give all parts the same");
    if (!handednesses.empty()) std::erase(origin.assumed, assumed_handedness);
    origin.convention.left_handed = layout.left_handed;
    POL_TRY_DONE(take_own_origin(parts, origin));

    if (const std::vector<std::string> texts = parts.texts(convention_attribute); !texts.empty()) {
        layout.convention = convention_of(texts.front());
        if (texts.size() > 1 || !layout.convention)
            return input_error(fmt::format("{} is not understood: '{}'", convention_attribute, texts.back()),
                               "was it changed by another program? convert the picture again");
        layout.left_handed = false;  // said once
        origin.convention = *layout.convention;
        std::erase(origin.assumed, assumed_axes);
        std::erase(origin.assumed, assumed_handedness);
    }

    const bool may_be_ours = layout.stokes.bands.front().band.wavelength_nm || !parts.text(bands_attribute).empty();
    if (!may_be_ours) return layout;  // "samples" of others is not what we mean by it
    const std::vector<std::string> names = parts.names();
    POL_TRY(layout.residual, share_channels(names, "residual", layout.stokes.bands));
    POL_TRY(layout.tail, share_channels(names, "tail", layout.stokes.bands));
    POL_TRY(layout.sampling_error, error_channels(names, layout.stokes.bands));
    for (const char* count : {"samples", "failures"})
        if (has(names, count)) layout.counts.emplace_back(count);
    return layout;
}

}  // namespace pol::exr
