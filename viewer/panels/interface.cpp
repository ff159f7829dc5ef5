// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/interface.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "viewer/commands/commands.h"
#include "viewer/panels/fact_panel.h"
#include "viewer/panels/help_overlay.h"
#include "viewer/panels/layout_dialog.h"
#include "viewer/panels/menu_bar.h"
#include "viewer/panels/polarimeter_panel.h"
#include "viewer/panels/problem_banner.h"
#include "viewer/panels/reading_panel.h"
#include "viewer/panels/rewrite_dialog.h"
#include "viewer/panels/status_line.h"
#include "viewer/panels/unsaved_dialog.h"
#include "viewer/panels/view_controls.h"
#include "viewer/panels/welcome.h"
#include "viewer/widgets/section.h"
#include "viewer/widgets/theme.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

constexpr float splitter_width = 5.0F;
/// Points at scale 1 that the picture keeps, however wide the sides are dragged.
constexpr double least_picture_width = 240.0;
constexpr double least_side_width = 160.0;
/// From this height on (points at scale 1) the right side has two stacks of tabs.
constexpr float two_stacks_height = 1000.0F;

/// A fixed part of the window: cannot be moved, resized or closed.
template <class Draw>
void part(const char* name, ImVec2 position, ImVec2 size, const Draw& draw) {
    ImGui::SetNextWindowPos(position);
    ImGui::SetNextWindowSize(size);
    constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                       ImGuiWindowFlags_NoNavFocus;  // Ctrl+Tab is ours
    if (ImGui::Begin(name, nullptr, fixed)) {
        log_window();
        draw();
    }
    ImGui::End();
}

/// Same, without room at its border.
template <class Draw>
void bare_part(const char* name, ImVec2 position, ImVec2 size, const Draw& draw) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
    part(name, position, size, draw);
    ImGui::PopStyleVar(3);
}

/// A bar to drag; returns by how many points it was moved along `cursor`'s direction.
float splitter(const char* name, ImVec2 position, ImVec2 size, ImGuiMouseCursor cursor) {
    float moved = 0.0F;
    bare_part(name, position, size, [&] {
        ImGui::InvisibleButton("bar", size);
        name_widget(name);
        if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(cursor);
        const ImVec2 delta = ImGui::GetIO().MouseDelta;
        if (ImGui::IsItemActive()) moved = cursor == ImGuiMouseCursor_ResizeEW ? delta.x : delta.y;
    });
    return moved;
}

/// A tab whose contents scroll for themselves.
template <class Draw>
void tab(bool here, const char* name, const Draw& draw, ImGuiTabItemFlags flags = ImGuiTabItemFlags_None) {
    if (!here) return;
    const bool open = ImGui::BeginTabItem(name, nullptr, flags);
    name_widget("tab " + std::string(name).substr(0, std::string(name).find("###")));
    if (!open) return;
    ImGui::BeginChild(name);
    draw();
    ImGui::EndChild();
    ImGui::EndTabItem();
}

bool any_popup_open() {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

struct Widths {
    float left = 0.0F;
    float right = 0.0F;
};

/// Keeps the user's widths as they are and gives what fits into the window.
Widths fitting(const Layout& layout, float window, double scale) {
    const double room = window / scale - least_picture_width;
    const double left = std::clamp(layout.left_width, least_side_width, std::max(least_side_width, 0.4 * room));
    const double right = std::clamp(layout.right_width, least_side_width, std::max(least_side_width, room - left));
    return {static_cast<float>(left * scale), static_cast<float>(right * scale)};
}

}  // namespace

void Interface::draw_left(const Session& session, Wishes& wishes) {
    if (PicturesPanel::is_needed(session)) section("Pictures", [&] { pictures_.draw(session, wishes); });
    section("Maps", [&] { maps_.draw(session, wishes); });
    if (session.current() == nullptr) return;
    section("View", [&] { draw_view_controls(session, wishes); });
    section("Histogram", [&] { histogram_.draw(session, wishes); });
    section("Ellipses", [&] { draw_glyph_controls(session.view(), wishes); });
    section("Polarimeter", [&] { draw_polarimeter_panel(session, wishes); });
}

void Interface::draw_tabs(const Session& session, Wishes& wishes, Stack stack) {
    if (!ImGui::BeginTabBar("tabs", ImGuiTabBarFlags_FittingPolicyScroll)) return;
    const bool upper = stack != Stack::lower;
    const bool lower = stack != Stack::upper;
    tab(upper, "Pixel", [&] { pixel_.draw(session, wishes); });
    const bool compares = session.selection().region || session.documents().size() > 1;
    tab(upper && compares, "Compare", [&] {
        section("Region", [&] { region_.draw(session, wishes); });
        section("Convention", [&] { doctor_.draw(session, wishes); });
    });
    const bool is_picture = session.current() != nullptr && !session.current()->has_scene();
    // One tab, which stays open when the document changes.
    tab(upper, is_picture ? "Picture###Scene" : "Scene###Scene", [&] { scene_.draw(session, wishes); });
    if (upper && session.current() != nullptr && session.current()->fact()) {
        const bool to_front = std::exchange(facts_opened_, session.facts_opened()) != session.facts_opened();
        tab(
            true, "Fact", [&] { draw_fact_panel(session, wishes); },
            to_front ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None);
    }
    tab(lower, "Paths", [&] { of_tree_->paths.draw(session, wishes); });
    tab(lower, "Table", [&] { of_tree_->rays.draw(session, wishes); });
    tab(lower, "3-D", [&] { of_tree_->space.draw(session, wishes); });
    tab(lower, "Sphere", [&] { sphere_.draw(session, wishes); });
    ImGui::EndTabBar();
}

void Interface::draw_overlays(const Session& session, Wishes& wishes) {
    draw_help_overlay(session, wishes);
    log_.draw(session, wishes);
    palette_.draw(session, wishes);
    open_dialog_.draw(session, wishes);
    save_as_dialog_.draw(session, wishes);
    go_to_dialog_.draw(session, wishes);
    send_dialog_.draw(session, wishes);
    draw_unsaved_dialog(session, wishes);
    draw_rewrite_dialog(session, wishes);
    draw_layout_dialog(session, wishes);
}

Wishes Interface::draw(const Session& session, Frame& frame) {
    Wishes wishes;
    const WindowState& state = session.window();
    Layout layout = state.layout;
    if (theme_ != state.theme || theme_scale_ != frame.ui_scale) {
        apply_theme(state.theme, frame.ui_scale);
        theme_ = state.theme;
        theme_scale_ = frame.ui_scale;
    }
    // The frame before has told of what is open: it was closed since.
    if (any_popup_open() && !state.popup_open) ImGui::ClosePopupToLevel(0, true);
    if (session.documents().size() < documents_) of_tree_.emplace();
    documents_ = session.documents().size();
    if (std::exchange(copies_, session.copies()) != session.copies()) ImGui::SetClipboardText(session.copied().c_str());
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const auto scale = static_cast<float>(frame.ui_scale);
    if (!state.panels_visible) {
        bare_part("Picture", {0.0F, 0.0F}, window, [&] { picture_.draw(session, wishes, frame); });
    } else {
        const float top = draw_menu_bar(session, wishes);
        const float status = ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().WindowPadding.y;
        const float height = std::max(1.0F, window.y - top - status);
        const float bar = splitter_width * scale;
        const Widths widths = fitting(state.layout, window.x, frame.ui_scale);
        const float right_x = window.x - widths.right;
        part("Left", {0.0F, top}, {widths.left, height}, [&] { draw_left(session, wishes); });
        const bool two = height >= two_stacks_height * scale;
        const float upper = two ? std::floor(height * static_cast<float>(state.layout.upper_share)) : height;
        part("Right", {right_x, top}, {widths.right, upper},
             [&] { draw_tabs(session, wishes, two ? Stack::upper : Stack::all); });
        if (two) {
            part("Right below", {right_x, top + upper + bar}, {widths.right, height - upper - bar},
                 [&] { draw_tabs(session, wishes, Stack::lower); });
            const float moved =
                splitter("splitter right", {right_x, top + upper}, {widths.right, bar}, ImGuiMouseCursor_ResizeNS);
            layout.upper_share = std::clamp(layout.upper_share + moved / height, 0.15, 0.85);
        }
        part("Status", {0.0F, window.y - status}, {window.x, status}, [&] { draw_status_line(session, wishes); });

        const float middle = std::max(1.0F, window.x - widths.left - widths.right - 2.0F * bar);
        bare_part("Picture", {widths.left + bar, top}, {middle, height}, [&] {
            session.current() == nullptr ? draw_welcome(session, wishes) : picture_.draw(session, wishes, frame);
        });
        const float left_moved =
            splitter("splitter left", {widths.left, top}, {bar, height}, ImGuiMouseCursor_ResizeEW);
        const float right_moved =
            splitter("splitter picture", {right_x - bar, top}, {bar, height}, ImGuiMouseCursor_ResizeEW);
        if (left_moved != 0.0F) layout.left_width = (widths.left + left_moved) / frame.ui_scale;
        if (right_moved != 0.0F) layout.right_width = (widths.right - right_moved) / frame.ui_scale;
    }
    if (layout != state.layout) wishes.set(&WindowState::layout, layout);
    if (frame.viewport.size.x > 0.0 && frame.viewport.size != session.view_size())
        wishes.add([size = frame.viewport.size](Session& s) { s.set_view_size(size); });
    draw_problem_banner(session, frame);
    draw_reading_panel(session, wishes, frame);
    draw_overlays(session, wishes);
    if (any_popup_open() != state.popup_open) wishes.set(&WindowState::popup_open, any_popup_open());
    if (!wishes.empty()) frame.again(0.0);
    return wishes;
}

}  // namespace pol
