// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/problem_banner.h"

#include <imgui.h>

#include "viewer/widgets/theme.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

void draw_problem_banner(const Session& session, const Frame& frame) {
    const Document* document = session.current();
    if (document == nullptr || !document->problem()) return;
    const ViewRect& view = frame.viewport;
    const ThemeColors& color = colors(session.window().theme);
    ImGui::SetNextWindowPos({static_cast<float>(view.origin.x), static_cast<float>(view.origin.y)});
    ImGui::SetNextWindowSize({static_cast<float>(view.size.x), 0.0F});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, color.popup);
    constexpr ImGuiWindowFlags plain = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                       ImGuiWindowFlags_NoInputs;
    if (ImGui::Begin("Problem", nullptr, plain)) {
        log_window();
        ImGui::PushStyleColor(ImGuiCol_Text, color.error);
        ImGui::TextWrapped("%s", to_string(*document->problem()).c_str());
        ImGui::PopStyleColor();
        ImGui::TextDisabled("The picture is still that of the last good version. Save the file again to go on.");
    }
    ImGui::End();
    ImGui::PopStyleColor();
}

}  // namespace pol
