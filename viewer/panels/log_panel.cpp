// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/log_panel.h"

#include <imgui.h>

#include <string>

#include "viewer/widgets/theme.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

std::string as_text(const std::vector<LogLine>& lines) {
    std::string text;
    for (const LogLine& line : lines) text += line.text + '\n';
    return text;
}

}  // namespace

void LogPanel::draw(const Session& session, Wishes& wishes) {
    const WindowState& window = session.window();
    if (!window.log_visible) return;
    bool visible = true;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.2F * display.x, 0.5F * display.y}, ImGuiCond_Appearing);
    ImGui::SetNextWindowSize({0.6F * display.x, 0.42F * display.y}, ImGuiCond_Appearing);
    if (ImGui::Begin("Log", &visible, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
        log_window();
        const std::vector<LogLine>& lines = session.log().lines();
        if (ImGui::Button("Copy all")) ImGui::SetClipboardText(as_text(lines).c_str());
        ImGui::Separator();
        ImGui::BeginChild("lines");
        if (lines.empty()) ImGui::TextDisabled("Nothing has been said yet.");
        ImGui::PushTextWrapPos(0.0F);
        for (const LogLine& line : lines) {
            ImGui::PushStyleColor(ImGuiCol_Text, color_of(window.theme, line.severity));
            ImGui::TextUnformatted(line.text.c_str());
            ImGui::PopStyleColor();
        }
        ImGui::PopTextWrapPos();
        if (lines.size() != lines_seen_) ImGui::SetScrollHereY(1.0F);
        lines_seen_ = lines.size();
        ImGui::EndChild();
    }
    ImGui::End();
    if (!visible) wishes.set(&WindowState::log_visible, false);
}

}  // namespace pol
