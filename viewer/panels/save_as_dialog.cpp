// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/save_as_dialog.h"

#include <imgui.h>

#include <system_error>

#include "viewer/widgets/path_entry.h"
#include "viewer/widgets/theme.h"

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
    } else if (session.save(path) || session.window.rewrite_asked) {
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
    // Enter takes the keyboard from the entry; a refused name is to be corrected.
    bool wanted = false;
    if (!begin_path_page(name, visible, typed_, "scene.yaml", "Save", was_refused_, wanted)) return;
    if (wanted) save(session);
    was_refused_ = wanted && visible;
    end_path_page(visible, complaint_, colors(session.window.theme).warning);
}

}  // namespace pol
