// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/rewrite_dialog.h"

#include <imgui.h>

#include <string>

#include "viewer/widgets/widget_map.h"

namespace pol {

void draw_rewrite_dialog(Session& session) {
    bool& asked = session.window.rewrite_asked;
    const Document* document = session.current();
    if (document == nullptr) asked = false;
    if (!asked) return;
    constexpr const char* name = "Write the file anew?";
    if (!ImGui::IsPopupOpen(name)) ImGui::OpenPopup(name);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * display.x, 0.4F * display.y}, ImGuiCond_Always, {0.5F, 0.5F});
    if (!ImGui::BeginPopupModal(name, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove)) return;
    log_window();
    ImGui::Text("%s cannot take this edit as it is: written anew, it has other words and no comments.",
                document->name().c_str());
    ImGui::Text("The file that is there now is kept as %s.bak.", document->name().c_str());
    ImGui::Spacing();
    const bool agreed = ImGui::Button("Write anew");
    name_widget("button Write anew");
    ImGui::SameLine();
    if (agreed || ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
        asked = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
    if (agreed) session.save(document->path(), Document::Rewrite::keep_backup);
}

}  // namespace pol
