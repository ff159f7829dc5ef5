// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/send_dialog.h"

#include <imgui.h>

#include <utility>

#include "viewer/session/exports.h"
#include "viewer/widgets/path_entry.h"
#include "viewer/widgets/theme.h"

namespace pol {

void SendDialog::draw(const Session& session, Wishes& wishes) {
    bool visible = session.window().send_visible && session.current() != nullptr;
    constexpr const char* name = "Send the picture to a viewer";
    const bool was_wanted = std::exchange(wanted_, false);
    if (visible && !ImGui::IsPopupOpen(name)) {
        if (typed_.empty()) typed_ = LiveAddress{}.text();
        complaint_.clear();
        ImGui::OpenPopup(name);
    }
    if (begin_path_page(name, visible, typed_, "127.0.0.1:14158", "Send", was_wanted, wanted_)) {
        if (wanted_) {
            if (const auto address = read_live_address(typed_)) {
                wishes.add([to = address.value()](Session& s) { send_picture(s, to); });
                visible = false;
            } else {
                complaint_ = to_string(address.error());
            }
        }
        end_path_page(visible, complaint_, colors(session.window().theme).warning);
    }
    if (visible != session.window().send_visible) wishes.set(&WindowState::send_visible, visible);
}

}  // namespace pol
