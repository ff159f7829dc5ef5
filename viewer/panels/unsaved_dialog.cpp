// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/unsaved_dialog.h"

#include <imgui.h>

#include "viewer/commands/unsaved_edits.h"
#include "viewer/widgets/question.h"

namespace pol {

void draw_unsaved_dialog(const Session& session, Wishes& wishes) {
    const bool closing = session.window().question == Question::unsaved_at_close;
    if (!begin_question("Unsaved edits", closing || session.window().question == Question::unsaved_at_end)) return;
    ImGui::TextUnformatted("These scenes were edited and not saved:");
    for (const Document* document : session.documents())
        if (would_be_lost(session, *document)) ImGui::BulletText("%s", document->name().c_str());
    ImGui::Spacing();
    if (button(closing ? "Save and close" : "Save and quit")) wishes.add(save_and_go_on);
    ImGui::SameLine();
    if (button(closing ? "Close without saving" : "Quit without saving")) wishes.add(go_on_without_saving);
    ImGui::SameLine();
    if (button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) wishes.add(stay);
    ImGui::EndPopup();
}

}  // namespace pol
