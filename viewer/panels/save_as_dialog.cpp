// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/save_as_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <system_error>

#include "viewer/widgets/path_entry.h"
#include "viewer/widgets/theme.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace fs = std::filesystem;

void SaveAsDialog::save(Session& session) {
    const fs::path path = typed_path(typed_);
    const std::string ending = path.extension().string();
    std::error_code unknown;
    if (ending != ".yaml" && ending != ".yml") {
        complaint_ = "A scene is a *.yaml file.";
    } else if (fs::exists(path, unknown) && !fs::equivalent(path, session.current()->path(), unknown) &&
               path != to_replace_) {
        complaint_ = "This file exists. Save again to replace it.";
        to_replace_ = path;
    } else if (session.save(path)) {
        session.window.save_as_visible = false;
    } else {
        complaint_ = session.log.lines().back().text;
    }
}

void SaveAsDialog::draw(Session& session) {
    bool& visible = session.window.save_as_visible;
    constexpr const char* name = "Save the scene as";
    const Document* document = session.current();
    if (document == nullptr || !document->has_scene()) visible = false;
    if (visible && !ImGui::IsPopupOpen(name)) {
        std::error_code failed;
        const fs::path own = document->path().empty() ? fs::current_path(failed) / document->name() : document->path();
        typed_ = own.string();
        complaint_.clear();
        to_replace_.clear();
        ImGui::OpenPopup(name);
    }
    const float em = ImGui::GetFontSize();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * display.x, 0.15F * display.y}, ImGuiCond_Always, {0.5F, 0.0F});
    ImGui::SetNextWindowSize({44.0F * em, 0.0F});
    if (!ImGui::BeginPopupModal(name, &visible, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize)) return;
    log_window();
    // Enter takes the keyboard from the entry; a refused name is to be corrected.
    if (ImGui::IsWindowAppearing() || was_refused_) ImGui::SetKeyboardFocusHere();
    was_refused_ = false;
    ImGui::SetNextItemWidth(-6.0F * em);
    bool wanted = ImGui::InputTextWithHint("##path", "scene.yaml", &typed_, ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::SameLine();
    wanted |= ImGui::Button("Save", {-1.0F, 0.0F});
    name_widget("button save as");
    if (wanted) {
        save(session);
        was_refused_ = visible;
    }
    if (!complaint_.empty()) {
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextColored(colors(session.window.theme).warning, "%s", complaint_.c_str());
        ImGui::PopTextWrapPos();
    }
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) visible = false;
    if (!visible) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace pol
