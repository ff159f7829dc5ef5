// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/rewrite_dialog.h"

#include <imgui.h>

#include <string>

#include "viewer/commands/unsaved_edits.h"
#include "viewer/widgets/question.h"

namespace pol {

void draw_rewrite_dialog(const Session& session, Wishes& wishes) {
    constexpr const char* name = "Write the file anew?";
    const bool asked = session.window().question == Question::rewrite && session.current() != nullptr;
    if (!begin_question(name, asked)) return;
    const std::string& file = session.current()->name();
    ImGui::Text("%s cannot take this edit as it is: written anew, it has other words and no comments.", file.c_str());
    ImGui::Text("The file that is there now is kept as %s.bak.", file.c_str());
    ImGui::Spacing();
    if (button("Write anew")) wishes.add(write_anew);
    ImGui::SameLine();
    if (ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) wishes.add(stay);
    ImGui::EndPopup();
}

}  // namespace pol
