// SPDX-License-Identifier: Apache-2.0
#include "viewer/interface.h"

#include <imgui.h>

#include "viewer/commands.h"
#include "viewer/panels/menu_bar.h"
#include "viewer/panels/status_line.h"

namespace pol {

namespace {

constexpr float left_width = 250.0F;
constexpr float right_width = 400.0F;

/// A fixed part of the window: cannot be moved, resized or closed.
template <class Draw>
void part(const char* name, ImVec2 position, ImVec2 size, const Draw& draw) {
    ImGui::SetNextWindowPos(position);
    ImGui::SetNextWindowSize(size);
    constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;
    if (ImGui::Begin(name, nullptr, fixed)) draw();
    ImGui::End();
}

}  // namespace

void Interface::draw(Session& session, Frame& frame) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const auto scale = static_cast<float>(frame.ui_scale);
    const float menu = session.panels_visible ? draw_menu_bar(session) : 0.0F;
    const float status = session.panels_visible ? ImGui::GetFrameHeightWithSpacing() : 0.0F;
    const float left = session.panels_visible ? left_width * scale : 0.0F;
    const float right = session.panels_visible ? right_width * scale : 0.0F;
    const float height = window.y - menu - status;
    if (session.panels_visible) {
        part("Maps", {0.0F, menu}, {left, height}, [&] { maps_.draw(session); });
        part("Inspector", {window.x - right, menu}, {right, height}, [&] {
            if (!ImGui::BeginTabBar("inspector")) return;
            if (ImGui::BeginTabItem("Pixel")) {
                pixel_.draw(session);
                ImGui::EndTabItem();
            }
            ImGui::EndTabBar();
        });
        part("Status", {0.0F, window.y - status}, {window.x, status}, [&] { draw_status_line(session); });
    }
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    part("Picture", {left, menu}, {window.x - left - right, height}, [&] { picture_.draw(session, frame); });
    ImGui::PopStyleVar();
}

}  // namespace pol
