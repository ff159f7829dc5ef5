// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/status_line.h"

#include <imgui.h>

namespace pol {

void draw_status_line(Session& session) {
    const Document* document = session.current();
    if (document == nullptr) {
        ImGui::TextUnformatted("Nothing is open: drop a scene or an EXR file here");
    } else {
        const RenderProgress progress = document->progress();
        ImGui::Text("%s  %.0f %%", document->path().filename().c_str(), 100.0 * progress.done);
    }
    if (session.log.lines().empty()) return;
    ImGui::SameLine();
    ImGui::TextUnformatted(session.log.lines().back().text.c_str());
}

}  // namespace pol
