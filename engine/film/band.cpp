// SPDX-License-Identifier: Apache-2.0
#include "film/band.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace pol {

StokesComponents known_behind(const MuellerMatrix<double>& element, StokesComponents known) {
    double largest = 0.0;
    for (const auto& row : element.m)
        for (const double entry : row) largest = std::max(largest, std::abs(entry));
    constexpr double rounding = 1e-12;
    StokesComponents behind = StokesComponents::all();
    for (unsigned i = 0; i < 4; ++i)
        for (unsigned j = 0; j < 4; ++j)
            if (!known.has(j) && std::abs(element.m[i][j]) > rounding * largest) behind = behind.without(i);
    return behind;
}

Stokes<double> only(StokesComponents known, const Stokes<double>& s) {
    return {known.has(0) ? s.s0 : 0.0, known.has(1) ? s.s1 : 0.0, known.has(2) ? s.s2 : 0.0, known.has(3) ? s.s3 : 0.0};
}

std::string Band::label() const {
    if (!wavelength_nm) return name;
    std::array<char, 32> text{};
    const auto [end, status] = std::to_chars(text.data(), text.data() + text.size(), *wavelength_nm);
    return std::string(text.data(), end) + " nm";
}

std::vector<Band> bands_at(const std::vector<double>& wavelengths_nm) {
    std::vector<Band> bands;
    bands.reserve(wavelengths_nm.size());
    for (const double nm : wavelengths_nm) bands.push_back({nm, {}, StokesComponents::all()});
    return bands;
}

Band named_band(std::string_view name, StokesComponents known) {
    return {std::nullopt, std::string(name), known};
}

std::optional<std::size_t> matching_band(const std::vector<Band>& bands, const Band& wanted) {
    constexpr double same_nm = 1e-6;
    for (std::size_t b = 0; b < bands.size(); ++b) {
        const std::optional<double>& nm = bands[b].wavelength_nm;
        if (nm.has_value() != wanted.wavelength_nm.has_value()) continue;
        if (nm ? std::abs(*nm - *wanted.wavelength_nm) <= same_nm : bands[b].name == wanted.name) return b;
    }
    return std::nullopt;
}

std::vector<double> wavelengths_of(const std::vector<Band>& bands) {
    std::vector<double> wavelengths;
    for (const Band& band : bands) {
        if (!band.wavelength_nm) return {};
        wavelengths.push_back(*band.wavelength_nm);
    }
    return wavelengths;
}

std::optional<std::array<std::size_t, 3>> rgb_bands(const std::vector<Band>& bands) {
    std::array<std::size_t, 3> places{};
    constexpr std::array<std::string_view, 3> names{"R", "G", "B"};
    for (std::size_t c = 0; c < names.size(); ++c) {
        const auto is_it = [&](const Band& band) { return !band.wavelength_nm && band.name == names[c]; };
        if (std::count_if(bands.begin(), bands.end(), is_it) != 1) return std::nullopt;
        places[c] = static_cast<std::size_t>(std::find_if(bands.begin(), bands.end(), is_it) - bands.begin());
    }
    return places;
}

}  // namespace pol
