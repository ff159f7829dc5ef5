// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/help_overlay.h"

#include <imgui.h>

#include <array>
#include <string>
#include <vector>

#include "viewer/commands/commands.h"
#include "viewer/widgets/fonts.h"
#include "viewer/widgets/theme.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

struct MouseHelp {
    const char* what;
    const char* does;
};

constexpr std::array mouse_help{
    MouseHelp{"Wheel", "Zoom at the cursor"},
    MouseHelp{"Drag", "Move the picture"},
    MouseHelp{"Click", "Pin a pixel: its matrix and paths"},
    MouseHelp{"Shift+drag", "Draw a region"},
    MouseHelp{"Alt+drag", "Orbit the scene's camera"},
    MouseHelp{"Alt+Shift+drag", "Pan the scene's camera"},
    MouseHelp{"Alt+wheel", "Dolly the scene's camera"},
    MouseHelp{"Drop a file", "Open it"},
};

std::string keys_of(const Command& command) {
    std::string keys = name_of(command.chord);
    for (const KeyChord& other : {command.also, command.if_free})
        if (other.key != Key::none) keys += "  " + name_of(other);
    return keys;
}

void row(const std::string& keys, const std::string& title, const std::string& help) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushFont(font(FontRole::mono));
    ImGui::TextUnformatted(keys.c_str());
    ImGui::PopFont();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(title.c_str());
    if (!help.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help.c_str());
}

void heading(Theme theme, std::string_view text) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TableNextColumn();
    ImGui::PushFont(font(FontRole::bold));
    ImGui::TextColored(colors(theme).accent, "%.*s", static_cast<int>(text.size()), text.data());
    ImGui::PopFont();
}

/// A block of rows that is not torn between columns.
struct Group {
    std::string_view name;
    std::vector<const Command*> commands;
};

std::vector<Group> groups_with_keys() {
    std::vector<Group> groups;
    for (const Command& command : commands()) {
        if (command.chord.key == Key::none || !command.is_listed) continue;
        if (groups.empty() || groups.back().name != command.group) groups.push_back({command.group, {}});
        groups.back().commands.push_back(&command);
    }
    return groups;
}

/// Splits the groups over columns of about equal length, in order.
std::vector<std::vector<Group>> in_columns(const std::vector<Group>& groups, std::size_t count) {
    std::size_t rows = mouse_help.size() + 1;
    for (const Group& group : groups) rows += group.commands.size() + 1;
    std::vector<std::vector<Group>> columns(1);
    std::size_t filled = 0;
    for (const Group& group : groups) {
        const std::size_t size = group.commands.size() + 1;
        if (filled + size / 2 > rows * columns.size() / count && columns.size() < count) columns.emplace_back();
        columns.back().push_back(group);
        filled += size;
    }
    return columns;
}

void draw_column(const std::vector<Group>& column, bool last, int index, const Session& session) {
    if (!ImGui::BeginTable(("keys" + std::to_string(index)).c_str(), 2, ImGuiTableFlags_SizingFixedFit)) return;
    for (const Group& group : column) {
        heading(session.window().theme, group.name);
        for (const Command* command : group.commands)
            row(keys_of(*command), std::string(command->title), help_of(*command, session));
    }
    if (last) {
        heading(session.window().theme, "Mouse, on the picture");
        for (const MouseHelp& help : mouse_help) row(help.what, help.does, {});
    }
    ImGui::EndTable();
}

}  // namespace

void draw_help_overlay(const Session& session, Wishes& wishes) {
    const WindowState& window = session.window();
    if (!window.help_visible) return;
    bool visible = true;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * display.x, 0.5F * display.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {0.98F * display.x, 0.98F * display.y});
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove;
    if (ImGui::Begin("Keys and mouse", &visible, flags)) {
        log_window();
        const float width_of_four = 80.0F * ImGui::GetFontSize();
        const auto columns = in_columns(groups_with_keys(), display.x > width_of_four ? 4 : 3);
        for (std::size_t i = 0; i < columns.size(); ++i) {
            if (i > 0) ImGui::SameLine(0.0F, 2.0F * ImGui::GetFontSize());
            ImGui::BeginGroup();
            draw_column(columns[i], i + 1 == columns.size(), static_cast<int>(i), session);
            ImGui::EndGroup();
        }
        ImGui::TextDisabled("Esc closes this help. The arrow keys move the pin while a pixel is pinned.");
    }
    ImGui::End();
    if (!visible) wishes.set(&WindowState::help_visible, false);
}

}  // namespace pol
