// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/open_dialog.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>
#include <utility>

#include "io/pictures/picture_file.h"
#include "viewer/widgets/path_entry.h"
#include "viewer/widgets/theme.h"

namespace pol {

namespace fs = std::filesystem;

namespace {

bool can_be_opened(const fs::path& file) {
    constexpr std::array<std::string_view, 3> endings{".yaml", ".yml", ".json"};
    return is_picture_name(file) ||
           std::find(endings.begin(), endings.end(), file.extension().string()) != endings.end();
}

}  // namespace

void OpenDialog::look() {
    looked_for_ = typed_;
    refused_.clear();
    matches_.clear();
    const fs::path wanted = typed_path(typed_);
    const std::string beginning = wanted.filename().string();
    const fs::path folder = wanted.has_parent_path() ? wanted.parent_path() : fs::path(".");
    std::error_code failed;
    for (auto entry = fs::directory_iterator(folder, failed); !failed && entry != fs::directory_iterator();
         entry.increment(failed)) {
        const std::string name = entry->path().filename().string();
        std::error_code unknown;
        const bool is_folder = entry->is_directory(unknown);
        const bool hidden = name.starts_with('.') && !beginning.starts_with('.');
        if (hidden || !name.starts_with(beginning) || !(is_folder || can_be_opened(entry->path()))) continue;
        matches_.push_back(is_folder ? entry->path() / "" : entry->path());
    }
    std::sort(matches_.begin(), matches_.end(), [](const fs::path& a, const fs::path& b) {
        return a.has_filename() != b.has_filename() ? b.has_filename() : a < b;
    });
}

void OpenDialog::draw(const Session& session, Wishes& wishes) {
    bool visible = session.window().path_entry_visible;
    const bool was_tried = std::exchange(wished_, false);
    if (was_tried && !visible) typed_ = (typed_path(typed_).parent_path() / "").string();
    constexpr const char* name = "Open a scene or a picture";
    if (visible && !ImGui::IsPopupOpen(name)) {
        if (typed_.empty()) {
            std::error_code failed;
            typed_ = (fs::current_path(failed) / "").string();
        }
        look();
        ImGui::OpenPopup(name);
    }
    bool wanted = false;
    if (!begin_path_page(name, visible, typed_, "scene.yaml, picture.exr, .npy, .png", "Open", was_tried, wanted)) {
        if (visible != session.window().path_entry_visible) wishes.set(&WindowState::path_entry_visible, visible);
        return;
    }
    if (typed_ != looked_for_) look();
    if (was_tried) refused_ = session.log().lines().back().text;

    ImGui::BeginChild("files", {0.0F, 18.0F * ImGui::GetFontSize()});
    for (const fs::path& match : matches_) {
        const bool is_folder = !match.has_filename();
        const std::string label = is_folder ? match.parent_path().filename().string() + "/" : match.filename().string();
        if (ImGui::Selectable(label.c_str(), false, ImGuiSelectableFlags_DontClosePopups)) {
            typed_ = match.string();
            wanted = !is_folder;
        }
    }
    if (matches_.empty())
        ImGui::TextDisabled("No scene (*.yaml, *.json) or picture (*.exr, *.npy, *.png) begins like this.");
    ImGui::EndChild();

    if (wanted) {
        refused_.clear();
        wished_ = true;
        wishes.add([path = typed_path(typed_)](Session& s) {
            if (s.open(path)) s.change_window().path_entry_visible = false;
        });
    }
    end_path_page(visible, refused_, colors(session.window().theme).error);
    if (!visible) wishes.set(&WindowState::path_entry_visible, false);
}

}  // namespace pol
