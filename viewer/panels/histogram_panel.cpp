// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/histogram_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "viewer/pages/readout_text.h"
#include "viewer/session/map_look.h"
#include "viewer/widgets/ink.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {
constexpr std::size_t bin_count = 100;
constexpr float bars_height = 90.0F;
}  // namespace

void HistogramPanel::draw(const Session& session, Wishes& wishes) {
    const MapRange range = bar_range(session);
    const bool is_current = map_version_ == session.shown_map().version() && histogram_.range.low == range.low &&
                            histogram_.range.high == range.high && !histogram_.bins.empty();
    if (!is_current) {
        histogram_ = histogram_of(session.shown_map(), range, bin_count);
        map_version_ = session.shown_map().version();
    }

    const ImVec2 at = ImGui::GetCursorScreenPos();
    const DVec2 origin(at.x, at.y);
    const DVec2 size(std::max(10.0F, ImGui::GetContentRegionAvail().x), bars_height);
    ImGui::InvisibleButton("histogram", point(size));
    name_widget("histogram");
    brush(session, wishes, origin, size);
    draw_bars(session, origin, size);
    ImGui::TextDisabled("%s", short_number(range.low, 4).c_str());
    const std::string high = short_number(range.high, 4);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(high.c_str()).x);
    ImGui::TextDisabled("%s", high.c_str());
    ImGui::Checkbox("logarithmic", &is_logarithmic_);
    tooltip("Heights of the bars by the logarithm of their counts: rare values become visible.");
    if (!session.selection().marked.empty()) {
        const auto count = std::count(session.selection().marked.begin(), session.selection().marked.end(), true);
        ImGui::SameLine();
        if (ImGui::SmallButton(fmt::format("clear {} marked", count).c_str()))
            wishes.add([](Session& s) { s.mark({}); });
        tooltip("Marked pixels keep their color, all others are veiled.");
    }
    count_states(session, wishes);
}

void HistogramPanel::brush(const Session& session, Wishes& wishes, const DVec2& origin, const DVec2& size) {
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) {
        const double place = (ImGui::GetIO().MousePos.x - origin.x) / size.x;
        const auto bin = static_cast<std::size_t>(std::clamp(place, 0.0, 0.9999) * bin_count);
        const double width = (histogram_.range.high - histogram_.range.low) / bin_count;
        const double low = histogram_.range.low + static_cast<double>(bin) * width;
        ImGui::SetTooltip("%s to %s: %zu pixels\nDrag to mark pixels with such values, click to unmark.",
                          short_number(low, 4).c_str(), short_number(low + width, 4).c_str(), histogram_.bins[bin]);
    }
    const auto value_at = [&](float x) {
        const double place = std::clamp((x - origin.x) / size.x, 0.0, 1.0);
        return histogram_.range.low + place * (histogram_.range.high - histogram_.range.low);
    };
    const float mouse = ImGui::GetIO().MousePos.x;
    if (ImGui::IsItemActivated()) brush_from_ = value_at(mouse);
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2.0F)) {
        const double to = value_at(mouse);
        const MapRange wanted{std::min(brush_from_, to), std::max(brush_from_, to)};
        const auto& brushed = session.selection().brushed;
        if (brushed && brushed->low == wanted.low && brushed->high == wanted.high) return;
        wishes.add([wanted](Session& s) { s.mark_values(wanted); });
    } else if (ImGui::IsItemDeactivated() && ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 2.0F).x == 0.0F) {
        wishes.add([](Session& s) { s.mark({}); });
    }
}

void HistogramPanel::draw_bars(const Session& session, const DVec2& origin, const DVec2& size) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(point(origin), point(origin + size), ImGui::GetColorU32(ImGuiCol_FrameBg));
    const auto height = [&](std::size_t count) {
        const auto n = static_cast<double>(count);
        return is_logarithmic_ ? std::log1p(n) : n;
    };
    const double highest = std::max(1.0, height(histogram_.highest()));
    const bool is_color = session.view().quantity == Quantity::color;
    const ColorScale scale = is_color ? ColorScale::gray : map_look(session).scale;
    const double bin_width = size.x / static_cast<double>(bin_count);
    for (std::size_t i = 0; i < histogram_.bins.size(); ++i) {
        if (histogram_.bins[i] == 0) continue;
        const double place = static_cast<double>(i);
        // A bar of one pixel among a million can still be seen.
        const double top = std::max(1.0, (size.y - 2.0) * height(histogram_.bins[i]) / highest);
        const DVec2 low = origin + DVec2(place * bin_width, size.y);
        const DVec2 high = origin + DVec2((place + 1.0) * bin_width, size.y - top);
        list.AddRectFilled(point({low.x, high.y}), point({high.x, low.y}), ImGui::GetColorU32(ImGuiCol_TextDisabled));
        list.AddRectFilled(point({low.x, high.y}), point({high.x, std::min(low.y, high.y + 3.0)}),
                           ImGui::GetColorU32(ImGuiCol_PlotHistogram));
    }
    for (std::size_t i = 0; i < bin_count; ++i) {
        const double x = origin.x + static_cast<double>(i) * bin_width;
        const double t = (static_cast<double>(i) + 0.5) / static_cast<double>(bin_count);
        list.AddRectFilled(point({x, origin.y + size.y - 3.0}), point({x + bin_width, origin.y + size.y}),
                           ink(encode(scale_color(scale, t))));
    }
    const auto& brushed = session.selection().brushed;
    if (!brushed) return;
    const double span = histogram_.range.high - histogram_.range.low;
    const double from = std::clamp((brushed->low - histogram_.range.low) / span, 0.0, 1.0);
    const double to = std::clamp((brushed->high - histogram_.range.low) / span, 0.0, 1.0);
    list.AddRectFilled(point(origin + DVec2(from * size.x, 0.0)), point(origin + DVec2(to * size.x + 1.0, size.y)),
                       IM_COL32(255, 214, 10, 60));
    list.AddRect(point(origin + DVec2(from * size.x, 0.0)), point(origin + DVec2(to * size.x + 1.0, size.y)), pin_ink);
}

void HistogramPanel::count_states(const Session& session, Wishes& wishes) {
    const MapSummary& summary = session.shown_map().summary();
    if (histogram_.below + histogram_.above > 0)
        ImGui::TextDisabled("%zu below, %zu above the range", histogram_.below, histogram_.above);
    for (std::size_t i = 1; i < pixel_state_count; ++i) {
        if (summary.state[i] == 0) continue;
        const auto state = static_cast<PixelState>(i);
        const std::string text = fmt::format("{}: {} pixels", state_text(state), summary.state[i]);
        if (ImGui::Selectable(text.c_str())) wishes.add([state](Session& s) { s.mark_state(state); });
        tooltip("Click to mark these pixels.");
    }
}

}  // namespace pol
