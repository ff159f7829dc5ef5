// SPDX-License-Identifier: Apache-2.0
// A text that copies itself, at full precision, when it is clicked.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

namespace pol {

/// Shows `shown`; a click puts `exact` into the clipboard. The tooltip has `help` and what would be copied. Empty
/// `exact`: plain text with `help`. `id` tells it from others of the same text.
inline void copyable(const char* id, const std::string& shown, const std::string& exact, std::string_view help) {
    const auto tooltip = [&](const char* after) {
        if (!ImGui::IsItemHovered()) return;
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(ImGui::GetFontSize() * 30.0F);
        if (!help.empty()) ImGui::TextUnformatted(help.data(), help.data() + help.size());
        if (!exact.empty()) ImGui::TextDisabled("%s: %s", after, exact.c_str());
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    };
    if (exact.empty()) {
        ImGui::TextDisabled("%s", shown.c_str());
        tooltip("");
        return;
    }
    ImGui::PushID(id);
    if (ImGui::Selectable(shown.c_str())) ImGui::SetClipboardText(exact.c_str());
    tooltip("A click copies");
    ImGui::PopID();
}

}  // namespace pol
