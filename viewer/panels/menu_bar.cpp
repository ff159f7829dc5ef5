// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/menu_bar.h"

#include <imgui.h>

#include <string>

#include "viewer/commands.h"

namespace pol {

float draw_menu_bar(Session& session) {
    if (!ImGui::BeginMainMenuBar()) return 0.0F;
    for (const char* group : {"File", "View", "Map"}) {
        if (!ImGui::BeginMenu(group)) continue;
        for (const Command& command : commands()) {
            if (command.group != group) continue;
            const bool enabled = command.enabled == nullptr || command.enabled(session);
            if (ImGui::MenuItem(std::string(command.title).c_str(), name_of(command.chord).c_str(), false, enabled))
                command.run(session);
        }
        ImGui::EndMenu();
    }
    const float height = ImGui::GetWindowSize().y;
    ImGui::EndMainMenuBar();
    return height;
}

}  // namespace pol
