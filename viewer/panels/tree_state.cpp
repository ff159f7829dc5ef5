// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/tree_state.h"

#include <imgui.h>

#include <algorithm>

namespace pol {

bool draw_tree_state(const Session& session, Wishes& wishes) {
    const Document* document = session.current();
    if (document == nullptr || !session.selection().pinned()) {
        ImGui::TextWrapped("Click a pixel of the picture: the paths that made it appear here.");
        return false;
    }
    if (!document->has_scene()) {
        ImGui::TextWrapped("%s has pixels but no scene to trace: open the scene it was made of to see paths.",
                           document->name().c_str());
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
            if (ImGui::Button("Cancel")) wishes.add(&Session::cancel_explanation);
            return false;
        case ExplanationState::cancelled:
            ImGui::TextUnformatted("Cancelled.");
            break;
        case ExplanationState::failed:
            ImGui::TextWrapped("%s.", status.problem.c_str());
            break;
    }
    if (ImGui::Button("Try again")) wishes.add(&Session::restart_explanation);
    return false;
}

void draw_sample_choice(const Session& session, Wishes& wishes) {
    const RenderSettings& settings = session.current()->plan()->settings;
    const int last = settings.last_sample();
    if (last == 0) return;
    int sample = std::min(static_cast<int>(session.selection().sample), last);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 8.0F);
    if (ImGui::InputInt("Sample", &sample))
        wishes.add([chosen = static_cast<std::uint32_t>(std::clamp(sample, 0, last))](Session& s) {
            s.select_sample(chosen);
        });
    if (!ImGui::IsItemHovered()) return;
    if (settings.first_sample() == 0)
        ImGui::SetTooltip("Which of the %d samples of the ray through the pixel's centre", last + 1);
    else
        ImGui::SetTooltip(
            "0: the ray through the pixel's centre, which is no part of the picture; 1 to %d: the rays "
            "that make it",
            last);
}

}  // namespace pol
