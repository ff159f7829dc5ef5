// SPDX-License-Identifier: Apache-2.0
#include "viewer/widgets/dial.h"

#include <imgui.h>

#include <cmath>

#include "core/units.h"
#include "viewer/widgets/ink.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

bool axis_dial(const char* name, double& axis_rad, float diameter) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(name, {diameter, diameter});
    name_widget(name);
    const double radius = 0.5 * static_cast<double>(diameter);
    const DVec2 center(at.x + radius, at.y + radius);
    const double before = axis_rad;
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        axis_rad = 0.0;
    } else if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1.0F)) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        double angle = std::atan2(center.y - mouse.y, mouse.x - center.x);
        const double step = radians(15.0);
        if (ImGui::GetIO().KeyShift) angle = step * std::round(angle / step);
        axis_rad = angle - pi * std::floor(angle / pi);
        if (axis_rad >= pi) axis_rad = 0.0;
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool is_hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
    list.AddCircleFilled(point(center), static_cast<float>(radius),
                         ImGui::GetColorU32(is_hot ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg), 32);
    for (int tick = 0; tick < 24; ++tick) {
        const DVec2 out(std::cos(tick * pi / 12.0), std::sin(tick * pi / 12.0));
        const double inner = tick % 6 == 0 ? 0.78 : 0.9;
        list.AddLine(point(center + inner * radius * out), point(center + radius * out),
                     ImGui::GetColorU32(ImGuiCol_TextDisabled));
    }
    const DVec2 along = 0.85 * radius * DVec2(std::cos(axis_rad), -std::sin(axis_rad));
    list.AddLine(point(center - along), point(center + along), pin_ink, 2.5F);
    tooltip(
        "Drag to turn; Shift: steps of 15\u00b0; double click: 0\u00b0. Angles are counted from the right, "
        "counter-clockwise as the camera sees it.");
    return axis_rad != before;
}

}  // namespace pol
