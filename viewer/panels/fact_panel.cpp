// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/fact_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <string>

#include "viewer/pages/fact_page.h"
#include "viewer/pages/readout_text.h"
#include "viewer/panels/tree_state.h"
#include "viewer/widgets/copyable.h"
#include "viewer/widgets/theme.h"
#include "viewer/widgets/tracers_convention.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

void dim_text(const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

void draw_number(const char* name, double value, const std::string& unit) {
    constexpr int digits = 11;  // what fits into a panel of 400 points
    const std::string after = unit.empty() ? "" : " " + unit;
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", name);
    ImGui::TableNextColumn();
    copyable(name, short_number(value, digits) + after, fmt::format("{:.17g}{}", value, after), "");
}

void draw_row(const FactRow& row, const ThemeColors& color) {
    const verify::Reading& reading = *row.reading;
    ImGui::Separator();
    ImGui::TextWrapped("%s", reading.what.c_str());
    if (row.result) {
        const bool pass = row.result->verdict == verify::Verdict::pass;
        ImGui::SameLine();
        ImGui::TextColored(pass ? color.good : color.error, "%s",
                           std::string(verify::verdict_text(row.result->verdict)).c_str());
    }
    if (ImGui::BeginTable("numbers", 4)) {
        for (const bool stretched : {false, true, false, true})
            ImGui::TableSetupColumn("",
                                    stretched ? ImGuiTableColumnFlags_WidthStretch : ImGuiTableColumnFlags_WidthFixed);
        draw_number("expected", reading.expected, reading.unit);
        if (row.result) draw_number("measured", row.result->measured, reading.unit);
        ImGui::EndTable();
    }
    const std::string tolerance = short_number(reading.tolerance.value, 3) + " (" + reading.tolerance.from + ")";
    dim_text(row.result ? "deviation: " + short_number(row.result->deviation, 3) + " tolerances of " + tolerance
                        : "tolerance: " + tolerance);
}

}  // namespace

void draw_fact_panel(const Session& session, Wishes& wishes) {
    const FactPage page = make_fact_page(session);
    ImGui::TextWrapped("%s  %s", page.fact->id.c_str(), page.fact->sentence.c_str());
    dim_text("Source: " + page.fact->source);
    if (!page.view->name.empty()) ImGui::TextWrapped("This view: %s", page.view->name.c_str());

    if (!page.pinned) {
        ImGui::TextWrapped("The fact is about pixel %d,%d.", page.view->x, page.view->y);
        if (ImGui::Button("Pin it")) wishes.add(&Session::pin_fact);
        name_widget("button Pin it");
    } else if (!page.trouble.empty()) {
        ImGui::TextColored(colors(session.window().theme).error, "%s", page.trouble.c_str());
    } else {
        draw_tree_state(session, wishes);
    }
    say_tracers_convention(session.view().convention);
    for (const FactRow& row : page.rows) {
        ImGui::PushID(row.reading);
        draw_row(row, colors(session.window().theme));
        ImGui::PopID();
    }
}

}  // namespace pol
