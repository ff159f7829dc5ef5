// SPDX-License-Identifier: Apache-2.0
// What a test sees of a frame: its texts, and where the widgets lie, by name. Costs nothing when nobody asks.
#pragma once

#include <imgui.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "viewer/widgets/frame.h"

namespace pol {

/// Reached through ImGui's own user pointer (ImGuiIO::UserData), set by whoever wants to know.
struct WidgetMap {
    std::map<std::string, ViewRect, std::less<>> rects;  ///< window coordinates
    std::filesystem::path text_log;                      ///< gets the texts of all parts of the window
};

[[nodiscard]] inline WidgetMap* wanted_widget_map() {
    return static_cast<WidgetMap*>(ImGui::GetIO().UserData);
}

/// Gives the item that was just drawn a name that tests know, such as "tab Pixel".
inline void name_widget(std::string_view name) {
    WidgetMap* map = wanted_widget_map();
    if (map == nullptr || !ImGui::IsItemVisible()) return;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 size = ImGui::GetItemRectSize();
    map->rects.insert_or_assign(std::string(name), ViewRect{{low.x, low.y}, {size.x, size.y}});
}

/// After ImGui::Begin(): ImGui's text log ends with every window.
inline void log_window() {
    constexpr int as_it_is = 0;  // opens no closed tree
    if (const WidgetMap* map = wanted_widget_map()) ImGui::LogToFile(as_it_is, map->text_log.c_str());
}

}  // namespace pol
