// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/welcome.h"

#include <imgui.h>

#include <algorithm>
#include <system_error>

#include "io/files/assets.h"
#include "viewer/panels/recent_files.h"
#include "viewer/widgets/fonts.h"
#include "viewer/widgets/theme.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> shipped_scenes() {
    std::vector<fs::path> scenes;
    std::error_code failed;
    for (const fs::directory_entry& entry : fs::directory_iterator(assets_dir() / "scenes", failed))
        if (entry.path().extension() == ".yaml") scenes.push_back(entry.path());
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

void heading(const char* text) {
    ImGui::Dummy({0.0F, 0.5F * ImGui::GetFontSize()});
    ImGui::PushFont(font(FontRole::bold));
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
}

}  // namespace

void Welcome::draw(Session& session) {
    if (!looked_) {
        shipped_ = shipped_scenes();
        looked_ = true;
    }
    const float em = ImGui::GetFontSize();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float width = std::min(38.0F * em, room.x - 2.0F * em);
    ImGui::SetCursorPos({0.5F * (room.x - width), std::max(em, 0.12F * room.y)});
    ImGui::BeginChild("welcome", {width, -em});
    ImGui::PushTextWrapPos(0.0F);
    ImGui::PushFont(font(FontRole::large));
    ImGui::TextUnformatted("polariscope");
    ImGui::PopFont();
    ImGui::TextUnformatted("Nothing is open. Drop a scene (*.yaml) or a picture (*.exr) here, or");
    if (ImGui::Button("Open a file...  Ctrl+O")) session.window.path_entry_visible = true;
    name_widget("button open");
    ImGui::SameLine();
    if (ImGui::Button("Keys and mouse  F1")) session.window.help_visible = true;

    // An error would be overlooked in the status line of an empty window.
    const auto& lines = session.log.lines();
    if (!lines.empty() && lines.back().severity == Severity::error)
        ImGui::TextColored(colors(session.window.theme).error, "%s", lines.back().text.c_str());

    if (!session.recent_files.empty()) {
        heading("Opened before");
        draw_recent_files(session);
    }
    heading("Scenes that come with it");
    for (const fs::path& scene : shipped_) {
        if (ImGui::Selectable(scene.stem().c_str())) session.open(scene);
        name_widget("scene " + scene.stem().string());
    }
    if (shipped_.empty())
        ImGui::TextDisabled("None found in %s; set POLARISCOPE_ASSETS to the folder assets/ of the source.",
                            (assets_dir() / "scenes").c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndChild();
}

}  // namespace pol
