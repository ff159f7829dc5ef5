// SPDX-License-Identifier: Apache-2.0
#include "viewer/map_look.h"

#include <algorithm>
#include <cmath>

namespace pol {

MapLook map_look(const Session& session) {
    const ViewSettings& view = session.view;
    if (session.comparison()) {
        const MapSummary& found = session.shown_map.summary();
        return {view.scale.value_or(ColorScale::diverging),
                view.difference_range[static_cast<std::size_t>(view.quantity)].value_or(
                    range_of_differences(found.low, found.high))};
    }
    const MapOptions options{view.style, view.range[static_cast<std::size_t>(view.quantity)], view.exposure};
    return {view.scale.value_or(scale_for(view.quantity, view.style)),
            range_for(view.quantity, options, session.shown_map.summary().high)};
}

ScaleKind shown_kind(const Session& session) {
    return session.comparison() ? ScaleKind::diverging : info(session.view.quantity).kind;
}

namespace {

/// Shown like a photograph: exposure and offset say what is black and what is white.
bool is_photograph(const Session& session) {
    const ScaleKind kind = shown_kind(session);
    return kind == ScaleKind::color || kind == ScaleKind::gray;
}

std::optional<MapRange>& own_range(Session& session) {
    ViewSettings& view = session.view;
    return (session.comparison() ? view.difference_range : view.range)[static_cast<std::size_t>(view.quantity)];
}

}  // namespace

MapRange bar_range(const Session& session) {
    MapRange range = map_look(session).range;
    if (is_photograph(session)) {
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
    if (is_photograph(session)) {
        own_range(session).reset();
        view.exposure = -std::log2(span);
        view.offset = -range.low / span;
    } else {
        own_range(session) = range;
    }
}

void reset_bar_range(Session& session) {
    own_range(session).reset();
    if (is_photograph(session)) session.view.exposure = session.view.offset = 0.0;
}

void fit_bar_range(Session& session) {
    const ScaleKind kind = shown_kind(session);
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
