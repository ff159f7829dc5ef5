// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/welcome.h"

#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "io/files/assets.h"
#include "viewer/panels/recent_files.h"
#include "viewer/widgets/fonts.h"
#include "viewer/widgets/theme.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

void heading(const char* text) {
    ImGui::Dummy({0.0F, 0.5F * ImGui::GetFontSize()});
    ImGui::PushFont(font(FontRole::bold));
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
}

}  // namespace

void draw_welcome(const Session& session, Wishes& wishes) {
    const float em = ImGui::GetFontSize();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float width = std::min(38.0F * em, room.x - 2.0F * em);
    ImGui::SetCursorPos({0.5F * (room.x - width), std::max(em, 0.12F * room.y)});
    ImGui::BeginChild("welcome", {width, -em});
    ImGui::PushTextWrapPos(0.0F);
    ImGui::PushFont(font(FontRole::large));
    ImGui::TextUnformatted("polariscope");
    ImGui::PopFont();
    ImGui::TextUnformatted("Nothing is open. Drop a scene (*.yaml) or a picture (*.exr, *.npy, *.png) here, or");
    if (ImGui::Button("Open a file...  Ctrl+O")) wishes.set(&WindowState::path_entry_visible, true);
    name_widget("button open");
    ImGui::SameLine();
    if (ImGui::Button("Keys and mouse  F1")) wishes.set(&WindowState::help_visible, true);

    // An error would be overlooked in the status line of an empty window.
    const auto& lines = session.log().lines();
    if (!lines.empty() && lines.back().severity == Severity::error)
        ImGui::TextColored(colors(session.window().theme).error, "%s", lines.back().text.c_str());

    if (!session.recent_files().empty()) {
        heading("Opened before");
        draw_recent_files(session, wishes);
    }
    heading("Scenes that come with it");
    const std::vector<std::filesystem::path>& shipped = session.shipped_files().scenes;
    for (const std::filesystem::path& scene : shipped) {
        if (ImGui::Selectable(scene.stem().c_str())) wishes.add([scene](Session& s) { s.open(scene); });
        name_widget("scene " + scene.stem().string());
    }
    if (shipped.empty())
        ImGui::TextDisabled("None found in %s; set POLARISCOPE_ASSETS to the folder assets/ of the source.",
                            (assets_dir() / "scenes").c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndChild();
}

}  // namespace pol
