// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/exr_origin.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "io/pictures/exr_channel.h"
#include "io/pictures/exr_layout.h"

namespace pol::exr {
namespace {

constexpr const char* layout_attribute = "polariscope.origin.layout";
constexpr const char* origin_convention_attribute = "polariscope.origin.convention";
constexpr const char* assumed_attribute = "polariscope.origin.assumed";
constexpr const char* remarks_attribute = "polariscope.origin.remarks";

Error not_understood(const char* attribute, std::string_view text) {
    constexpr std::size_t shown = 60;
    return Error{ErrorKind::input,
                 fmt::format("{} is not understood: '{}'", attribute, text.substr(0, shown)),
                 {},
                 {},
                 "was it changed by another program? convert the picture again"};
}

void add_escaped(std::string& text, std::string_view line) {
    for (const char c : line) {
        if (c == '\n' || c == '\\') text += '\\';
        text += c;
    }
    text += '\n';
}

std::string escaped_lines(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) add_escaped(text, line);
    return text;
}

std::vector<std::string> unescaped_lines(std::string_view text) {
    std::vector<std::string> lines;
    std::string line;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n')
            lines.push_back(std::exchange(line, {}));
        else
            line += text[i] == '\\' && i + 1 < text.size() ? text[++i] : text[i];
    }
    if (!line.empty()) lines.push_back(line);
    return lines;
}

bool is_clean(std::string_view name) {
    constexpr std::size_t longest = 200;  // of EXR's 255, with sampling_error.S0. before it
    const auto is_plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };
    return !name.empty() && name.size() <= longest && std::all_of(name.begin(), name.end(), is_plain) &&
           !parse_wavelength_suffix(name);
}

std::string known_digits(StokesComponents known) {
    std::string digits;
    for (unsigned s = 0; s < 4; ++s)
        if (known.has(s)) digits += static_cast<char>('0' + s);
    return digits;
}

std::string bands_text(const std::vector<Band>& bands) {
    const std::vector<std::string> suffixes = band_suffixes(bands);
    std::string text;
    for (std::size_t b = 0; b < bands.size(); ++b) {
        const std::string what =
            bands[b].wavelength_nm ? "w " + fmt::to_string(*bands[b].wavelength_nm) : "n " + bands[b].name;
        add_escaped(text, fmt::format("{} {} {}", known_digits(bands[b].known), suffixes[b], what));
    }
    return text;
}

/// The part of `text` before the next space, which it loses.
std::string_view next_word(std::string_view& text) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return word;
}

std::optional<BandChannels> band_of(std::string_view line) {
    BandChannels channels;
    channels.band.known = StokesComponents::s0().without(0);
    const std::string_view known = next_word(line);
    const std::string_view suffix = next_word(line);
    const std::string_view kind = next_word(line);
    if (known.empty() || suffix.empty()) return std::nullopt;
    for (const char digit : known) {
        if (digit < '0' || digit > '3') return std::nullopt;
        const auto s = static_cast<unsigned>(digit - '0');
        channels.band.known = channels.band.known.with(s);
        channels.names[s] = fmt::format("{}.{}", stokes_layers[s].name, suffix);
    }
    if (kind == "n") {
        channels.band.name = line;
        return channels;
    }
    const std::vector<double> wavelength = parse_numbers(line);
    if (kind != "w" || wavelength.size() != 1 || !std::isfinite(wavelength[0]) || wavelength[0] <= 0.0)
        return std::nullopt;
    channels.band.wavelength_nm = wavelength[0];
    return channels;
}

std::string convention_text(const StokesConvention& convention) {
    return fmt::format("{} {} {}", convention.left_handed ? "left_handed" : "right_handed",
                       convention.y_down ? "y_down" : "y_up", convention.azimuth_zero_deg);
}

std::optional<StokesConvention> convention_of(std::string_view text) {
    const std::string_view handedness = next_word(text);
    const std::string_view rows = next_word(text);
    const std::vector<double> zero = parse_numbers(text);
    StokesConvention convention;
    convention.left_handed = handedness == "left_handed";
    convention.y_down = rows == "y_down";
    if ((!convention.left_handed && handedness != "right_handed") || (!convention.y_down && rows != "y_up") ||
        zero.size() != 1 || !std::isfinite(zero[0]))
        return std::nullopt;
    convention.azimuth_zero_deg = zero[0];
    return convention;
}

}  // namespace

std::vector<std::string> band_suffixes(const std::vector<Band>& bands) {
    std::vector<std::string> suffixes;
    for (std::size_t b = 0; b < bands.size(); ++b) {
        std::string suffix = bands[b].wavelength_nm ? wavelength_suffix(*bands[b].wavelength_nm) : bands[b].name;
        const bool is_taken = std::find(suffixes.begin(), suffixes.end(), suffix) != suffixes.end();
        if (!bands[b].wavelength_nm && (is_taken || !is_clean(suffix))) suffix = fmt::format("band.{}", b);
        suffixes.push_back(std::move(suffix));
    }
    return suffixes;
}

std::map<std::string, std::string> own_attributes(const StokesImage& image) {
    std::map<std::string, std::string> attributes;
    const bool is_spectral = std::all_of(image.bands.begin(), image.bands.end(), [](const Band& band) {
        return band.wavelength_nm && band.known == StokesComponents::all();
    });
    if (!is_spectral) attributes[bands_attribute] = bands_text(image.bands);
    const PictureOrigin& origin = image.origin;
    if (!origin.layout.empty()) attributes[layout_attribute] = origin.layout;
    if (origin.convention != StokesConvention{})
        attributes[origin_convention_attribute] = convention_text(origin.convention);
    if (!origin.assumed.empty()) attributes[assumed_attribute] = escaped_lines(origin.assumed);
    if (!origin.remarks.empty()) attributes[remarks_attribute] = escaped_lines(origin.remarks);
    if (image.stored.bits != StoredNumbers{}.bits || !image.stored.lossy.empty())
        attributes[stored_attribute] = fmt::format("{} {}", image.stored.bits, image.stored.lossy);
    if (image.stored.spacing > 0.0) attributes[spacing_attribute] = fmt::to_string(image.stored.spacing);
    return attributes;
}

bool is_own_attribute(std::string_view name) {
    return name == bands_attribute || name == stored_attribute || name == spacing_attribute ||
           name == layout_attribute || name == convention_attribute || name == origin_convention_attribute ||
           name == assumed_attribute || name == remarks_attribute;
}

Result<StokesChannels> own_channels(std::string_view bands, const std::vector<std::string>& names) {
    StokesChannels channels;
    channels.origin.layout = "ours, of named bands";
    double last = 0.0;
    std::set<std::string> taken;
    for (const std::string& line : unescaped_lines(bands)) {
        auto band = band_of(line);
        if (!band || band->band.wavelength_nm.value_or(2.0 * last + 1.0) <= last)
            return not_understood(bands_attribute, line);
        last = band->band.wavelength_nm.value_or(last);
        for (const std::string& name : band->names) {
            if (name.empty() || std::binary_search(names.begin(), names.end(), name)) continue;
            return Error{ErrorKind::input, fmt::format("channel {} is missing", name), {}, {}, "convert it again"};
        }
        for (const std::string& name : band->names)
            if (!name.empty() && !taken.insert(name).second) return not_understood(bands_attribute, line);
        channels.bands.push_back(std::move(*band));
    }
    if (channels.bands.empty()) return not_understood(bands_attribute, bands);
    return channels;
}

Result<Done> take_own_origin(const Parts& parts, PictureOrigin& origin) {
    if (std::string layout = parts.text(layout_attribute); !layout.empty()) origin.layout = std::move(layout);
    if (const std::string text = parts.text(origin_convention_attribute); !text.empty()) {
        const auto convention = convention_of(text);
        if (!convention) return not_understood(origin_convention_attribute, text);
        origin.convention = *convention;
    }
    for (std::string& line : unescaped_lines(parts.text(assumed_attribute))) origin.assumed.push_back(std::move(line));
    for (std::string& line : unescaped_lines(parts.text(remarks_attribute))) origin.remarks.push_back(std::move(line));
    return Done{};
}

StoredNumbers with_earlier(StoredNumbers stored, const Parts& parts) {
    const std::string text = parts.text(stored_attribute);
    std::string_view rest = text;
    const std::vector<double> bits = parse_numbers(next_word(rest));
    if (bits.size() == 1 && (bits[0] == 24.0 || bits[0] == 16.0))
        stored.bits = std::min(stored.bits, static_cast<int>(bits[0]));
    if (stored.lossy.empty()) stored.lossy = rest;
    const std::vector<double> spacing = parse_numbers(parts.text(spacing_attribute));
    if (spacing.size() == 1 && std::isfinite(spacing[0])) stored.spacing = std::max(stored.spacing, spacing[0]);
    return stored;
}

std::vector<double> parse_numbers(std::string_view text) {
    std::vector<double> numbers;
    while (!text.empty()) {
        text.remove_prefix(std::min(text.find_first_not_of(", "), text.size()));
        if (text.empty()) break;
        double value = 0.0;
        const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (status != std::errc{}) return {};
        numbers.push_back(value);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    return numbers;
}

std::string number_list(const std::vector<double>& numbers) {
    std::string text;
    for (const double number : numbers) {
        if (!text.empty()) text += ", ";
        text += fmt::to_string(number);
    }
    return text;
}

}  // namespace pol::exr
