// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/paths_panel.h"

#include <imgui.h>

#include <algorithm>
#include <string>

#include "viewer/pages/branch_page.h"
#include "viewer/pages/readout_text.h"
#include "viewer/panels/tree_state.h"
#include "viewer/widgets/copyable.h"
#include "viewer/widgets/tracers_convention.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

constexpr int deepest_indent = 12;  ///< deeper rows stay there, or no room is left for their text

std::string percent(double part, double whole) {
    return whole > 0.0 ? short_number(100.0 * part / whole, 3) + " %" : std::string("-");
}

std::string exact(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

bool check(const char* label, bool& value, const char* help) {
    const bool changed = ImGui::Checkbox(label, &value);
    name_widget(std::string("filter ") + label);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
    return changed;
}

/// "through" any body of the plan.
void choose_body(const Plan& plan, std::optional<int>& body) {
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 11.0F);
    if (!ImGui::BeginCombo("through", body ? plan.body_name(*body).c_str() : "anything")) return;
    if (ImGui::Selectable("anything", !body)) body.reset();
    const int count = plan.solid_count() + static_cast<int>(plan.surfaces.size());
    for (int i = 0; i < count; ++i) {
        ImGui::PushID(i);
        if (ImGui::Selectable(plan.body_name(i).c_str(), body == i)) body = i;
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

void draw_sums(const Explanation& explanation, const PathList& list) {
    const PathCount& shown = list.shown();
    const PathCount& all = list.all();
    ImGui::Text("%zu of %zu leaves: %s of S0, weight %s", shown.leaves, all.leaves,
                percent(shown.s0, explanation.sample_light.s0).c_str(), short_number(shown.weight, 4).c_str());
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("What the listed leaves bring to the pixel, and their share of unpolarized light");
    ImGui::TextUnformatted("leaves' sum");
    ImGui::SameLine(ImGui::GetFontSize() * 7.0F);
    copyable("sum", "S0 " + exact(explanation.leaf_sum.s0), exact(explanation.leaf_sum.s0),
             "S0 of all leaves, added in the order in which they ended");
    ImGui::TextUnformatted("rendered");
    ImGui::SameLine(ImGui::GetFontSize() * 7.0F);
    copyable("rendered", "S0 " + exact(explanation.sample_light.s0), exact(explanation.sample_light.s0),
             "S0 of the sample from the kernel that makes pictures");
    ImGui::TextUnformatted(explanation.exact() ? "All four components agree to the last bit."
                                               : "They do NOT agree: a defect, please report it.");
}

}  // namespace

void PathsPanel::draw_controls(const Plan& plan) {
    constexpr const char* orders[] = {"heaviest first", "brightest first", "as traced"};
    int order = static_cast<int>(list_.order());
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 11.0F);
    if (ImGui::Combo("order", &order, orders, 3)) list_.set_order(static_cast<PathOrder>(order));
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Of branches that grow from the same branch");
    PathFilter filter = list_.filter();
    check("only e", filter.only_e, "Paths that go through crystals as extraordinary rays alone");
    ImGui::SameLine();
    check("total reflection", filter.total_reflection, "Paths with at least one total reflection");
    check("share above 1 %", filter.bright, "Paths that bring at least 1 % of the pixel's S0");
    ImGui::SameLine();
    check("not followed", filter.not_followed, "Paths that were not followed to their end: it says why instead");
    choose_body(plan, filter.body);
    list_.set_filter(filter);
    if (ImGui::SmallButton("Open all")) list_.open_all(true);
    ImGui::SameLine();
    if (ImGui::SmallButton("Close all")) list_.open_all(false);
}

void PathsPanel::draw_rows(const Session& session, Wishes& wishes, float height) {
    const Explanation& explanation = *list_.explanation();
    const Plan& plan = *session.current()->plan();
    constexpr ImGuiTableFlags look =
        ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter | ImGuiTableFlags_Resizable;
    if (!ImGui::BeginTable("paths", 4, look, {0.0F, height})) return;
    const float em = ImGui::GetFontSize();
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("path", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("weight", ImGuiTableColumnFlags_WidthFixed, 4.0F * em);
    ImGui::TableSetupColumn("share", ImGuiTableColumnFlags_WidthFixed, 3.8F * em);
    ImGui::TableSetupColumn("meets", ImGuiTableColumnFlags_WidthFixed, 5.2F * em);
    ImGui::TableHeadersRow();
    if (session.selection().node != scrolled_to_) {
        scrolled_to_ = session.selection().node;
        if (scrolled_to_) {
            list_.reveal(*scrolled_to_);
            const float row_height = ImGui::GetTextLineHeight() + 2.0F * ImGui::GetStyle().CellPadding.y;
            if (const auto row = list_.row_of(*scrolled_to_))
                ImGui::SetScrollY(std::max(0.0F, (static_cast<float>(*row) + 2.0F) * row_height - 0.5F * height));
        }
    }
    // Opening a branch changes the rows: it is done after they are drawn.
    std::optional<int> toggled;
    const std::vector<PathList::Row>& rows = list_.rows();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const PathList::Row row = rows[static_cast<std::size_t>(i)];
            const RayTreeNode& node = explanation.tree.nodes[static_cast<std::size_t>(row.branch)];
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::SetCursorPosX(ImGui::GetCursorPosX() +
                                 0.55F * em * static_cast<float>(std::min(row.indent, deepest_indent)));
            ImGui::SetNextItemOpen(list_.is_open(row.branch));
            ImGuiTreeNodeFlags flags =
                ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_SpanFullWidth;
            if (node.children.empty()) flags |= ImGuiTreeNodeFlags_Leaf;
            if (session.selection().node == row.branch) flags |= ImGuiTreeNodeFlags_Selected;
            ImGui::TreeNodeEx(
                reinterpret_cast<void*>(static_cast<std::intptr_t>(row.branch)), flags, "%s",
                branch_title(plan, explanation, row.branch, list_.is_total_reflection(row.branch)).c_str());
            if (row.branch < 100) name_widget("branch " + std::to_string(row.branch));
            if (ImGui::IsItemToggledOpen()) {
                toggled = row.branch;
            } else if (ImGui::IsItemClicked()) {
                scrolled_to_ = row.branch;
                wishes.add([branch = row.branch](Session& s) { s.select_branch(branch); });
            }
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(short_number(node.start.weight, 3).c_str());
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(percent(node.share.s0, explanation.sample_light.s0).c_str());
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(branch_end(plan, explanation, row.branch).c_str());
        }
    }
    ImGui::EndTable();
    if (toggled) list_.set_open(*toggled, !list_.is_open(*toggled));
}

void PathsPanel::draw(const Session& session, Wishes& wishes) {
    if (!draw_tree_state(session, wishes)) return;
    const auto explanation = session.explanation();
    if (list_.explanation() != explanation) list_.set_tree(session.current()->plan(), explanation);
    draw_sample_choice(session, wishes);
    draw_controls(*session.current()->plan());
    draw_sums(*explanation, list_);
    const bool has_details = session.selection().node.has_value();
    const float below = has_details ? 0.45F * ImGui::GetContentRegionAvail().y : 0.0F;
    const float least = 8.0F * ImGui::GetTextLineHeightWithSpacing();
    draw_rows(session, wishes, std::max(least, ImGui::GetContentRegionAvail().y - below));
    if (!session.selection().node) return;
    const PageGroup page = make_branch_page(*session.current()->plan(), *explanation, *session.selection().node);
    ImGui::TextUnformatted(page.title.c_str());
    say_tracers_convention(session.view().convention);
    if (!ImGui::BeginTable("branch", 2)) return;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    for (const PageRow& row : page.rows) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(row.name.c_str());
        ImGui::TableNextColumn();
        copyable(row.name.c_str(), row.value, row.exact, row.help);
    }
    ImGui::EndTable();
}

}  // namespace pol
