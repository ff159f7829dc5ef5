// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/tree_state.h"

#include <imgui.h>

#include <algorithm>

namespace pol {

bool draw_tree_state(Session& session) {
    const Document* document = session.current();
    if (document == nullptr || !session.selection.pinned()) {
        ImGui::TextWrapped("Click a pixel of the picture: the paths that made it appear here.");
        return false;
    }
    if (!document->has_scene()) {
        ImGui::TextWrapped("%s has pixels but no scene to trace: open the scene it was made of to see paths.",
                           document->path().filename().c_str());
        return false;
    }
    const ExplanationStatus status = session.explanation_status();
    switch (status.state) {
        case ExplanationState::ready:
            return session.explanation() != nullptr;
        case ExplanationState::nothing_asked:
            return false;
        case ExplanationState::running:
            // A tree that takes no longer than a frame or two would make the panel flicker.
            if (status.branches == 0) return false;
            ImGui::Text("%zu branches found", status.branches);
            ImGui::TextDisabled("node budget: %zu to follow", status.budget);
            if (ImGui::Button("Cancel")) session.cancel_explanation();
            return false;
        case ExplanationState::cancelled:
            ImGui::TextUnformatted("Cancelled.");
            break;
        case ExplanationState::failed:
            ImGui::TextWrapped("%s.", status.problem.c_str());
            break;
    }
    if (ImGui::Button("Try again")) session.restart_explanation();
    return false;
}

void draw_sample_choice(Session& session) {
    const int samples = session.current()->plan()->settings.samples_per_pixel;
    if (samples < 2) return;
    int sample = static_cast<int>(std::min(session.selection.sample, static_cast<std::uint32_t>(samples - 1)));
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 8.0F);
    if (ImGui::InputInt("Sample", &sample))
        session.selection.sample = static_cast<std::uint32_t>(std::clamp(sample, 0, samples - 1));
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Which of the %d rays through the pixel; 0 goes through its centre", samples);
}

}  // namespace pol
