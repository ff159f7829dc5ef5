// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/unsaved_dialog.h"

#include <imgui.h>

#include "viewer/commands/command_actions.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

/// Does what was asked for. The answer is no longer needed.
void proceed(Session& session) {
    WindowState& window = session.window;
    if (window.quit == Quit::asked) window.quit = Quit::confirmed;
    if (window.close_asked) session.close_document();
    window.close_asked = false;
}

void give_up(WindowState& window) {
    window.quit = Quit::no;
    window.close_asked = false;
}

/// Saves what is about to be lost; false if that failed, and the log says why, or if it needs an answer first.
bool save_all(Session& session) {
    if (session.window.close_asked) return action::save_scene(session);
    for (std::size_t i = 0; i < session.documents().size(); ++i) {
        if (session.current()->dirty() && !action::save_scene(session)) return false;
        session.step_document(1);
    }
    return true;
}

bool button(const char* label) {
    const bool pressed = ImGui::Button(label);
    name_widget(std::string("button ") + label);
    return pressed;
}

}  // namespace

void draw_unsaved_dialog(Session& session) {
    WindowState& window = session.window;
    const bool closing = window.close_asked;
    if (!closing && window.quit != Quit::asked) return;
    const bool lost =
        closing ? session.current() != nullptr && session.current()->dirty() : session.has_unsaved_edits();
    if (!lost) return proceed(session);

    constexpr const char* name = "Unsaved edits";
    if (!ImGui::IsPopupOpen(name)) ImGui::OpenPopup(name);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * display.x, 0.4F * display.y}, ImGuiCond_Always, {0.5F, 0.5F});
    if (!ImGui::BeginPopupModal(name, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove)) return;
    log_window();
    ImGui::TextUnformatted("These scenes were edited and not saved:");
    for (const auto& document : session.documents())
        if (document->dirty() && (!closing || document.get() == session.current()))
            ImGui::BulletText("%s", document->name().c_str());
    ImGui::Spacing();
    if (button(closing ? "Save and close" : "Save and quit")) {
        if (save_all(session))
            proceed(session);
        else if (window.rewrite_asked)
            give_up(window);
    }
    ImGui::SameLine();
    if (button(closing ? "Close without saving" : "Quit without saving")) proceed(session);
    ImGui::SameLine();
    if (button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) give_up(window);
    if (!window.close_asked && window.quit != Quit::asked) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace pol
