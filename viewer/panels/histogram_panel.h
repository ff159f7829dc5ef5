// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "viewer/session/session.h"
#include "viewer/shown/histogram.h"

namespace pol {

/// Histogram of the shown quantity over the range of the color bar. Dragging over it marks the pixels with such values;
/// pixels without a value are counted below, by state, and marked by a click.
class HistogramPanel {
public:
    void draw(Session& session);

private:
    void draw_bars(const Session& session, const DVec2& origin, const DVec2& size) const;
    void brush(Session& session, const DVec2& origin, const DVec2& size);
    void count_states(Session& session);

    bool is_logarithmic_ = false;
    std::uint64_t map_version_ = 0;
    Histogram histogram_;
    double brush_from_ = 0.0;
    std::optional<MapRange> brush_;  // values, while its marks stand
    std::uint64_t brush_marks_version_ = 0;
};

}  // namespace pol
