// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/menu_bar.h"

#include <imgui.h>

#include <string>
#include <vector>

#include "viewer/commands/commands.h"
#include "viewer/panels/facts_menu.h"
#include "viewer/panels/recent_files.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

void draw_entry(const Session& session, Wishes& wishes, const Command& command) {
    const bool checked = command.checked != nullptr && command.checked(session);
    if (ImGui::MenuItem(std::string(command.title).c_str(), name_of(command.chord).c_str(), checked,
                        is_enabled(command, session)))
        wish(wishes, command);
    name_widget("command " + std::string(command.title));
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help_of(command, session).c_str());
}

void draw_open_recent(const Session& session, Wishes& wishes) {
    const bool open = ImGui::BeginMenu("Open recent", !session.recent_files().empty());
    name_widget("menu Open recent");
    if (!open) return;
    draw_recent_files(session, wishes);
    ImGui::EndMenu();
}

}  // namespace

float draw_menu_bar(const Session& session, Wishes& wishes) {
    if (!ImGui::BeginMainMenuBar()) return 0.0F;
    const auto all = commands();
    for (std::size_t first = 0; first < all.size();) {
        const std::string_view group = all[first].group;
        std::size_t end = first;
        while (end < all.size() && all[end].group == group) ++end;
        if (group == "Help") draw_facts_menu(wishes);  // Help is the last one, as everywhere
        const bool open = ImGui::BeginMenu(std::string(group).c_str());
        name_widget("menu " + std::string(group));
        if (open) {
            if (group == "File") draw_open_recent(session, wishes);
            for (std::size_t i = first; i < end; ++i)
                if (all[i].is_listed) draw_entry(session, wishes, all[i]);
            ImGui::EndMenu();
        }
        first = end;
    }
    const float height = ImGui::GetWindowSize().y;
    ImGui::EndMainMenuBar();
    return height;
}

}  // namespace pol
