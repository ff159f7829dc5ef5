// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/picture_panel.h"

#include <imgui.h>

#include <cmath>

namespace pol {

void PicturePanel::draw(Session& session, Frame& frame) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const ImVec2 size = ImGui::GetContentRegionAvail();
    frame.viewport = {{origin.x, origin.y}, {size.x, size.y}};
    if (frame.picture_texture != 0)
        ImGui::Image(reinterpret_cast<ImTextureID>(frame.picture_texture), size, {0.0F, 1.0F}, {1.0F, 0.0F});
    else
        ImGui::Dummy(size);
    const Document* document = session.current();
    if (document == nullptr) return;
    const StokesImage& picture = document->picture();
    const DVec2 extent(picture.width, picture.height);
    if (fitted_layout_ != document->picture_layout()) {
        session.transform.fit(extent, frame.viewport.size);
        fitted_layout_ = document->picture_layout();
    }
    session.selection.hovered.reset();
    if (!ImGui::IsItemHovered()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const DVec2 at(mouse.x - origin.x, mouse.y - origin.y);
    if (const float wheel = ImGui::GetIO().MouseWheel; wheel != 0.0F)
        session.transform.zoom_at(at, std::pow(1.2, wheel));
    const DVec2 p = session.transform.picture_from_view(at);
    if (p.x < 0.0 || p.y < 0.0 || p.x >= extent.x || p.y >= extent.y) return;
    session.selection.hovered = PixelAddress{static_cast<int>(p.x), static_cast<int>(p.y)};
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) session.pin(*session.selection.hovered);
}

}  // namespace pol
