// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/glyph_overlay.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/units.h"
#include "viewer/widgets/ink.h"

namespace pol {

namespace {

constexpr int segments = 24;
/// b/a below which an ellipse is drawn as the line that it looks like.
constexpr double looks_linear = 0.03;

/// As glyph_key says.
ImU32 handedness_ink(const Glyph& glyph, const Convention& convention) {
    const double share = std::min(1.0, 3.0 * std::abs(glyph.ellipticity));
    const DVec3 hand = is_right_handed(glyph, convention) ? DVec3(90.0, 170.0, 255.0) : DVec3(255.0, 205.0, 60.0);
    const DVec3 color = glm::mix(DVec3(255.0), hand, share);
    return IM_COL32(static_cast<int>(color.x), static_cast<int>(color.y), static_cast<int>(color.z),
                    static_cast<int>(255.0 * glyph.weight));
}

void draw_stroke(ImDrawList& list, const DVec2& center, const Glyph& glyph, double radius, ImU32 color) {
    if (glyph.azimuth_weight == 0.0) return;
    const DVec2 half = radius * field_tip(glyph, 0.0);
    rimmed_line(list, point(center - half), point(center + half), color, 1.2F);
}

void draw_ellipse(ImDrawList& list, const DVec2& center, const Glyph& glyph, double radius, ImU32 color) {
    std::array<ImVec2, segments> outline;
    for (int i = 0; i < segments; ++i)
        outline[static_cast<std::size_t>(i)] = point(center + radius * field_tip(glyph, 2.0 * pi * i / segments));
    list.AddPolyline(outline.data(), segments, rim_color, ImDrawFlags_Closed, 3.0F);
    list.AddPolyline(outline.data(), segments, color, ImDrawFlags_Closed, 1.2F);
    // The head sits on the ellipse and points the way in which the field turns.
    const DVec2 tip = center + radius * field_tip(glyph, 0.3);
    const DVec2 before = center + radius * field_tip(glyph, 0.0);
    const DVec2 step = tip - before;
    const double size = std::min(5.0, 0.5 * radius);
    if (glm::length(step) < 1e-6) return;
    const DVec2 along = size * glm::normalize(step);
    const DVec2 side = 0.6 * DVec2(-along.y, along.x);
    list.AddTriangleFilled(point(before + along), point(before - 0.3 * along + side),
                           point(before - 0.3 * along - side), color);
}

}  // namespace

void GlyphOverlay::draw(const Session& session, const PlacedPicture& placed, const TileRect& seen) {
    const GlyphSettings& settings = session.view().glyphs;
    if (settings.kind == GlyphKind::none) return;
    const Document& document = *session.current();
    const Source source{document.picture_layout(),
                        document.picture_version(),
                        session.view().band,
                        glyph_cell(settings, placed.transform.scale),
                        {seen.x0, seen.y0, seen.x1, seen.y1},
                        session.polarimeter()};
    if (!(source == source_)) {
        glyphs_ = glyphs_of(ShownPicture(document.picture(), session.polarimeter()), source.band, source.cell, seen);
        source_ = source;
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const Glyph& glyph : glyphs_) {
        const DVec2 center = placed.window_from_picture(glyph.center);
        const double radius = glyph_radius(glyph, settings);
        const ImU32 color = handedness_ink(glyph, session.view().convention);
        const bool is_line = std::abs(glyph.ellipticity) < looks_linear;
        if (settings.kind == GlyphKind::azimuth_strokes || !glyph.has_ellipticity) {
            draw_stroke(list, center, glyph, radius,
                        IM_COL32(255, 255, 255, static_cast<int>(255.0 * glyph.azimuth_weight)));
            continue;
        }
        if (settings.kind == GlyphKind::combined || is_line) draw_stroke(list, center, glyph, radius, color);
        if (!is_line) draw_ellipse(list, center, glyph, radius, color);
    }
}

}  // namespace pol
