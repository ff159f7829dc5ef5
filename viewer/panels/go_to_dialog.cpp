// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/go_to_dialog.h"

#include <imgui.h>

#include <utility>

#include "viewer/widgets/path_entry.h"
#include "viewer/widgets/theme.h"

namespace pol {

void GoToDialog::draw(const Session& session, Wishes& wishes) {
    bool visible = session.window().go_to_visible;
    const bool was_tried = std::exchange(wished_, false);
    constexpr const char* name = "Go to a pixel";
    if (visible && !ImGui::IsPopupOpen(name)) {
        typed_.clear();
        complaint_.clear();
        ImGui::OpenPopup(name);
    }
    bool wanted = false;
    if (!begin_path_page(name, visible, typed_, "column,row of the whole picture, such as 12,7", "Go", was_tried,
                         wanted)) {
        if (visible != session.window().go_to_visible) wishes.set(&WindowState::go_to_visible, visible);
        return;
    }
    if (was_tried) complaint_ = session.log().lines().back().text;
    if (wanted) {
        wished_ = true;
        wishes.add([typed = typed_](Session& s) {
            if (const auto done = s.go_to(typed))
                s.change_window().go_to_visible = false;
            else
                s.say(Severity::warning, to_string(done.error()));
        });
    }
    end_path_page(visible, complaint_, colors(session.window().theme).warning);
    if (!visible) wishes.set(&WindowState::go_to_visible, false);
}

}  // namespace pol
