// SPDX-License-Identifier: Apache-2.0
// The coarse picture that a viewer sees first, and what it says about where to look next.
#pragma once

#include <vector>

#include "film/tile.h"
#include "plan/plan.h"

namespace pol {

/// Branches that a sample of the preview may follow before its random tail, and the share of a pixel that may stay
/// untraced: noisy, but without bias, and about 20 us in a crystal.
inline constexpr int preview_node_budget = 32;
inline constexpr double preview_residual = 0.02;

/// Blocks of stride x stride pixels, each shown by sample 0, the centre, of its middle pixel.
struct PreviewGrid {
    int stride = 8;
    int columns = 0;
    int rows = 0;
};

/// The levels of a preview, coarse to fine. The first has stride 8, or more so that a picture with many pixels or
/// wavelengths still has it in a fraction of a second; each of the others half the stride of the one before, down to 2.
std::vector<PreviewGrid> preview_levels(const Plan& plan);

/// Whether the next level pays after this one, which took so many seconds: without it the first whole pass over the
/// picture, at this rate, would keep the eye waiting.
bool next_level_pays(const PreviewGrid& level, double seconds);

/// Collects what the preview says about the tiles.
class TileImportance {
public:
    TileImportance(const Plan& plan, const PreviewGrid& grid);

    void add(const PreviewStrip& strip);

    /// Indices of the tiles, most important first: those with much light, with contrast, and with light that the
    /// preview did not trace (CUTTING.md 2.5). Equally important ones stay in the order of lines.
    [[nodiscard]] std::vector<int> order(const std::vector<TileRect>& tiles) const;

private:
    [[nodiscard]] double block(int column, int row) const;

    const Plan& plan_;
    PreviewGrid grid_;
    std::vector<double> light_;  // by block, mean over the wavelengths, in units of the brightest
    std::vector<double> doubt_;  // residual and tail by block
};

}  // namespace pol
