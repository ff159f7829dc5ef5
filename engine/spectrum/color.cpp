// SPDX-License-Identifier: Apache-2.0
#include "spectrum/color.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "core/contract.h"
#include "core/vec.h"
#include "spectrum/illuminant.h"
#include "spectrum/tables.h"

namespace pol {
namespace {

DVec3 xyz_of_chromaticity(double x, double y) {
    return {x / y, 1.0, (1.0 - x - y) / y};
}

/// Columns are the primaries, scaled so that their sum is the white point with Y = 1 (IEC 61966-2-1).
DMat3 srgb_matrix() {
    const DMat3 primaries{xyz_of_chromaticity(0.64, 0.33), xyz_of_chromaticity(0.30, 0.60),
                          xyz_of_chromaticity(0.15, 0.06)};
    const DVec3 scale = glm::inverse(primaries) * xyz_of_chromaticity(0.3127, 0.3290);
    return {primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z};
}

const DMat3& rgb_to_xyz() {
    static const DMat3 matrix = srgb_matrix();
    return matrix;
}

const DMat3& xyz_to_rgb() {
    static const DMat3 matrix = glm::inverse(srgb_matrix());
    return matrix;
}

/// D65 where the observer can use it; the observer's range lies inside that of D65.
double d65_or_zero(double nm) {
    return d65_covers(nm) ? d65_at(nm).value() : 0.0;
}

}  // namespace

Xyz color_matching(double wavelength_nm) {
    const auto table = tables::observer();
    if (!(wavelength_nm >= table.front()[0] && wavelength_nm <= table.back()[0])) return {0.0, 0.0, 0.0};
    const auto row = tables::row_at(table, wavelength_nm);
    return {row[1], row[2], row[3]};
}

Xyz to_xyz(const Rgb& linear) {
    const DVec3 xyz = rgb_to_xyz() * DVec3{linear[0], linear[1], linear[2]};
    return {xyz.x, xyz.y, xyz.z};
}

Rgb to_linear_srgb(const Xyz& xyz) {
    const DVec3 rgb = xyz_to_rgb() * DVec3{xyz[0], xyz[1], xyz[2]};
    return {rgb.x, rgb.y, rgb.z};
}

double srgb_encode(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double srgb_decode(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::vector<double> decoding_table(std::size_t most, double gamma) {
    const bool is_srgb = gamma == 0.0 || std::abs(gamma - 0.45455) < 0.001;
    std::vector<double> table;
    for (std::size_t code = 0; code <= most; ++code) {
        const double encoded = static_cast<double>(code) / static_cast<double>(most);
        table.push_back(is_srgb ? srgb_decode(encoded) : std::pow(encoded, 1.0 / gamma));
    }
    return table;
}

std::vector<double> trapezoid_weights(std::span<const double> wavelengths_nm) {
    const std::size_t count = wavelengths_nm.size();
    if (count == 1) return {1.0};
    std::vector<double> weights(count, 0.0);
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const double half = (wavelengths_nm[i + 1] - wavelengths_nm[i]) / 2.0;
        weights[i] += half;
        weights[i + 1] += half;
    }
    return weights;
}

std::vector<Rgb> color_weights(std::span<const double> wavelengths_nm) {
    POL_EXPECTS(!wavelengths_nm.empty());
    const std::size_t count = wavelengths_nm.size();
    const std::vector<double> width = trapezoid_weights(wavelengths_nm);

    // Per channel: unscaled weights, and what they make of D65.
    std::array<std::vector<double>, 3> channel;
    std::array<double, 3> white{};
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < count; ++i) {
            const double weight = color_matching(wavelengths_nm[i])[c] * width[i];
            channel[c].push_back(weight);
            white[c] += weight * d65_or_zero(wavelengths_nm[i]);
        }
    }
    if (white[1] == 0.0) {
        channel[1] = width;
        white[1] = std::accumulate(width.begin(), width.end(), 0.0);
    }
    for (const std::size_t c : {std::size_t{0}, std::size_t{2}}) {
        if (white[c] > 0.0) continue;
        channel[c] = channel[1];
        white[c] = white[1];
    }

    const Xyz srgb_white = to_xyz({1.0, 1.0, 1.0});
    std::vector<Rgb> weights;
    for (std::size_t i = 0; i < count; ++i) {
        weights.push_back(
            to_linear_srgb({channel[0][i] * srgb_white[0] / white[0], channel[1][i] * srgb_white[1] / white[1],
                            channel[2][i] * srgb_white[2] / white[2]}));
    }
    return weights;
}

Rgb weighted_color(std::span<const double> values, std::span<const Rgb> weights) {
    POL_EXPECTS(values.size() == weights.size());
    Rgb color{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) color[c] += weights[i][c] * values[i];
    }
    return color;
}

}  // namespace pol
