// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/recent_files.h"

#include <imgui.h>

#include <filesystem>
#include <string>

#include "viewer/widgets/widget_map.h"

namespace pol {

void draw_recent_files(Session& session) {
    std::filesystem::path chosen;  // opening changes the list
    for (const std::filesystem::path& file : session.recent_files) {
        const std::string label = file.filename().string() + "  (" + file.parent_path().string() + ")";
        if (ImGui::Selectable(label.c_str())) chosen = file;
        name_widget("recent " + file.string());
    }
    if (!chosen.empty()) session.open(chosen);
}

}  // namespace pol
