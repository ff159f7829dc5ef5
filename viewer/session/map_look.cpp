// SPDX-License-Identifier: Apache-2.0
#include "viewer/session/map_look.h"

#include <algorithm>
#include <cmath>

namespace pol {

MapOptions map_options(const Session& session) {
    const ViewSettings& view = session.view();
    const bool is_difference = session.comparison().has_value();
    MapOptions options;
    options.style = view.style;
    options.range = (is_difference ? view.difference_range : view.range)[static_cast<std::size_t>(view.quantity)];
    options.exposure = view.exposure;
    options.scale = view.scale;
    options.offset = view.offset;
    options.gamma = view.gamma;
    options.fade_by_bar = view.fade_by_bar;
    options.words = view.convention.scale_words(view.quantity, is_difference);
    return options;
}

MapScale map_look(const Session& session) {
    const MapSummary& found = session.shown_map().summary();
    return map_scale(session.view().quantity, session.comparison().has_value(), map_options(session), found.low,
                     found.high);
}

namespace {

/// Shown like a photograph: exposure and offset say what is black and what is white.
bool is_photograph(const Session& session) {
    const ScaleKind kind = map_look(session).kind;
    return kind == ScaleKind::color || kind == ScaleKind::gray;
}

std::optional<MapRange>& own_range(Session& session) {
    ViewSettings& view = session.change_view();
    return (session.comparison() ? view.difference_range : view.range)[static_cast<std::size_t>(view.quantity)];
}

}  // namespace

MapRange bar_range(const Session& session) {
    MapRange range = map_look(session).range;
    if (is_photograph(session)) {
        const double shift = -session.view().offset * (range.high - range.low);
        range.low += shift;
        range.high += shift;
    }
    return range;
}

void set_bar_range(Session& session, const MapRange& range) {
    const double span = range.high - range.low;
    if (!(span > 0.0) || !std::isfinite(span)) return;
    ViewSettings& view = session.change_view();
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
    if (is_photograph(session)) {
        ViewSettings& view = session.change_view();
        view.exposure = view.offset = 0.0;
    }
}

bool can_move_range(const Session& session) {
    return map_look(session).kind != ScaleKind::cyclic || session.comparison().has_value();
}

void fit_bar_range(Session& session) {
    if (!can_move_range(session)) return;
    const ScaleKind kind = map_look(session).kind;
    const MapSummary& found = session.shown_map().summary();
    MapRange range{found.low, found.high};
    const bool is_signed = session.comparison() && !info(session.view().quantity).of_two;
    if (kind == ScaleKind::diverging || is_signed) {
        range.high = std::max(std::abs(found.low), std::abs(found.high));
        range.low = -range.high;
    }
    set_bar_range(session, range);
}

}  // namespace pol
