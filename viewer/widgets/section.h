// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <imgui.h>

#include <string>

#include "viewer/widgets/widget_map.h"

namespace pol {

/// A part of a panel that can be folded; open at first.
template <class Draw>
void section(const char* name, const Draw& draw) {
    const bool open = ImGui::CollapsingHeader(name, ImGuiTreeNodeFlags_DefaultOpen);
    name_widget(std::string("section ") + name);
    if (!open) return;
    ImGui::PushID(name);
    draw();
    ImGui::PopID();
    ImGui::Spacing();
}

}  // namespace pol
