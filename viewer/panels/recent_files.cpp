// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/recent_files.h"

#include <imgui.h>

#include <filesystem>
#include <string>

#include "viewer/widgets/widget_map.h"

namespace pol {

void draw_recent_files(const Session& session, Wishes& wishes) {
    for (const std::filesystem::path& file : session.recent_files()) {
        const std::string label = file.filename().string() + "  (" + file.parent_path().string() + ")";
        if (ImGui::Selectable(label.c_str())) wishes.add([file](Session& s) { s.open(file); });
        name_widget("recent " + file.string());
    }
}

}  // namespace pol
