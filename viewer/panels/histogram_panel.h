// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"
#include "viewer/shown/histogram.h"

namespace pol {

/// Histogram of the shown quantity over the range of the color bar. Dragging over it marks the pixels with such values;
/// pixels without a value are counted below, by state, and marked by a click.
class HistogramPanel {
public:
    void draw(const Session& session, Wishes& wishes);

private:
    void draw_bars(const Session& session, const DVec2& origin, const DVec2& size) const;
    void brush(const Session& session, Wishes& wishes, const DVec2& origin, const DVec2& size);
    void count_states(const Session& session, Wishes& wishes);

    bool is_logarithmic_ = false;
    std::uint64_t map_version_ = 0;
    Histogram histogram_;
    double brush_from_ = 0.0;  // value where the drag began
};

}  // namespace pol
