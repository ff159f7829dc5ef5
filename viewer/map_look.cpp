// SPDX-License-Identifier: Apache-2.0
#include "viewer/map_look.h"

#include <algorithm>
#include <cmath>

namespace pol {

MapLook map_look(const Session& session) {
    const ViewSettings& view = session.view;
    const MapOptions options{view.style, view.range[static_cast<std::size_t>(view.quantity)], view.exposure};
    return {view.scale.value_or(scale_for(view.quantity, view.style)),
            range_for(view.quantity, options, session.shown_map.summary().high)};
}

namespace {

/// Shown like a photograph: exposure and offset say what is black and what is white.
bool is_photograph(Quantity quantity) {
    return quantity == Quantity::color || info(quantity).kind == ScaleKind::gray;
}

std::optional<MapRange>& own_range(ViewSettings& view) {
    return view.range[static_cast<std::size_t>(view.quantity)];
}

}  // namespace

MapRange bar_range(const Session& session) {
    MapRange range = map_look(session).range;
    if (is_photograph(session.view.quantity)) {
        const double shift = -session.view.offset * (range.high - range.low);
        range.low += shift;
        range.high += shift;
    }
    return range;
}

void set_bar_range(Session& session, const MapRange& range) {
    const double span = range.high - range.low;
    if (!(span > 0.0) || !std::isfinite(span)) return;
    ViewSettings& view = session.view;
    if (is_photograph(view.quantity)) {
        own_range(view).reset();
        view.exposure = -std::log2(span);
        view.offset = -range.low / span;
    } else {
        own_range(view) = range;
    }
}

void reset_bar_range(Session& session) {
    own_range(session.view).reset();
    if (is_photograph(session.view.quantity)) session.view.exposure = session.view.offset = 0.0;
}

void fit_bar_range(Session& session) {
    const ScaleKind kind = info(session.view.quantity).kind;
    if (kind == ScaleKind::cyclic) return;
    const MapSummary& found = session.shown_map.summary();
    MapRange range{found.low, found.high};
    if (kind == ScaleKind::diverging) {
        range.high = std::max(std::abs(found.low), std::abs(found.high));
        range.low = -range.high;
    }
    set_bar_range(session, range);
}

}  // namespace pol
