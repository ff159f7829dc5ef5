// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/pixel_panel.h"

#include <imgui.h>

namespace pol {

void PixelPanel::draw(Session& session) {
    const auto pinned = session.selection.pinned();
    if (!pinned || session.current() == nullptr) {
        ImGui::TextDisabled("Click a pixel");
        return;
    }
    const StokesImage& picture = session.current()->picture();
    const Stokes<double> s = session.shown_stokes(session.view.wavelength, picture.pixel(pinned->x, pinned->y));
    ImGui::Text("pixel %d,%d", pinned->x, pinned->y);
    ImGui::Text("S0 %.9g\nS1 %.9g\nS2 %.9g\nS3 %.9g", s.s0, s.s1, s.s2, s.s3);
}

}  // namespace pol
