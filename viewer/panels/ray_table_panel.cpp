// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/ray_table_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "viewer/pages/readout_text.h"
#include "viewer/panels/tree_state.h"
#include "viewer/session/pixel_export.h"
#include "viewer/widgets/tracers_convention.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

std::string cell_text(const RayTable& rays, const RayTable::Column& column, int branch) {
    if (column.text != nullptr) return column.text(rays, branch);
    const auto value = column.number(rays, branch);
    return value ? short_number(*value, 7) : std::string();
}

void draw_exports(Wishes& wishes) {
    const auto button = [&](const char* name, RayFormat format, const char* help) {
        if (ImGui::SmallButton(name)) wishes.add([format](Session& s) { export_rays(s, format); });
        name_widget(std::string("export ") + name);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
    };
    button("CSV", RayFormat::csv, "This table, all columns at full precision, in the tracer's convention");
    ImGui::SameLine();
    button("JSON", RayFormat::json, "The tree as polariscope explain --json prints it, in the tracer's convention");
    ImGui::SameLine();
    button("OBJ", RayFormat::obj, "The paths as lines in space, grouped by kind");
}

}  // namespace

void RayTablePanel::sort(int column, bool descending) {
    const RayTable& rays = *rays_;
    sorted_by_ = column;
    descending_ = descending;
    order_.resize(static_cast<std::size_t>(rays.size()));
    std::iota(order_.begin(), order_.end(), 0);
    const RayTable::Column& by = RayTable::columns()[static_cast<std::size_t>(column)];
    const auto arrange = [&](const auto& key) {
        std::vector<std::decay_t<decltype(key(0))>> keys;
        keys.reserve(order_.size());
        for (const int branch : order_) keys.push_back(key(branch));
        std::stable_sort(order_.begin(), order_.end(), [&](int a, int b) {
            const auto& ka = keys[static_cast<std::size_t>(a)];
            const auto& kb = keys[static_cast<std::size_t>(b)];
            return descending ? kb < ka : ka < kb;
        });
    };
    if (by.text != nullptr)
        arrange([&](int branch) { return by.text(rays, branch); });
    else  // NaN would break the order: it goes with what does not exist
        arrange([&](int branch) {
            const double value = by.number(rays, branch).value_or(-std::numeric_limits<double>::infinity());
            return std::isnan(value) ? -std::numeric_limits<double>::infinity() : value;
        });
}

void RayTablePanel::draw_table(const Session& session, Wishes& wishes) {
    const RayTable& rays = *rays_;
    const auto columns = RayTable::columns();
    constexpr ImGuiTableFlags look = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                                     ImGuiTableFlags_BordersOuter | ImGuiTableFlags_BordersInnerV |
                                     ImGuiTableFlags_Sortable | ImGuiTableFlags_Resizable | ImGuiTableFlags_Hideable |
                                     ImGuiTableFlags_SizingFixedFit;
    if (!ImGui::BeginTable("rays", static_cast<int>(columns.size()), look)) return;
    ImGui::TableSetupScrollFreeze(1, 1);
    for (const RayTable::Column& column : columns)
        ImGui::TableSetupColumn(std::string(column.name).c_str(), &column == columns.data()
                                                                      ? ImGuiTableColumnFlags_DefaultSort
                                                                      : ImGuiTableColumnFlags_None);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (int c = 0; c < static_cast<int>(columns.size()); ++c) {
        if (!ImGui::TableSetColumnIndex(c)) continue;
        ImGui::TableHeader(ImGui::TableGetColumnName(c));
        const std::string_view help = columns[static_cast<std::size_t>(c)].help;
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%.*s", static_cast<int>(help.size()), help.data());
    }
    if (ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs(); specs != nullptr && specs->SpecsDirty) {
        if (specs->SpecsCount > 0)
            sort(specs->Specs[0].ColumnIndex, specs->Specs[0].SortDirection == ImGuiSortDirection_Descending);
        specs->SpecsDirty = false;
    }
    if (session.selection().node != scrolled_to_) {
        scrolled_to_ = session.selection().node;
        const auto found = scrolled_to_ ? std::find(order_.begin(), order_.end(), *scrolled_to_) : order_.end();
        if (found != order_.end()) {
            const float row_height = ImGui::GetTextLineHeight() + 2.0F * ImGui::GetStyle().CellPadding.y;
            ImGui::SetScrollY(std::max(0.0F, static_cast<float>(found - order_.begin() - 3) * row_height));
        }
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(order_.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const int branch = order_[static_cast<std::size_t>(i)];
            ImGui::TableNextRow();
            for (int c = 0; c < static_cast<int>(columns.size()); ++c) {
                if (!ImGui::TableSetColumnIndex(c)) continue;
                const std::string text = cell_text(rays, columns[static_cast<std::size_t>(c)], branch);
                if (c > 0) {
                    ImGui::TextUnformatted(text.c_str());
                } else if (ImGui::Selectable(text.c_str(), session.selection().node == branch,
                                             ImGuiSelectableFlags_SpanAllColumns)) {
                    scrolled_to_ = branch;
                    wishes.add([branch](Session& s) { s.select_branch(branch); });
                }
            }
        }
    }
    ImGui::EndTable();
}

void RayTablePanel::draw(const Session& session, Wishes& wishes) {
    if (!draw_tree_state(session, wishes)) return;
    if (explanation_ != session.explanation()) {
        rays_.reset();
        explanation_ = session.explanation();
        plan_ = session.current()->plan();
        rays_.emplace(*plan_, *explanation_);
        sort(sorted_by_, descending_);
    }
    draw_sample_choice(session, wishes);
    ImGui::Text("%zu segments", explanation_->tree.nodes.size());
    ImGui::SameLine();
    draw_exports(wishes);
    say_tracers_convention(session.view().convention);
    draw_table(session, wishes);
}

}  // namespace pol
