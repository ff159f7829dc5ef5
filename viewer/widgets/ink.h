// SPDX-License-Identifier: Apache-2.0
// Drawing over pictures of any color: every stroke and letter carries its own dark rim.
#pragma once

#include <imgui.h>

#include <string>

#include "core/vec.h"
#include "maps/color_scale.h"

namespace pol {

inline constexpr ImU32 rim_color = IM_COL32(0, 0, 0, 190);
inline constexpr ImU32 white_ink = IM_COL32(255, 255, 255, 255);
inline constexpr ImU32 pin_ink = IM_COL32(255, 214, 10, 255);

inline ImVec2 point(const DVec2& p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y)};
}

inline ImU32 ink(const Rgb8& color, int alpha = 255) {
    return IM_COL32(color[0], color[1], color[2], alpha);
}

inline void rimmed_line(ImDrawList& list, ImVec2 a, ImVec2 b, ImU32 color, float thickness = 1.5F) {
    list.AddLine(a, b, rim_color, thickness + 2.0F);
    list.AddLine(a, b, color, thickness);
}

inline void rimmed_text(ImDrawList& list, ImVec2 at, ImU32 color, const std::string& text) {
    const char* begin = text.data();
    const char* end = begin + text.size();
    for (const ImVec2 by : {ImVec2(-1, 0), ImVec2(1, 0), ImVec2(0, -1), ImVec2(0, 1)})
        list.AddText({at.x + by.x, at.y + by.y}, rim_color, begin, end);
    list.AddText(at, color, begin, end);
}

/// Arrow from `a` to `b` with a head of `head` points.
inline void rimmed_arrow(ImDrawList& list, ImVec2 a, ImVec2 b, ImU32 color, float head = 6.0F) {
    rimmed_line(list, a, b, color);
    const DVec2 along = glm::normalize(DVec2(b.x - a.x, b.y - a.y));
    const DVec2 tip(b.x, b.y);
    const DVec2 back = tip - static_cast<double>(head) * along;
    const DVec2 side = 0.5 * static_cast<double>(head) * DVec2(-along.y, along.x);
    list.AddTriangleFilled(point(tip + along), point(back + side), point(back - side), color);
}

/// Text that says what the item under the mouse is. Call right after the item.
inline void tooltip(const char* text) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 28.0F);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

}  // namespace pol
