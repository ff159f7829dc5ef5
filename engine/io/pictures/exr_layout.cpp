// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/exr_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "core/result.h"
#include "io/pictures/exr_channel.h"
#include "io/pictures/exr_parts.h"

namespace pol::exr {
namespace {

Error input_error(std::string what, std::string hint) {
    return Error{ErrorKind::input, std::move(what), {}, {}, std::move(hint)};
}

/// By wavelength. Error: two names, such as S0.580nm and S0.0,58um, mean one.
Result<Layer> layer_of(const std::vector<std::string>& names, const std::string& layer) {
    Layer channels;
    for (const std::string& name : names) {
        if (!name.starts_with(layer + ".")) continue;
        const std::optional<double> wavelength =
            parse_wavelength_suffix(std::string_view(name).substr(layer.size() + 1));
        if (!wavelength) continue;
        const auto [found, is_new] = channels.emplace(*wavelength, name);
        if (!is_new)
            return input_error(fmt::format("channels {} and {} are of one wavelength", found->second, name),
                               "keep one of them");
    }
    return channels;
}

Result<std::vector<std::string>> share_channels(const std::vector<std::string>& names, const std::string& layer,
                                                const Layer& stokes) {
    if (std::find(names.begin(), names.end(), layer) != names.end()) return std::vector<std::string>{layer};
    std::vector<std::string> channels;
    POL_TRY(const auto found, layer_of(names, layer));
    if (found.empty()) return channels;
    for (const auto& [wavelength, name] : stokes) {
        const auto channel = found.find(wavelength);
        if (channel == found.end()) {
            return input_error(fmt::format("channel {}.{} is missing", layer, wavelength_suffix(wavelength)),
                               "render it again");
        }
        channels.push_back(channel->second);
    }
    return channels;
}

/// The first few names, for a message.
std::string some_of(const std::vector<std::string>& names) {
    constexpr std::size_t shown = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(shown, names.size()); ++i) {
        if (i > 0) text += ", ";
        text += names[i];
    }
    return names.size() > shown ? text + ", ..." : text;
}

/// "R, G, B" if there are S0.R to S3.B, "" if S0 to S3 stand alone.
std::optional<std::string> bands_of(const std::vector<std::string>& names) {
    const auto has_all = [&](const std::string& band) {
        return std::all_of(stokes_layers.begin(), stokes_layers.end(), [&](const StokesLayer& layer) {
            return std::find(names.begin(), names.end(), layer.name + band) != names.end();
        });
    };
    std::vector<std::string> bands;
    const std::string first = stokes_layers[0].name;
    for (const std::string& name : names)
        if (name.starts_with(first + ".") && has_all(name.substr(first.size())))
            bands.push_back(name.substr(first.size() + 1));
    if (bands.empty() && !has_all("")) return std::nullopt;
    return some_of(bands);
}

Error no_spectral_stokes(const std::vector<std::string>& names) {
    const char* hint = "expected S0.580,000000nm to S3.580,000000nm (Fichet, Pacanowski & Wilkie 2021)";
    const std::optional<std::string> bands = bands_of(names);
    if (!bands) return input_error(fmt::format("no Stokes channels; found {}", some_of(names)), hint);
    if (bands->empty()) return input_error("has S0 to S3 without a wavelength; such pictures are not read yet", hint);
    return input_error(
        fmt::format("has S0 to S3 in the bands {}, as Mitsuba writes them; such pictures are not read yet", *bands),
        hint);
}

/// What keeps S0 to S3 from being a Stokes picture.
std::optional<Error> stokes_problem(const std::array<Layer, 4>& stokes, const std::vector<std::string>& names) {
    const auto is_empty = [](const Layer& layer) { return layer.empty(); };
    if (std::all_of(stokes.begin(), stokes.end(), is_empty)) return no_spectral_stokes(names);
    if (std::all_of(stokes.begin() + 1, stokes.end(), is_empty))
        return input_error("has S0 alone: this picture has no polarization", "S1, S2 and S3 are needed beside it");
    for (std::size_t s = 0; s < stokes.size(); ++s) {
        for (const Layer& other : stokes) {
            for (const auto& [wavelength, name] : other) {
                if (stokes[s].contains(wavelength)) continue;
                return input_error(fmt::format("{} has no channel for {}", stokes_layers[s].name, name),
                                   "S0, S1, S2 and S3 must have the same wavelengths");
            }
        }
    }
    return std::nullopt;
}

}  // namespace

Result<Layout> layout_of(const Parts& parts) {
    const std::vector<std::string> names = parts.names();
    Layout layout;
    for (std::size_t s = 0; s < layout.stokes.size(); ++s) {
        POL_TRY(auto layer, layer_of(names, stokes_layers[s].name));
        layout.stokes[s] = std::move(layer);
    }
    if (const auto problem = stokes_problem(layout.stokes, names)) return *problem;

    POL_TRY(auto residual, share_channels(names, "residual", layout.stokes[0]));
    layout.residual = residual;
    POL_TRY(auto tail, share_channels(names, "tail", layout.stokes[0]));
    layout.tail = tail;
    for (std::size_t s = 0; s < layout.stokes.size(); ++s) {
        const std::string layer = std::string(sampling_error_layer) + "." + stokes_layers[s].name;
        POL_TRY(auto channels, share_channels(names, layer, layout.stokes[s]));
        layout.sampling_error[s] = channels;
        const std::size_t expected = layout.sampling_error[0].empty() ? 0 : layout.stokes[0].size();
        if (layout.sampling_error[s].size() != expected)
            return input_error(fmt::format("{} does not have the channels of {}", layer, stokes_layers[0].name),
                               "render it again");
    }
    for (const char* count : {"samples", "failures"})
        if (std::find(names.begin(), names.end(), count) != names.end()) layout.counts.emplace_back(count);

    for (const std::string& handedness : parts.texts(handedness_attribute)) {
        layout.left_handed = handedness == "left";
        if (handedness != "left" && handedness != "right")
            return input_error(fmt::format("polarisationHandedness is '{}'", handedness), "expected left or right");
    }
    if (parts.texts(handedness_attribute).size() > 1)
        return input_error("polarisationHandedness is left in one part, right in another", "give all parts the same");
    return layout;
}

}  // namespace pol::exr
