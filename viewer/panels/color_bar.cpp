// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/color_bar.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/units.h"
#include "report/bar_ticks.h"
#include "viewer/pages/readout_text.h"
#include "viewer/session/map_look.h"
#include "viewer/widgets/ink.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

constexpr float bar_thickness = 12.0F;
constexpr float tick_length = 4.0F;

std::string percentage(std::size_t count, std::size_t total) {
    const double percent = 100.0 * static_cast<double>(count) / static_cast<double>(total);
    return percent < 0.1 ? fmt::format("{} px", count) : fmt::format("{:.1f} %", percent);
}

std::string title_of(const Session& session) {
    const QuantityInfo& about = info(session.view().quantity);
    if (about.quantity == Quantity::color) return std::string(about.title);
    const Band& band = session.current()->picture().bands[session.view().band];
    const std::string_view in = unit_of(about.quantity, band);
    const std::string unit = in.empty() || in == "\u00b0" ? "" : fmt::format(" ({})", in);
    const auto comparison = session.comparison();
    const std::string_view how = about.of_two ? " from " : " minus that of ";
    const std::string minus = comparison ? std::string(how) + comparison->reference->name() : "";
    const Convention& convention = session.view().convention;
    const bool is_other = convention.stokes_text() != Convention{}.stokes_text();
    const std::string labels = is_other && depends_on_convention(about.quantity) ? ", " + convention.stokes_text() : "";
    return fmt::format("{}{}{}, {}{}", about.title, minus, unit, band_text(band), labels);
}

/// A box in the colors of the state, hatched if those change from pixel to pixel.
void draw_state_box(ImDrawList& list, ImVec2 at, float size, PixelState state, bool black_is_none) {
    const ImVec2 end(at.x + size, at.y + size);
    list.AddRectFilled(at, end, ink(state_color(state, 0, 0, black_is_none)));
    if (is_hatched(state)) {
        list.PushClipRect(at, end, true);
        for (float x = -size; x < size; x += 4.0F)
            list.AddLine({at.x + x, at.y + size}, {at.x + x + size, at.y}, ink(state_color(state, 4, 0)), 2.0F);
        list.PopClipRect();
    }
    list.AddRect(at, end, ImGui::GetColorU32(ImGuiCol_TextDisabled));
}

void draw_legend(const Session& session, const MapScale& scale) {
    const MapSummary& summary = session.shown_map().summary();
    for (std::size_t i = 1; i < pixel_state_count; ++i) {
        const auto state = static_cast<PixelState>(i);
        if (summary.state[i] == 0) continue;
        ImGui::SameLine(0.0F, 14.0F);
        const float size = ImGui::GetFontSize() - 3.0F;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::Dummy({size, size});
        draw_state_box(*ImGui::GetWindowDrawList(), {at.x, at.y + 2.0F}, size, state, scale.black_is_none);
        ImGui::SameLine(0.0F, 4.0F);
        ImGui::TextUnformatted(
            fmt::format("{} {}", state_text(state), percentage(summary.state[i], summary.pixels)).c_str());
        tooltip(std::string(state_definition(state)).c_str());
    }
    if (!session.view().fade_by_bar || !scale.can_fade() || scale.kind == ScaleKind::color) return;
    ImGui::SameLine(0.0F, 14.0F);
    ImGui::TextUnformatted("fades with the error bar");
    tooltip("Full color: exact. Gray: the bar covers half of the range.");
}

void draw_scale(ImDrawList& list, ImVec2 at, float width, ColorScale scale) {
    const int steps = std::max(2, static_cast<int>(width));
    for (int i = 0; i < steps; ++i) {
        const double t = (i + 0.5) / steps;
        const float x = at.x + width * static_cast<float>(i) / static_cast<float>(steps);
        list.AddRectFilled({x, at.y}, {x + width / static_cast<float>(steps) + 0.5F, at.y + bar_thickness},
                           ink(encode(scale_color(scale, t))));
    }
    list.AddRect(at, {at.x + width, at.y + bar_thickness}, ImGui::GetColorU32(ImGuiCol_TextDisabled));
}

void draw_ticks(ImDrawList& list, ImVec2 at, float width, const Session& session) {
    const MapRange range = bar_range(session);
    const ScaleWords words = map_options(session).words;
    const QuantityInfo& about = info(session.view().quantity);
    const ImU32 color = ImGui::GetColorU32(ImGuiCol_Text);
    const std::string unit(about.unit == "\u00b0" ? about.unit : "");
    for (const double tick : bar_ticks(range, map_look(session).kind)) {
        const float x = at.x + width * static_cast<float>((tick - range.low) / (range.high - range.low));
        list.AddLine({x, at.y}, {x, at.y + tick_length}, color);
        const std::string text = short_number(tick, 4, range.high - range.low) + unit + end_word(tick, range, words);
        const float half = 0.5F * ImGui::CalcTextSize(text.c_str()).x;
        const float left = std::clamp(x - half, at.x, at.x + width - 2.0F * half);
        list.AddText({left, at.y + tick_length}, color, text.c_str());
    }
}

}  // namespace

float color_bar_height() {
    return 2.0F * ImGui::GetTextLineHeightWithSpacing() + bar_thickness + tick_length;
}

void ColorBar::draw(const Session& session, Wishes& wishes, float width) {
    ImGui::TextUnformatted(title_of(session).c_str());
    tooltip(session.view().convention.definition(session.view().quantity).c_str());
    const MapScale scale = map_look(session);
    draw_legend(session, scale);
    if (session.view().quantity == Quantity::color) {
        ImGui::TextDisabled("exposure %+.2f stops, offset %+.2f, gamma %.2f", session.view().exposure,
                            session.view().offset, session.view().gamma);
        return;
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_scale(list, at, width, scale.scale);
    ImGui::InvisibleButton("color bar", {width, bar_thickness + tick_length + ImGui::GetTextLineHeight()},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    name_widget("color bar");
    if (can_move_range(session)) edit(session, wishes, width);
    draw_ticks(list, {at.x, at.y + bar_thickness}, width, session);
}

void ColorBar::edit(const Session& session, Wishes& wishes, float width) {
    const auto set_range = [&wishes](const MapRange& range) {
        wishes.add([range](Session& s) { set_bar_range(s, range); });
    };
    tooltip(
        "Drag an end to move it, the middle to move both; double click: the quantity's own range; right click: "
        "type numbers. N fits the range to the picture.");
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (ImGui::IsItemActivated()) {
        const float place = (mouse.x - ImGui::GetItemRectMin().x) / width;
        handle_ = place < 0.3F ? Handle::low : place > 0.7F ? Handle::high : Handle::both;
        grabbed_ = bar_range(session);
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        wishes.add(reset_bar_range);
        handle_ = Handle::none;
    }
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2.0F)) {
        const double by = static_cast<double>(ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 2.0F).x / width) *
                          (grabbed_.high - grabbed_.low);
        MapRange moved = grabbed_;
        if (handle_ == Handle::low || handle_ == Handle::both) moved.low += by;
        if (handle_ == Handle::high || handle_ == Handle::both) moved.high += by;
        if (handle_ != Handle::none) set_range(moved);
    }
    if (!ImGui::BeginPopupContextItem("range")) return;
    MapRange typed = bar_range(session);
    bool changed = ImGui::InputDouble("low", &typed.low, 0.0, 0.0, "%.6g");
    changed |= ImGui::InputDouble("high", &typed.high, 0.0, 0.0, "%.6g");
    if (changed) set_range(typed);
    if (ImGui::MenuItem("Fit to the picture", "N")) wishes.add(fit_bar_range);
    if (ImGui::MenuItem("The quantity's own")) wishes.add(reset_bar_range);
    ImGui::EndPopup();
}

void draw_azimuth_wheel(const Session& session, const DVec2& center, double radius) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ColorScale scale = map_look(session).scale;
    const ScaleWords words = map_options(session).words;
    list.AddCircleFilled(point(center), static_cast<float>(radius + 3.0), rim_color, 48);
    constexpr int steps = 72;
    for (int i = 0; i < steps; ++i) {
        const double from = 2.0 * pi * i / steps;
        const double to = 2.0 * pi * (i + 1.2) / steps;
        // Half a turn is the whole scale, which begins at -90 degrees; y runs downwards on screen. Who looks from the
        // source sees azimuths turn the other way.
        const double turn = (words.clockwise ? -1.0 : 1.0) * (from + pi / steps) / pi + 0.5;
        const DVec2 a(std::cos(from), -std::sin(from));
        const DVec2 b(std::cos(to), -std::sin(to));
        list.AddQuadFilled(point(center + 0.4 * radius * a), point(center + radius * a), point(center + radius * b),
                           point(center + 0.4 * radius * b), ink(encode(scale_color(scale, turn - std::floor(turn)))));
    }
}

}  // namespace pol
