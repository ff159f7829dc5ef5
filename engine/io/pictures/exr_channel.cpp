// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/exr_channel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

namespace pol {
namespace {

constexpr double speed_of_light_nm_per_s = 299792458.0e9;

/// Factor of an SI prefix of the layout; empty if unknown.
std::optional<double> prefix_factor(std::string_view prefix) {
    constexpr std::array<std::pair<std::string_view, double>, 17> prefixes{{{"", 1.0},
                                                                            {"Y", 1e24},
                                                                            {"Z", 1e21},
                                                                            {"E", 1e18},
                                                                            {"P", 1e15},
                                                                            {"T", 1e12},
                                                                            {"G", 1e9},
                                                                            {"M", 1e6},
                                                                            {"k", 1e3},
                                                                            {"h", 1e2},
                                                                            {"da", 1e1},
                                                                            {"d", 1e-1},
                                                                            {"c", 1e-2},
                                                                            {"m", 1e-3},
                                                                            {"u", 1e-6},
                                                                            {"n", 1e-9},
                                                                            {"p", 1e-12}}};
    for (const auto& [name, factor] : prefixes) {
        if (name == prefix) return factor;
    }
    return std::nullopt;
}

}  // namespace

std::string wavelength_suffix(double wavelength_nm) {
    std::string text = fmt::format("{:.6f}nm", wavelength_nm);
    std::replace(text.begin(), text.end(), '.', ',');
    return text;
}

std::optional<double> parse_wavelength_suffix(std::string_view text) {
    if (text.find('.') != std::string_view::npos) return std::nullopt;
    std::string number(text);
    std::replace(number.begin(), number.end(), ',', '.');
    double value = 0.0;
    const auto [end, status] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (status != std::errc{}) return std::nullopt;

    std::string_view unit = text.substr(static_cast<std::size_t>(end - number.data()));
    const bool is_frequency = unit.ends_with("Hz");
    if (!is_frequency && !unit.ends_with('m')) return std::nullopt;
    unit.remove_suffix(is_frequency ? 2 : 1);
    const std::optional<double> factor = prefix_factor(unit);
    if (!factor) return std::nullopt;

    // Nanometers are taken as they are: 1e-9 * 1e9 is not 1 in doubles.
    const double wavelength_nm = is_frequency  ? speed_of_light_nm_per_s / (value * *factor)
                                 : unit == "n" ? value
                                               : value * *factor * 1e9;
    if (!std::isfinite(wavelength_nm) || wavelength_nm <= 0.0) return std::nullopt;
    return wavelength_nm;
}

}  // namespace pol
