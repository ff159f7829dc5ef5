// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/command_palette.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "viewer/commands/commands.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

bool contains_word(std::string_view text, std::string_view word) {
    const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
    return std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

std::vector<const Command*> matches(const Session& session, std::string_view typed) {
    std::vector<const Command*> found;
    for (const Command& command : commands()) {
        if (!is_enabled(command, session)) continue;
        if (contains_word(command.title, typed) || contains_word(help_of(command, session), typed))
            found.push_back(&command);
    }
    std::stable_partition(found.begin(), found.end(),
                          [typed](const Command* command) { return contains_word(command->title, typed); });
    return found;
}

}  // namespace

void CommandPalette::draw(const Session& session, Wishes& wishes) {
    bool visible = session.window().palette_visible;
    constexpr const char* name = "Find a command";
    if (visible && !ImGui::IsPopupOpen(name)) {
        typed_.clear();
        chosen_ = 0;
        ImGui::OpenPopup(name);
    }
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({0.5F * display.x, 0.15F * display.y}, ImGuiCond_Always, {0.5F, 0.0F});
    ImGui::SetNextWindowSize({34.0F * em, 0.0F});
    if (!ImGui::BeginPopupModal(name, &visible, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize)) {
        if (visible != session.window().palette_visible) wishes.set(&WindowState::palette_visible, visible);
        return;
    }
    log_window();
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0F);
    const bool entered =
        ImGui::InputTextWithHint("##typed", "part of a name", &typed_, ImGuiInputTextFlags_EnterReturnsTrue);
    if (ImGui::IsItemEdited()) chosen_ = 0;
    const std::vector<const Command*> found = matches(session, typed_);
    const int count = static_cast<int>(found.size());
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow))) ++chosen_;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow))) --chosen_;
    chosen_ = std::clamp(chosen_, 0, std::max(0, count - 1));

    const Command* run = entered && count > 0 ? found[static_cast<std::size_t>(chosen_)] : nullptr;
    ImGui::BeginChild("found", {0.0F, 18.0F * em});
    for (int i = 0; i < count; ++i) {
        const Command& command = *found[static_cast<std::size_t>(i)];
        const std::string label =
            std::string(command.group) + ": " + std::string(command.title) + "##" + std::to_string(i);
        if (ImGui::Selectable(label.c_str(), i == chosen_)) run = &command;
        if (i == chosen_ && (ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_DownArrow)) ||
                             ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_UpArrow))))
            ImGui::SetScrollHereY();
        const std::string keys = name_of(command.chord);
        ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(keys.c_str()).x);
        ImGui::TextDisabled("%s", keys.c_str());
    }
    if (count == 0) ImGui::TextDisabled("No command is called so.");
    ImGui::EndChild();
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) visible = false;
    if (run != nullptr) visible = false;
    if (!visible) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    if (!visible) wishes.set(&WindowState::palette_visible, false);
    if (run != nullptr) wish(wishes, *run);
}

}  // namespace pol
