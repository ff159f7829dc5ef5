// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/region_panel.h"

#include <imgui.h>

#include "viewer/commands/commands.h"
#include "viewer/widgets/copyable.h"
#include "viewer/widgets/ink.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

/// A region of a picture that is being rendered is looked at again so often.
constexpr double counted_again_after_s = 0.5;

void draw_group(const PageGroup& group) {
    if (group.rows.empty()) return;
    ImGui::TextDisabled("%s", group.title.c_str());
    if (!ImGui::BeginTable(group.title.c_str(), 3, ImGuiTableFlags_SizingStretchProp)) return;
    for (const PageRow& row : group.rows) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(row.name.c_str());
        ImGui::TableNextColumn();
        copyable(row.name.c_str(), row.value, row.exact, row.help);
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", row.bar.c_str());
    }
    ImGui::EndTable();
}

}  // namespace

void RegionPanel::draw(const Session& session, Wishes& wishes) {
    if (session.current() == nullptr || !session.selection().region) {
        key_.reset();
        ImGui::TextWrapped(
            "Shift and drag over the picture draws a region: its mean light, how much it varies, and how "
            "far it is from the reference.");
        if (session.current() == nullptr || session.current()->picture().pixel_count() == 0) return;
        const StokesImage& picture = session.current()->picture();
        const TileRect all{0, 0, picture.width, picture.height};
        if (ImGui::Button("whole picture")) wishes.add([all](Session& s) { s.select_region(all); });
        name_widget("whole picture");
        return;
    }
    const RegionPageKey key = region_page_key(session);
    const bool only_grew = key_ && key_->layout == key.layout && key_->region.x0 == key.region.x0 &&
                           key_->region.y1 == key.region.y1 && session.current()->tracing();
    if (key_ != key && (!only_grew || ImGui::GetTime() - made_s_ > counted_again_after_s)) {
        page_ = make_region_page(session);
        key_ = key;
        made_s_ = ImGui::GetTime();
    }
    ImGui::TextUnformatted(page_.title.c_str());
    ImGui::SameLine();
    if (ImGui::SmallButton("copy")) ImGui::SetClipboardText(text_of(page_).c_str());
    name_widget("copy region");
    tooltip("Copies all of these numbers with all their digits.");
    draw_group(page_.light);
    ImGui::Spacing();
    draw_group(page_.metrics);
    if (!page_.why_not.empty()) ImGui::TextWrapped("No metrics: %s.", page_.why_not.c_str());
}

}  // namespace pol
