// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/layout_dialog.h"

#include <imgui.h>

#include <algorithm>
#include <string>

#include "viewer/commands/unsaved_edits.h"
#include "viewer/widgets/question.h"

namespace pol {

void draw_layout_dialog(const Session& session, Wishes& wishes) {
    const bool asked = session.window().question == Question::layout && session.layout_question().has_value();
    if (!begin_question("Which layout is it?", asked)) return;
    const Session::LayoutQuestion& question = *session.layout_question();
    ImGui::Text("%s can be read in several ways:", question.source.path().filename().c_str());
    ImGui::Spacing();
    const auto& all = picture_layouts();
    for (const std::string_view name : question.layouts) {
        if (button(std::string(name).c_str())) wishes.add([name](Session& s) { s.answer_layout(name); });
        ImGui::SameLine();
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const PictureLayout& layout) { return layout.name == name; });
        if (found != all.end()) ImGui::TextUnformatted(found->about.data(), found->about.data() + found->about.size());
    }
    ImGui::Spacing();
    if (button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) wishes.add(stay);
    ImGui::EndPopup();
}

}  // namespace pol
