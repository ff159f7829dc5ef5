// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/maps_panel.h"

#include <imgui.h>

#include <string>

namespace pol {

void MapsPanel::draw(Session& session) {
    for (const QuantityInfo& quantity : quantities()) {
        if (ImGui::Selectable(std::string(quantity.title).c_str(), session.view.quantity == quantity.quantity))
            session.show(quantity.quantity);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(quantity.definition).c_str());
    }
}

}  // namespace pol
