// SPDX-License-Identifier: Apache-2.0
// A question over the window that waits for an answer.
#pragma once

#include <imgui.h>

#include <string>

#include "viewer/widgets/widget_map.h"

namespace pol {

/// True while it is open, which is while it is `asked`; then ends by ImGui::EndPopup().
inline bool begin_question(const char* name, bool asked) {
    if (!asked && !ImGui::IsPopupOpen(name)) return false;
    if (asked && !ImGui::IsPopupOpen(name)) ImGui::OpenPopup(name);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * display.x, 0.4F * display.y}, ImGuiCond_Always, {0.5F, 0.5F});
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove;
    // With a flag that is false ImGui closes it; with one that is true it would have a button to do so.
    bool open = false;
    if (!ImGui::BeginPopupModal(name, asked ? nullptr : &open, flags)) return false;
    log_window();
    return true;
}

/// A button that tests know as "button LABEL".
inline bool button(const char* label) {
    const bool pressed = ImGui::Button(label);
    name_widget(std::string("button ") + label);
    return pressed;
}

}  // namespace pol
