// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/save_as_dialog.h"

#include <imgui.h>

#include <system_error>
#include <utility>

#include "viewer/widgets/path_entry.h"
#include "viewer/widgets/theme.h"

namespace pol {

namespace fs = std::filesystem;

void SaveAsDialog::save(const Session& session, Wishes& wishes) {
    const fs::path path = typed_path(typed_);
    const std::string ending = path.extension().string();
    std::error_code unknown;
    if (ending != ".yaml" && ending != ".yml") {
        complaint_ = "A scene is a *.yaml file.";
    } else if (fs::exists(path, unknown) && !fs::equivalent(path, session.current()->path(), unknown) &&
               path != to_replace_) {
        complaint_ = "This file exists. Save again to replace it.";
        to_replace_ = path;
    } else {
        wished_ = true;
        wishes.add([path](Session& s) {
            if (s.save(path) || s.window().question == Question::rewrite) s.change_window().save_as_visible = false;
        });
    }
}

void SaveAsDialog::draw(const Session& session, Wishes& wishes) {
    const Document* document = session.current();
    bool visible = session.window().save_as_visible && document != nullptr && document->has_scene();
    constexpr const char* name = "Save the scene as";
    const bool was_wanted = std::exchange(wanted_, false);
    const bool was_refused = std::exchange(wished_, false) && visible;
    if (visible && !ImGui::IsPopupOpen(name)) {
        std::error_code failed;
        const fs::path own = document->path().empty() ? fs::current_path(failed) / document->name() : document->path();
        typed_ = own.string();
        complaint_.clear();
        to_replace_.clear();
        ImGui::OpenPopup(name);
    } else if (was_refused) {
        complaint_ = session.log().lines().back().text;
    }
    // Enter takes the keyboard from the entry; a refused name is to be corrected.
    if (begin_path_page(name, visible, typed_, "scene.yaml", "Save", was_wanted, wanted_)) {
        if (wanted_) save(session, wishes);
        end_path_page(visible, complaint_, colors(session.window().theme).warning);
    }
    if (visible != session.window().save_as_visible) wishes.set(&WindowState::save_as_visible, visible);
}

}  // namespace pol
