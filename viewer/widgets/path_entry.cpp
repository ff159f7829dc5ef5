// SPDX-License-Identifier: Apache-2.0
#include "viewer/widgets/path_entry.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <cstdlib>

#include "viewer/widgets/widget_map.h"

namespace pol {

std::filesystem::path typed_path(const std::string& typed) {
    const char* home = std::getenv("HOME");
    if (home != nullptr && typed.starts_with("~/")) return std::filesystem::path(home) / typed.substr(2);
    return typed;
}

bool begin_path_page(const char* title, bool& visible, std::string& typed, const char* hint, const char* button,
                     bool focus, bool& wanted) {
    const float em = ImGui::GetFontSize();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * display.x, 0.15F * display.y}, ImGuiCond_Always, {0.5F, 0.0F});
    ImGui::SetNextWindowSize({44.0F * em, 0.0F});
    if (!ImGui::BeginPopupModal(title, &visible, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize)) return false;
    log_window();
    if (focus || ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-6.0F * em);
    wanted = ImGui::InputTextWithHint("##path", hint, &typed, ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::SameLine();
    wanted |= ImGui::Button(button, {-1.0F, 0.0F});
    name_widget(std::string("entry ") + button);
    return true;
}

void end_path_page(bool& visible, const std::string& complaint, const ImVec4& color) {
    if (!complaint.empty()) {
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextColored(color, "%s", complaint.c_str());
        ImGui::PopTextWrapPos();
    }
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) visible = false;
    if (!visible) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace pol
