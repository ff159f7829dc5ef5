// SPDX-License-Identifier: Apache-2.0
// What the rows of the command table do and ask: each a plain function of the session, so that the table is a table.
#pragma once

#include <algorithm>
#include <cmath>

#include "viewer/commands/commands.h"
#include "viewer/session/exports.h"
#include "viewer/session/pixel_export.h"
#include "viewer/shown/picture_place.h"

namespace pol::action {

// When a command is enabled ---------------------------------------------------------------------------------------

inline bool is_open(const Session& session) {
    return session.current() != nullptr;
}
inline bool has_several(const Session& session) {
    return session.documents().size() > 1;
}
inline bool is_pinned(const Session& session) {
    return is_open(session) && session.selection().pinned().has_value();
}
inline bool has_tree(const Session& session) {
    return session.explanation() != nullptr;
}
inline bool is_free(const Session& session) {
    return is_open(session) && !session.selection().pinned();
}
template <std::size_t number>
bool has_document(const Session& session) {
    return session.documents().size() >= number;
}
inline bool has_reference(const Session& session) {
    return session.reference() != nullptr;
}
inline bool is_rendering(const Session& session) {
    return is_open(session) && session.current()->has_scene();
}
inline bool can_undo(const Session& session) {
    return is_rendering(session) && session.current()->history().can_undo();
}
inline bool can_redo(const Session& session) {
    return is_rendering(session) && session.current()->history().can_redo();
}
inline bool has_file(const Session& session) {
    return is_open(session) && !session.current()->path().empty();
}

// What it does ------------------------------------------------------------------------------------------------------

template <Quantity quantity>
void show_map(Session& session) {
    session.show(quantity);
}
template <Quantity quantity>
bool shows_map(const Session& session) {
    return session.view().quantity == quantity;
}
template <int by>
void step_map(Session& session) {
    const int count = static_cast<int>(quantities().size());
    session.show(static_cast<Quantity>((static_cast<int>(session.view().quantity) + by + count) % count));
}

template <int by>
void step_wavelength(Session& session) {
    session.choose_band(static_cast<std::size_t>(std::max(0, static_cast<int>(session.view().band) + by)));
}

template <MapStyle style>
void use_style(Session& session) {
    session.change_view().style = style;
}
template <MapStyle style>
bool uses_style(const Session& session) {
    return session.view().style == style;
}

template <CompareLayout layout>
void toggle_layout(Session& session) {
    session.toggle_layout(layout);
}
template <CompareLayout layout>
bool has_layout(const Session& session) {
    return session.layout() == layout;
}

template <std::size_t number>
void show_document(Session& session) {
    const auto documents = session.documents();
    if (number <= documents.size()) session.show_document(documents[number - 1]);
}

inline void fit_picture(Session& session) {
    fit(session.change_transform(), whole_of(session.current()->picture()), session.view_size());
}
inline void center_picture(Session& session) {
    center(session.change_transform(), whole_of(session.current()->picture()), session.view_size());
}

inline void zoom(Session& session, double factor) {
    session.change_transform().zoom_at(0.5 * session.view_size(), factor);
}

inline void one_to_one(Session& session) {
    session.change_transform().zoom_at(0.5 * session.view_size(), 1.0 / session.transform().scale);
}

constexpr double stops_per_press = 0.5;
constexpr double offset_per_press = 0.05;
constexpr double gamma_per_press = 0.1;

template <int sign>
void step_exposure(Session& session) {
    session.change_view().exposure += sign * stops_per_press;
}
template <int sign>
void step_offset(Session& session) {
    session.change_view().offset += sign * offset_per_press;
}
template <int sign>
void step_gamma(Session& session) {
    session.change_view().gamma = std::max(gamma_per_press, session.view().gamma + sign * gamma_per_press);
}

inline void reset_tone(Session& session) {
    const ViewSettings fresh;
    ViewSettings& view = session.change_view();
    view.exposure = fresh.exposure;
    view.offset = fresh.offset;
    view.gamma = fresh.gamma;
    view.range = fresh.range;
    view.difference_range = fresh.difference_range;
    view.scale = fresh.scale;
}

inline void step_glyphs(Session& session) {
    constexpr int count = static_cast<int>(GlyphKind::combined) + 1;
    GlyphKind& kind = session.change_view().glyphs.kind;
    kind = static_cast<GlyphKind>((static_cast<int>(kind) + 1) % count);
}

template <int dx, int dy>
void nudge(Session& session) {
    session.nudge(dx, dy);
}

template <RayFormat format>
void export_tree(Session& session) {
    export_rays(session, format);
}

/// What Esc means: what is open on top goes first, then marks, the region, and the pin.
inline void escape(Session& session) {
    WindowState& window = session.change_window();
    if (window.popup_open)
        window.popup_open = false;
    else if (window.help_visible)
        window.help_visible = false;
    else if (window.log_visible)
        window.log_visible = false;
    else if (!session.selection().marked.empty())
        session.mark({});
    else if (session.selection().region)
        session.select_region({});
    else
        session.unpin();
}

template <bool WindowState::*flag>
void toggle(Session& session) {
    session.change_window().*flag = !(session.window().*flag);
}
template <bool WindowState::*flag>
bool is_on(const Session& session) {
    return session.window().*flag;
}

template <bool ViewSettings::*flag>
void toggle_view(Session& session) {
    session.change_view().*flag = !(session.view().*flag);
}
template <bool ViewSettings::*flag>
bool view_has(const Session& session) {
    return session.view().*flag;
}

inline void toggle_listening(Session& session) {
    if (session.listener() != nullptr)
        session.stop_listening();
    else if (const auto listening = session.listen({}, {}); !listening)
        session.say(Severity::error, to_string(listening.error()));
}

/// Into the scene's file, or a new one (free_export_path). False if that failed; the log says why.
inline bool save_scene(Session& session) {
    if (!is_rendering(session)) return false;
    const Document& document = *session.current();
    if (!document.path().empty()) return session.save(document.path());
    return session.save(free_export_path(session, std::filesystem::path(document.name()).stem().string(), ".yaml"));
}

}  // namespace pol::action
