// SPDX-License-Identifier: Apache-2.0
#include "render/preview.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace pol {

std::vector<PreviewGrid> preview_levels(const Plan& plan) {
    constexpr std::size_t most_trees = 40000;
    const RenderSettings& s = plan.settings;
    const auto grid_of = [&s](int stride) {
        return PreviewGrid{stride, (s.width + stride - 1) / stride, (s.height + stride - 1) / stride};
    };
    const auto is_small = [&](const PreviewGrid& grid) {
        const std::size_t blocks = static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
        return blocks == 1 || blocks * plan.groups.size() <= most_trees;
    };
    int stride = 8;
    while (!is_small(grid_of(stride))) stride += 4;
    std::vector<PreviewGrid> levels{grid_of(stride)};
    while (stride % 2 == 0 && stride > 2) levels.push_back(grid_of(stride /= 2));
    return levels;
}

bool next_level_pays(const PreviewGrid& level, double seconds) {
    constexpr double patience_s = 0.2;
    return seconds * level.stride * level.stride > patience_s;
}

TileImportance::TileImportance(const Plan& plan, const PreviewGrid& grid) : plan_(plan), grid_(grid) {
    const std::size_t blocks = static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
    light_.assign(blocks, 0.0);
    doubt_.assign(blocks, 0.0);
}

void TileImportance::add(const PreviewStrip& strip) {
    const std::size_t wavelengths = plan_.wavelengths_nm.size();
    const std::size_t groups = plan_.groups.size();
    for (std::size_t column = 0; column < static_cast<std::size_t>(grid_.columns); ++column) {
        const std::size_t block =
            static_cast<std::size_t>(strip.row) * static_cast<std::size_t>(grid_.columns) + column;
        for (std::size_t w = 0; w < wavelengths; ++w) {
            if (plan_.brightest[w] > 0.0)
                light_[block] +=
                    strip.stokes[column * wavelengths + w].s0 / plan_.brightest[w] / static_cast<double>(wavelengths);
        }
        for (std::size_t g = 0; g < groups; ++g)
            doubt_[block] +=
                (strip.residual[column * groups + g] + strip.tail[column * groups + g]) / static_cast<double>(groups);
    }
}

/// Light, contrast to the neighbors, and doubt.
double TileImportance::block(int column, int row) const {
    const auto at = [this](int c, int r) {
        return static_cast<std::size_t>(r) * static_cast<std::size_t>(grid_.columns) + static_cast<std::size_t>(c);
    };
    const std::size_t here = at(column, row);
    double contrast = 0.0;
    if (column + 1 < grid_.columns) contrast += std::abs(light_[at(column + 1, row)] - light_[here]);
    if (row + 1 < grid_.rows) contrast += std::abs(light_[at(column, row + 1)] - light_[here]);
    return light_[here] + contrast + doubt_[here];
}

std::vector<int> TileImportance::order(const std::vector<TileRect>& tiles) const {
    std::vector<double> importance;
    for (const TileRect& tile : tiles) {
        double largest = 0.0;
        for (int row = tile.y0 / grid_.stride; row <= (tile.y1 - 1) / grid_.stride; ++row)
            for (int column = tile.x0 / grid_.stride; column <= (tile.x1 - 1) / grid_.stride; ++column)
                largest = std::max(largest, block(column, row));
        importance.push_back(largest);
    }
    std::vector<int> order(tiles.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&importance](int a, int b) {
        return importance[static_cast<std::size_t>(a)] > importance[static_cast<std::size_t>(b)];
    });
    return order;
}

}  // namespace pol
