// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/space_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "viewer/pages/branch_page.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

/// More branches than this are one ball of wool.
constexpr std::size_t most_segments = 3000;
constexpr double reach = 6.0;  ///< points around the cursor in which a click finds a branch

/// Okabe & Ito, "Color universal design", 2008: told apart without color vision.
constexpr std::array<ImU32, all_path_kinds.size()> kind_colors{
    IM_COL32(128, 128, 128, 255),  // camera
    IM_COL32(213, 94, 0, 255),     // reflected
    IM_COL32(86, 180, 233, 255),   // transmitted
    IM_COL32(0, 158, 115, 255),    // sheet
    IM_COL32(0, 114, 178, 255),    // ordinary
    IM_COL32(230, 159, 0, 255),    // extraordinary
    IM_COL32(204, 121, 167, 255),  // not followed
};

ImU32 color_of(PathKind kind) {
    return kind_colors[static_cast<std::size_t>(kind)];
}

ImU32 faint(ImU32 color, double alpha) {
    const auto part = static_cast<ImU32>(std::lround(255.0 * alpha));
    return (color & ~IM_COL32_A_MASK) | (part << IM_COL32_A_SHIFT);
}

ImU32 text_color(double alpha) {
    return faint(ImGui::GetColorU32(ImGuiCol_Text), alpha);
}

/// A hundredth of the light is still a line of one point.
float width_of(double weight) {
    return static_cast<float>(std::clamp(3.0 + std::log10(std::max(weight, 1e-9)), 1.0, 3.0));
}

ImVec2 in_window(const DVec2& origin, const DVec2& at) {
    return {static_cast<float>(origin.x + at.x), static_cast<float>(origin.y + at.y)};
}

}  // namespace

void SpacePanel::draw(const Session& session, Wishes& wishes) {
    const Document* document = session.current();
    if (document == nullptr) return;
    if (!document->has_scene()) {
        ImGui::TextWrapped("A picture has no scene: open the scene that it was made from.");
        return;
    }
    follow(*document, session.explanation());
    draw_buttons();
    draw_canvas(session, wishes);
}

void SpacePanel::follow(const Document& document, const std::shared_ptr<const Explanation>& explanation) {
    if (document.plan() != plan_) {
        plan_ = document.plan();
        bodies_ = body_lines(*plan_);
        ball_ = scene_ball(bodies_, *plan_);
        pieces_view_.reset();
        explanation_.reset();
        segments_.clear();
        up_ = document.scene().camera.up;
        if (document_ != &document) reset();
        document_ = &document;
    }
    if (explanation == explanation_) return;
    explanation_ = explanation;
    segments_.clear();
    if (explanation_) segments_ = path_segments(explanation_->tree, 2.0 * ball_.radius, most_segments);
}

void SpacePanel::reset() {
    const CameraRay ray = plan_->camera.ray(0.5 * plan_->settings.width, 0.5 * plan_->settings.height);
    // From beside the camera and a little above, so that its rays are seen from the side.
    const DVec3 side = ray.x - ray.direction + 0.6 * ray.y;
    view_ = SpaceView::around(ball_.center, 1.3 * ball_.radius, ball_.center + side, up_);
}

void SpacePanel::look_from_camera() {
    const CameraRay ray = plan_->camera.ray(0.5 * plan_->settings.width, 0.5 * plan_->settings.height);
    view_ = SpaceView::around(ball_.center, ball_.radius, ball_.center - ray.direction, up_);
}

void SpacePanel::draw_buttons() {
    if (ImGui::Button("Reset")) reset();
    name_widget("space reset");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("The whole scene, from beside the camera.");
    ImGui::SameLine();
    if (ImGui::Button("From camera")) look_from_camera();
    name_widget("space from camera");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Looks the way the camera looks.");
    ImGui::SameLine();
    ImGui::Checkbox("Camera", &show_camera_);
    ImGui::SameLine();
    ImGui::Checkbox("Axes", &show_axes_);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Optic axes of crystals.");
    ImGui::SameLine();
    ImGui::Checkbox("Paths", &show_paths_);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Backward paths of the pinned pixel: width by weight.");
}

void SpacePanel::draw_canvas(const Session& session, Wishes& wishes) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float legend = 2.0F * ImGui::GetTextLineHeightWithSpacing();
    const ImVec2 size(std::max(room.x, 50.0F), std::max(room.y - legend, 50.0F));
    origin_ = {origin.x, origin.y};
    size_ = {size.x, size.y};
    ImGui::InvisibleButton(
        "space", size,
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    name_widget("space");
    move_view();
    select(wishes);

    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(origin, {origin.x + size.x, origin.y + size.y}, true);
    list.AddRectFilled(origin, {origin.x + size.x, origin.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg, 0.5F));
    draw_bodies();
    draw_camera_and_axes();
    if (show_paths_) draw_paths(session);
    draw_triad();
    list.PopClipRect();
    draw_legend(session);
}

void SpacePanel::move_view() {
    const ImGuiIO& io = ImGui::GetIO();
    const DVec2 moved(io.MouseDelta.x, io.MouseDelta.y);
    if (ImGui::IsItemActive() && (moved.x != 0.0 || moved.y != 0.0)) {
        if (ImGui::IsMouseDown(ImGuiMouseButton_Left) && !io.KeyShift)
            view_.orbit(moved);
        else
            view_.pan(moved, size_);
    }
    if (ImGui::IsItemHovered() && io.MouseWheel != 0.0F) view_.zoom(std::pow(1.2, io.MouseWheel));
}

void SpacePanel::select(Wishes& wishes) {
    if (!show_paths_ || !ImGui::IsItemHovered()) return;
    const ImGuiIO& io = ImGui::GetIO();
    const DVec2 at = DVec2(io.MousePos.x, io.MousePos.y) - origin_;
    const std::optional<int> node = node_at(segments_, view_, size_, at, reach);
    constexpr float click2 = 16.0F;  ///< squared: a drag of less than four points is a click
    if (ImGui::IsMouseReleased(ImGuiMouseButton_Left) && io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] < click2)
        wishes.add([node](Session& s) { s.select_branch(node); });
    if (!node || ImGui::IsAnyMouseDown()) return;
    const RayTreeNode& branch = explanation_->tree.nodes[static_cast<std::size_t>(*node)];
    const bool met_something = branch.arrived && branch.crossing.body >= 0;
    const std::string title =
        branch_title(*plan_, *explanation_, *node, is_total_reflection(*plan_, *explanation_, *node));
    ImGui::SetTooltip("branch %d: %s, weight %.3g\nmeets %s", *node, title.c_str(), branch.start.weight,
                      met_something ? plan_->body_name(branch.crossing.body).c_str() : "nothing");
}

void SpacePanel::draw_bodies() {
    if (pieces_view_ != view_) {
        pieces_.clear();
        for (const BodyLines& body : bodies_) {
            BodyPieces drawn{body.body, {}};
            const auto add = [&](const SpaceLine& line) {
                const auto pieces = pieces_of(line, *plan_, view_.eye());
                drawn.pieces.insert(drawn.pieces.end(), pieces.begin(), pieces.end());
            };
            for (const SpaceLine& edge : body.edges) add(edge);
            if (plan_->is_solid(body.body)) {
                if (const auto* ball = std::get_if<Sphere>(&plan_->solid(body.body).shape))
                    for (const SpaceLine& line : ball_outline(*ball, view_.eye())) add(line);
            }
            pieces_.push_back(std::move(drawn));
        }
        pieces_view_ = view_;
    }

    ImDrawList& list = *ImGui::GetWindowDrawList();
    constexpr ImU32 light = IM_COL32(240, 200, 60, 255);
    for (const BodyLines& body : bodies_) {
        if (plan_->is_solid(body.body) || body.outline.empty()) continue;
        if (!std::holds_alternative<EmitterRole>(plan_->surface(body.body).role)) continue;
        std::vector<ImVec2> corners;
        for (const DVec3& p : body.outline) {
            if (const auto point = view_.project(p, size_)) corners.push_back(in_window(origin_, point->at));
        }
        if (corners.size() == body.outline.size())
            list.AddConvexPolyFilled(corners.data(), static_cast<int>(corners.size()), faint(light, 0.15));
    }
    for (const BodyPieces& body : pieces_) {
        const bool is_light =
            !plan_->is_solid(body.body) && std::holds_alternative<EmitterRole>(plan_->surface(body.body).role);
        for (const SpacePiece& piece : body.pieces) {
            const auto ends = view_.project(piece.line, size_);
            if (!ends) continue;
            const double alpha = piece.hidden ? 0.2 : 0.85;
            list.AddLine(in_window(origin_, ends->first.at), in_window(origin_, ends->second.at),
                         is_light ? faint(light, alpha) : text_color(alpha), 1.0F);
        }
    }
}

void SpacePanel::draw_camera_and_axes() {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (show_camera_) {
        for (const SpaceLine& line : camera_lines(*plan_, 0.4 * ball_.radius)) {
            if (const auto ends = view_.project(line, size_))
                list.AddLine(in_window(origin_, ends->first.at), in_window(origin_, ends->second.at), text_color(0.45),
                             1.0F);
        }
    }
    if (!show_axes_) return;
    constexpr ImU32 axis_color = IM_COL32(220, 60, 140, 255);
    for (const BodyLines& body : bodies_) {
        const auto axis = optic_axis(*plan_, body);
        if (!axis) continue;
        const auto ends = view_.project(*axis, size_);
        if (!ends) continue;
        list.AddLine(in_window(origin_, ends->first.at), in_window(origin_, ends->second.at), axis_color, 2.0F);
        list.AddText(in_window(origin_, ends->second.at + DVec2(4.0, -8.0)), axis_color, "c");
    }
}

void SpacePanel::draw_paths(const Session& session) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const PathSegment& segment : segments_) {
        const auto ends = view_.project(segment.line, size_);
        if (!ends) continue;
        const double alpha = std::clamp(1.0 + 0.2 * std::log10(std::max(segment.weight, 1e-9)), 0.25, 1.0);
        list.AddLine(in_window(origin_, ends->first.at), in_window(origin_, ends->second.at),
                     faint(color_of(segment.kind), alpha), width_of(segment.weight));
    }
    draw_selected(session);
}

void SpacePanel::draw_selected(const Session& session) {
    const std::optional<int> node = session.selection().node;
    if (!node || !explanation_) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 highlight = text_color(1.0);
    const auto found =
        std::find_if(segments_.begin(), segments_.end(), [&](const PathSegment& s) { return s.node == *node; });
    if (found == segments_.end()) return;
    if (const auto ends = view_.project(found->line, size_)) {
        const ImVec2 a = in_window(origin_, ends->first.at);
        const ImVec2 b = in_window(origin_, ends->second.at);
        list.AddLine(a, b, faint(highlight, 0.5), width_of(found->weight) + 5.0F);
        list.AddLine(a, b, color_of(found->kind), width_of(found->weight) + 1.0F);
    }

    const RayTreeNode& branch = explanation_->tree.nodes[static_cast<std::size_t>(*node)];
    const auto figure = field_figure(branch, found->line, 0.12 * ball_.radius);
    if (!figure) return;
    for (const auto& [axis, name] : {std::pair{figure->x, "E1"}, std::pair{figure->y, "E2"}}) {
        const auto ends = view_.project(SpaceLine{figure->center, figure->center + axis}, size_);
        if (!ends || axis == DVec3(0.0)) continue;
        list.AddLine(in_window(origin_, ends->first.at), in_window(origin_, ends->second.at), faint(highlight, 0.5),
                     1.0F);
        list.AddText(in_window(origin_, ends->second.at + DVec2(3.0, -6.0)), faint(highlight, 0.5), name);
    }
    std::vector<ImVec2> tips;
    for (const DVec3& tip : figure->tips) {
        if (const auto point = view_.project(tip, size_)) tips.push_back(in_window(origin_, point->at));
    }
    if (tips.size() < 2) return;
    list.AddPolyline(tips.data(), static_cast<int>(tips.size()), highlight, ImDrawFlags_Closed, 2.0F);
    // An arrow head where the period begins, along the motion.
    const ImVec2 along(tips[1].x - tips[0].x, tips[1].y - tips[0].y);
    const float length = std::sqrt(along.x * along.x + along.y * along.y);
    if (length < 0.3F) return;
    const ImVec2 u(5.0F * along.x / length, 5.0F * along.y / length);
    list.AddTriangleFilled({tips[0].x + u.x, tips[0].y + u.y}, {tips[0].x - u.x - u.y, tips[0].y - u.y + u.x},
                           {tips[0].x - u.x + u.y, tips[0].y - u.y - u.x}, highlight);
}

void SpacePanel::draw_triad() {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const DVec2 corner(30.0, size_.y - 30.0);
    constexpr std::array<const char*, 3> names{"x", "y", "z"};
    constexpr std::array<ImU32, 3> triad_colors{IM_COL32(213, 94, 0, 255), IM_COL32(0, 158, 115, 255),
                                                IM_COL32(0, 114, 178, 255)};
    for (int i = 0; i < 3; ++i) {
        DVec3 axis{};
        axis[i] = 1.0;
        const DVec2 tip = corner + 22.0 * DVec2(dot(axis, view_.right()), -dot(axis, view_.above()));
        const auto index = static_cast<std::size_t>(i);
        list.AddLine(in_window(origin_, corner), in_window(origin_, tip), triad_colors[index], 2.0F);
        list.AddText(in_window(origin_, tip), triad_colors[index], names[index]);
    }
}

void SpacePanel::draw_legend(const Session& session) {
    if (!explanation_) {
        const ExplanationStatus status = session.explanation_status();
        if (status.state == ExplanationState::nothing_asked)
            ImGui::TextDisabled("Click a pixel to see its paths.");
        else if (status.state == ExplanationState::running)
            ImGui::TextDisabled("%zu branches found so far", status.branches);
        else
            ImGui::TextDisabled("%s", status.problem.empty() ? "cancelled" : status.problem.c_str());
        return;
    }
    std::array<bool, all_path_kinds.size()> present{};
    for (const PathSegment& segment : segments_) present[static_cast<std::size_t>(segment.kind)] = true;
    bool first = true;
    for (const PathKind kind : all_path_kinds) {
        if (!present[static_cast<std::size_t>(kind)]) continue;
        if (!first) ImGui::SameLine();
        first = false;
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(color_of(kind)), "%s", name_of(kind));
    }
    const std::size_t all = explanation_->tree.nodes.size();
    if (all > segments_.size()) ImGui::TextDisabled("the heaviest %zu of %zu branches", segments_.size(), all);
}

}  // namespace pol
