// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/polarizer_angles.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "io/pictures/picture_reading.h"

namespace pol {

namespace {

/// cos and sin of 2 a, exact where 2 a is a multiple of 90 degrees.
std::pair<double, double> of_double_angle(double degrees) {
    const double quarters = degrees / 45.0;
    if (quarters == std::round(quarters)) {
        constexpr std::array<std::pair<double, double>, 4> exact{{{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}}};
        return exact[static_cast<std::size_t>(static_cast<int>(std::fmod(quarters, 4.0)) + 4) % 4];
    }
    const double angle = 2.0 * degrees * std::numbers::pi / 180.0;
    return {std::cos(angle), std::sin(angle)};
}

using Matrix = std::array<std::array<double, 3>, 3>;

double cofactor(const Matrix& m, std::size_t i, std::size_t j) {
    const std::size_t a = (i + 1) % 3;
    const std::size_t b = (i + 2) % 3;
    const std::size_t c = (j + 1) % 3;
    const std::size_t d = (j + 2) % 3;
    return m[a][c] * m[b][d] - m[a][d] * m[b][c];
}

}  // namespace

Result<AngleFit> fit_angles(std::span<const double> angles_deg) {
    AngleFit fit;
    std::vector<std::array<double, 3>> rows;
    Matrix normal{};
    for (const double angle : angles_deg) {
        const auto [cosine, sine] = of_double_angle(angle);
        fit.cosine.push_back(cosine);
        fit.sine.push_back(sine);
        rows.push_back({0.5, 0.5 * cosine, 0.5 * sine});
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) normal[i][j] += rows.back()[i] * rows.back()[j];
    }
    double determinant = 0.0;
    for (std::size_t j = 0; j < 3; ++j) determinant += normal[0][j] * cofactor(normal, 0, j);
    // Relative to the sum of squares, 1/4 for evenly spread angles and 1e-6 for three angles 1.3 degrees apart.
    constexpr double too_alike = 1e-6;
    if (angles_deg.size() < 3 || !(determinant > too_alike * std::pow(normal[0][0], 3.0)))
        return usage_error(fmt::format("{} polarizer angles do not tell S0, S1 and S2", angles_deg.size()),
                           "at least three that differ, modulo 180 degrees, for example 0,60,120");
    for (std::size_t i = 0; i < 3; ++i)
        for (const auto& row : rows) {
            double weight = 0.0;
            for (std::size_t j = 0; j < 3; ++j) weight += cofactor(normal, j, i) / determinant * row[j];
            fit.weights[i].push_back(weight);
        }
    return fit;
}

}  // namespace pol
