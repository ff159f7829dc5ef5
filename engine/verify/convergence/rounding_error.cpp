// SPDX-License-Identifier: Apache-2.0
#include "verify/convergence/rounding_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "polarization/coherence_matrix.h"
#include "verify/convergence/wide_replay.h"

namespace pol::verify {

namespace {

struct GridPixel {
    int x = 0;
    int y = 0;
};

/// Pixels of an even grid, near ones far apart in the list: any first part of it covers the picture.
std::vector<GridPixel> grid_over(int width, int height) {
    const int columns = std::min(width, rounding_grid);
    const int rows = std::min(height, rounding_grid);
    const int count = columns * rows;
    constexpr int stride = 97;  // a prime beyond rounding_grid: it meets every pixel once
    const auto place = [](int i, int of, int side) { return (2 * i + 1) * side / (2 * of); };
    std::vector<GridPixel> pixels;
    for (int i = 0; i < count; ++i) {
        const int index = i * stride % count;
        pixels.push_back({place(index % columns, columns, width), place(index / columns, rows, height)});
    }
    return pixels;
}

double root_mean_square(const std::vector<double>& values) {
    double squares = 0.0;
    for (const double value : values) squares += value * value;
    return std::sqrt(squares / static_cast<double>(values.size()));
}

}  // namespace

std::optional<RoundingError> rounding_error(const Plan& plan, const KeepGoing& keep_going) {
    const auto middle = static_cast<int>(plan.wavelengths_nm.size() / 2);
    RoundingError error;
    error.wavelength_nm = plan.wavelengths_nm[static_cast<std::size_t>(middle)];
    std::vector<double> sizes;
    std::vector<double> errors;
    std::vector<double> errors_of_trees;
    std::size_t left = most_replayed_branches;
    for (const GridPixel& pixel : grid_over(plan.settings.width, plan.settings.height)) {
        if (!keep_going(0)) return std::nullopt;
        const auto explanation = explain(plan, pixel.x, pixel.y, 0, middle, [&](std::size_t branches) {
            return branches <= left && keep_going(branches);
        });
        if (!explanation || explanation->tree.nodes.size() > left) {
            ++error.too_large;
            continue;
        }
        left -= explanation->tree.nodes.size();
        const auto wide = wide_light(plan, *explanation);
        if (!wide) {
            ++error.other_branches;
            continue;
        }
        const Stokes<double> light = light_without_tail(explanation->tree);
        sizes.push_back(std::sqrt(frobenius_square(light)));
        errors.push_back(rounding_distance(light, wide->light));
        if (explanation->tree.nodes.size() > 1) errors_of_trees.push_back(errors.back());
        error.beyond_edge += wide->beyond_edge ? 1 : 0;
        error.with_tail += explanation->result.tail > 0.0 ? 1 : 0;
    }
    error.compared = errors.size();
    const double unit = errors.empty() ? 0.0 : root_mean_square(sizes);
    if (unit == 0.0) return error;
    error.fro_c = root_mean_square(errors) / unit;
    error.largest = *std::max_element(errors.begin(), errors.end()) / unit;
    if (errors_of_trees.empty()) return error;
    const auto median = errors_of_trees.begin() + static_cast<std::ptrdiff_t>(errors_of_trees.size() / 2);
    std::nth_element(errors_of_trees.begin(), median, errors_of_trees.end());
    error.median = *median / unit;
    return error;
}

std::string text_of(const RoundingError& error) {
    std::string text = fmt::format(
        "fro_c {:.1e}, median {:.1e}, largest {:.1e}, over {} pixels at {:g} nm against their own trees followed in "
        "128 "
        "bit",
        error.fro_c, error.median, error.largest, error.compared, error.wavelength_nm);
    const auto add = [&](std::size_t count, std::string_view what) {
        if (count > 0) text += fmt::format("; {} {}", count, what);
    };
    add(error.too_large, fmt::format("left out: beyond {} branches in all", most_replayed_branches));
    add(error.other_branches, "left out: rounding decided whether a branch exists");
    add(error.with_tail, "compared without their random tails");
    add(error.beyond_edge, "met an edge, where rounding chose the facet");
    return text;
}

}  // namespace pol::verify
