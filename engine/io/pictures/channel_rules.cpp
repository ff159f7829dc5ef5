// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/channel_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "io/pictures/exr_channel.h"
#include "io/pictures/picture_reading.h"

namespace pol::channels {
namespace {

constexpr std::array<std::string_view, 4> components{"S0", "S1", "S2", "S3"};
constexpr std::array<std::string_view, 3> colors{"R", "G", "B"};

bool has(const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string joined(std::string_view layer, std::string_view name) {
    return layer.empty() ? std::string(name) : fmt::format("{}.{}", layer, name);
}

/// "stokes" and "S0" of "stokes.S0".
std::pair<std::string_view, std::string_view> split(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos) return {{}, name};
    return {name.substr(0, dot), name.substr(dot + 1)};
}

void assume_everything(PictureOrigin& origin, StokesComponents known) {
    if (known.has(1)) origin.assumed.emplace_back(assumed_axes);
    if (known.has(3)) origin.assumed.emplace_back(assumed_handedness);
}

/// Wavelength in nm and name, ascending. Error: two names, such as S0.580nm and S0.0,58um, mean one.
Result<std::map<double, std::string>> wavelengths_in(const std::vector<std::string>& names, std::string_view layer) {
    std::map<double, std::string> channels;
    for (const std::string& name : names) {
        if (!name.starts_with(fmt::format("{}.", layer))) continue;
        const auto wavelength = parse_wavelength_suffix(std::string_view(name).substr(layer.size() + 1));
        if (!wavelength) continue;
        const auto [found, is_new] = channels.emplace(*wavelength, name);
        if (!is_new)
            return input_error(fmt::format("channels {} and {} are of one wavelength", found->second, name),
                               "keep one of them");
    }
    return channels;
}

/// The twelve, in the order in which Mitsuba has them in memory: S0.R S0.G S0.B S1.R ...
std::vector<std::string> mitsuba_names() {
    std::vector<std::string> names;
    for (const std::string_view s : components)
        for (const std::string_view color : colors) names.push_back(joined(s, color));
    return names;
}

/// R, G and B from twelve channels in that order.
std::vector<BandChannels> color_bands(const std::vector<std::string>& twelve) {
    std::vector<BandChannels> bands;
    for (std::size_t c = 0; c < colors.size(); ++c) {
        BandChannels& band = bands.emplace_back();
        band.band = named_band(colors[c]);
        for (std::size_t s = 0; s < components.size(); ++s) band.names[s] = twelve[3 * s + c];
    }
    return bands;
}

BandChannels s0_only(std::string_view band, std::string channel) {
    return {named_band(band, StokesComponents::s0()), {std::move(channel), {}, {}, {}}};
}

/// Channels of a specfilm, none of an hdrfilm. Those with a dot are of other integrators (aov).
std::vector<std::string> film_bands(const std::vector<std::string>& names) {
    constexpr std::string_view hdrfilm = "RGBAXYZ";
    std::vector<std::string> bands;
    for (const std::string& name : names)
        if (name.find('.') == std::string::npos) bands.push_back(name);
    const bool is_hdrfilm = std::all_of(bands.begin(), bands.end(), [&](const std::string& name) {
        return name.size() == 1 && hdrfilm.find(name[0]) != std::string_view::npos;
    });
    return is_hdrfilm ? std::vector<std::string>{} : bands;
}

/// Mitsuba skips four channels of the film, whatever it has: with n bands the labels are 4 - n places off (3.9.1).
Result<StokesChannels> specfilm(const std::vector<std::string>& film) {
    std::vector<std::string> twelve = mitsuba_names();
    StokesChannels channels;
    channels.origin.layout = "Mitsuba 3, specfilm";
    if (film.size() == 3) {
        std::rotate(twelve.begin(), twelve.begin() + 1, twelve.end());
        twelve.back().clear();
        channels.origin.remarks.emplace_back(
            "Mitsuba's labels were one place off, as they are with a specfilm of 3 bands: S0.R was found in S0.G, S0.G "
            "in S0.B, and so on; S3 of B is lost");
    } else if (film.size() != 4) {
        return input_error(
            fmt::format("was made by Mitsuba with a specfilm of {} band{}: its labels S0.R to S3.B are "
                        "{} places off and numbers are lost",
                        film.size(), film.size() == 1 ? "" : "s", film.size() < 4 ? 4 - film.size() : film.size() - 4),
            "render it with an hdrfilm, or a specfilm of 4 bands");
    }
    channels.bands = color_bands(twelve);
    if (film.size() == 3) channels.bands.back().band.known = StokesComponents::linear();
    channels.origin.remarks.emplace_back(remark_of_colors);
    for (const std::string& band : film) channels.bands.push_back(s0_only(band, band));
    return channels;
}

/// Names behind "S0." that have S1 and S2 beside them.
std::vector<std::string> named_bands(const std::vector<std::string>& names) {
    const std::set<std::string_view> all(names.begin(), names.end());
    std::vector<std::string> bands;
    for (const std::string& name : names) {
        if (!name.starts_with("S0.")) continue;
        std::string band = name.substr(3);
        if (!band.empty() && !parse_wavelength_suffix(band) && all.contains("S1." + band) && all.contains("S2." + band))
            bands.push_back(std::move(band));
    }
    return bands;
}

bool has_the_twelve(const std::vector<std::string>& names) {
    const std::vector<std::string> twelve = mitsuba_names();
    return std::all_of(twelve.begin(), twelve.end(), [&](const std::string& name) { return has(names, name); });
}

/// A place in S0 to S3, or in I, Q, U, V, in any case.
struct BareName {
    bool is_letter = false;
    std::size_t component = 0;
};
std::optional<BareName> bare_name(std::string_view name) {
    constexpr std::string_view letters = "iquv";
    const auto lower = [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); };
    if (name.size() == 1) {
        const std::size_t place = letters.find(lower(name[0]));
        if (place != std::string_view::npos) return BareName{true, place};
    }
    if (name.size() == 2 && lower(name[0]) == 's' && name[1] >= '0' && name[1] <= '3')
        return BareName{false, static_cast<std::size_t>(name[1] - '0')};
    return std::nullopt;
}

std::string_view without_mark(std::string_view name) {
    return name.starts_with('\x01') ? name.substr(1) : name;
}

std::vector<BandChannels> colors_of(const std::vector<std::string>& names, std::string_view layer) {
    std::vector<BandChannels> bands;
    for (const std::string_view color : colors)
        for (const std::string& name : names)
            if (without_mark(name) == joined(layer, color)) bands.push_back(s0_only(color, name));
    return bands.size() == colors.size() ? bands : std::vector<BandChannels>{};
}

/// True for S1 to S3, Q, U and V, alone or as a layer: such a channel is no picture of light.
bool is_polarization(std::string_view name) {
    while (!name.empty()) {
        const auto [rest, last] = split(name);
        const auto component = bare_name(last);
        if (component && component->component > 0) return true;
        name = rest;
    }
    return false;
}

/// S1, S2 or S3 in any layer: a picture that has one of them and did not fit lacks another one.
bool is_stokes_part(std::string_view name) {
    while (!name.empty()) {
        const auto [rest, last] = split(name);
        const bool is_part = last.size() == 2 && (last[0] == 'S' || last[0] == 's') && last[1] >= '1' && last[1] <= '3';
        if (is_part) return true;
        name = rest;
    }
    return false;
}

std::optional<Fit> plain_fit(std::vector<BandChannels> bands, std::vector<std::string> names) {
    for (const BandChannels& band : bands) std::erase(names, band.names[0]);
    std::erase(names, "A");
    StokesChannels channels;
    channels.bands = std::move(bands);
    channels.origin.layout = "picture without polarization";
    if (!names.empty()) channels.origin.remarks.push_back(fmt::format("channels not read: {}", some_of(names)));
    return Fit{std::move(channels)};
}

}  // namespace

std::string some_of(const std::vector<std::string>& names) {
    constexpr std::size_t shown = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(shown, names.size()); ++i) {
        if (i > 0) text += ", ";
        text += names[i];
    }
    return names.size() > shown ? text + ", ..." : text;
}

MaybeFit spectral(const std::vector<std::string>& names, std::string_view /*generator*/) {
    std::array<std::map<double, std::string>, 4> stokes;
    for (std::size_t s = 0; s < stokes.size(); ++s) {
        POL_TRY(auto layer, wavelengths_in(names, components[s]));
        stokes[s] = std::move(layer);
    }
    if (std::all_of(stokes.begin(), stokes.end(), [](const auto& layer) { return layer.empty(); }))
        return std::optional<Fit>();
    const bool has_s0_alone = stokes[1].empty() && stokes[2].empty() && stokes[3].empty();
    const std::size_t measured = has_s0_alone ? 1 : stokes[3].empty() ? 3 : 4;
    for (std::size_t s = 0; s < measured; ++s)
        for (const auto& other : stokes)
            for (const auto& [wavelength, name] : other)
                if (!stokes[s].contains(wavelength))
                    return input_error(fmt::format("{} has no channel for {}", components[s], name),
                                       "S0, S1, S2 and S3 must have the same wavelengths");
    Fit fit;
    fit.channels.origin.layout = "spectral layout";
    const StokesComponents known = measured == 1   ? StokesComponents::s0()
                                   : measured == 3 ? StokesComponents::linear()
                                                   : StokesComponents::all();
    for (const auto& [wavelength, name] : stokes[0]) {
        BandChannels& band = fit.channels.bands.emplace_back();
        band.band = {wavelength, {}, known};
        for (std::size_t s = 0; s < measured; ++s) band.names[s] = stokes[s].at(wavelength);
    }
    assume_everything(fit.channels.origin, known);
    return std::optional(std::move(fit));
}

MaybeFit mitsuba(const std::vector<std::string>& names, std::string_view generator) {
    if (!has_the_twelve(names)) return std::optional<Fit>();
    Fit fit;
    fit.is_certain = generator.starts_with("Mitsuba");
    const std::vector<std::string> film = film_bands(names);
    if (fit.is_certain && !film.empty()) {
        POL_TRY(fit.channels, specfilm(film));
        return std::optional(std::move(fit));
    }
    if (!fit.is_certain && named_bands(names).size() > colors.size()) return std::optional<Fit>();
    fit.channels.bands = color_bands(mitsuba_names());
    fit.channels.may_be_mono = true;
    fit.channels.origin.layout = "Mitsuba 3, RGB";
    fit.channels.origin.remarks.emplace_back(remark_of_colors);
    if (!fit.is_certain) assume_everything(fit.channels.origin, StokesComponents::all());
    return std::optional(std::move(fit));
}

MaybeFit mitsuba_array(const std::vector<std::string>& names, std::string_view /*generator*/) {
    constexpr std::size_t fewest = 12;
    constexpr std::size_t most = 16;
    if (names.size() < fewest || names.size() > most) return std::optional<Fit>();
    std::vector<std::string> ordered;
    for (std::size_t i = 0; i < names.size(); ++i) {
        ordered.push_back(fmt::format("ch{:02}", i));
        if (!has(names, ordered.back())) return std::optional<Fit>();
    }
    Fit fit;
    fit.channels.bands = color_bands({ordered.end() - fewest, ordered.end()});
    fit.channels.may_be_mono = true;
    fit.channels.origin.layout = "Mitsuba 3 array, RGB";
    fit.channels.origin.assumed.push_back(
        fmt::format("the {} channels have no names: {} to {} are taken by position for S0.R S0.G S0.B S1.R ... S3.B",
                    ordered.size(), ordered[ordered.size() - fewest], ordered.back()));
    fit.channels.origin.remarks.emplace_back(remark_of_colors);
    return std::optional(std::move(fit));
}

MaybeFit named(const std::vector<std::string>& names, std::string_view /*generator*/) {
    std::vector<std::string> bands = named_bands(names);
    if (bands.empty() || (has_the_twelve(names) && bands.size() == colors.size())) return std::optional<Fit>();
    const auto place = [](const std::string& band) { return std::find(colors.begin(), colors.end(), band); };
    std::stable_sort(bands.begin(), bands.end(),
                     [&](const std::string& a, const std::string& b) { return place(a) < place(b); });
    Fit fit;
    fit.channels.origin.layout = "Stokes components of named bands";
    StokesComponents known = StokesComponents::linear();
    const std::set<std::string_view> all(names.begin(), names.end());
    for (const std::string& name : bands) {
        BandChannels& band = fit.channels.bands.emplace_back();
        const bool has_s3 = all.contains("S3." + name);
        if (has_s3) known = StokesComponents::all();
        band.band = named_band(name, has_s3 ? StokesComponents::all() : StokesComponents::linear());
        for (std::size_t s = 0; s < (has_s3 ? 4U : 3U); ++s) band.names[s] = joined(components[s], name);
    }
    assume_everything(fit.channels.origin, known);
    return std::optional(std::move(fit));
}

MaybeFit bare(const std::vector<std::string>& names, std::string_view /*generator*/) {
    std::map<std::pair<std::string_view, bool>, std::array<std::string, 4>> sets;  // by layer and kind of name
    for (const std::string& name : names) {
        const auto [layer, last] = split(name);
        const auto component = bare_name(last);
        if (!component) continue;
        std::string& place = sets[{layer, component->is_letter}][component->component];
        if (!place.empty())
            return input_error(fmt::format("channels {} and {} are of one Stokes component", place, name),
                               "keep one of them");
        place = name;
    }
    std::erase_if(
        sets, [](const auto& set) { return set.second[0].empty() || set.second[1].empty() || set.second[2].empty(); });
    if (sets.empty()) return std::optional<Fit>();
    const std::array<std::string, 4>& found = sets.begin()->second;
    if (sets.size() > 1)
        return input_error(
            fmt::format("has Stokes components twice, as {} and as {}", found[0], std::next(sets.begin())->second[0]),
            "write each set into a file of its own");
    Fit fit;
    fit.channels.origin.layout = "Stokes components without a band";
    const StokesComponents known = found[3].empty() ? StokesComponents::linear() : StokesComponents::all();
    fit.channels.bands.push_back({named_band("mono", known), found});
    assume_everything(fit.channels.origin, known);
    return std::optional(std::move(fit));
}

MaybeFit plain(const std::vector<std::string>& names, std::string_view /*generator*/) {
    if (std::any_of(names.begin(), names.end(), is_stokes_part)) return std::optional<Fit>();
    if (auto bands = colors_of(names, {}); !bands.empty()) return plain_fit(std::move(bands), names);
    if (has(names, "Y")) return plain_fit({s0_only("Y", "Y")}, names);
    if (auto only = one_component(names)) {
        if (is_polarization(only->bands.front().names[0])) return std::optional<Fit>();
        return plain_fit(std::move(only->bands), names);
    }
    std::map<std::string_view, std::set<std::string_view>> layers;  // colors of each
    for (const std::string& name : names) {
        const auto [layer, last] = split(name);
        if (!layer.empty() && std::find(colors.begin(), colors.end(), last) != colors.end()) layers[layer].insert(last);
    }
    std::erase_if(
        layers, [](const auto& layer) { return layer.second.size() < colors.size() || is_polarization(layer.first); });
    if (layers.size() != 1) return std::optional<Fit>();
    return plain_fit(colors_of(names, layers.begin()->first), names);
}

std::optional<StokesChannels> one_component(const std::vector<std::string>& names) {
    std::vector<std::string> lights;
    std::copy_if(names.begin(), names.end(), std::back_inserter(lights),
                 [](const std::string& name) { return without_mark(name) != "A"; });
    StokesChannels channels;
    if (lights.size() == 1)
        channels.bands.push_back(s0_only(without_mark(lights.front()), lights.front()));
    else if (lights.size() == colors.size())
        channels.bands = colors_of(lights, {});
    if (channels.bands.empty()) return std::nullopt;
    return channels;
}

}  // namespace pol::channels
