// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/picture_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "viewer/panels/hover_readout.h"
#include "viewer/session/map_look.h"
#include "viewer/shown/picture_place.h"
#include "viewer/space/camera_moves.h"
#include "viewer/widgets/ink.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

constexpr double zoom_per_notch = 1.2;
/// A press that moves less than this is a click.
constexpr float click_slack = 4.0F;
constexpr double wheel_radius = 30.0;
constexpr float strip_padding = 6.0F;

/// Of what the picture on screen has, from its own corner.
DVec2 extent_of(const Session& session) {
    const StokesImage& picture = session.current()->picture();
    return {picture.width, picture.height};
}

/// Pixels that a rectangle between two points of the picture touches; empty outside the picture.
std::optional<TileRect> touched(const DVec2& a, const DVec2& b, const DVec2& extent) {
    const DVec2 low = glm::clamp(glm::floor(glm::min(a, b)), DVec2(0.0), extent);
    const DVec2 high = glm::clamp(glm::floor(glm::max(a, b)) + 1.0, DVec2(0.0), extent);
    if (low.x >= high.x || low.y >= high.y) return std::nullopt;
    return TileRect{static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(high.x),
                    static_cast<int>(high.y)};
}

/// The viewport as an item of the interface, with the picture in it.
void show_viewport(const Frame& frame) {
    const ImVec2 origin = point(frame.viewport.origin);
    const ImVec2 size = point(frame.viewport.size);
    const ImVec2 end(origin.x + size.x, origin.y + size.y);
    if (frame.picture_texture != 0)
        ImGui::GetWindowDrawList()->AddImage(reinterpret_cast<ImTextureID>(frame.picture_texture), origin, end,
                                             {0.0F, 1.0F}, {1.0F, 0.0F});
    ImGui::InvisibleButton("viewport", size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
    name_widget("picture");
}

void wish_camera(const Session& session, Wishes& wishes, const Camera& camera, const char* label) {
    wishes.add([of = session.current(), camera, label](Session& s) { s.move_camera(of, camera, label); });
}

void invite(const ViewRect& viewport) {
    constexpr const char* text = "Drop a scene or an EXR file here";
    const ImVec2 size = ImGui::CalcTextSize(text);
    const DVec2 middle = viewport.origin + 0.5 * viewport.size;
    ImGui::GetWindowDrawList()->AddText(point(middle - 0.5 * DVec2(size.x, size.y)),
                                        ImGui::GetColorU32(ImGuiCol_TextDisabled), text);
}

}  // namespace

void PicturePanel::draw(const Session& session, Wishes& wishes, Frame& frame) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const ImVec2 size = ImGui::GetContentRegionAvail();
    const bool has_strip = session.window().panels_visible && session.current() != nullptr;
    const float strip = has_strip ? color_bar_height() + hover_readout_height() + 2.0F * strip_padding : 0.0F;
    frame.viewport = {{origin.x, origin.y}, {std::max(1.0F, size.x), std::max(1.0F, size.y - strip)}};
    show_viewport(frame);
    if (session.current() == nullptr) {
        fitted_whole_.reset();
        invite(frame.viewport);
        return;
    }
    const PixelAddress corner = corner_of(session.current()->picture());
    PlacedPicture placed{frame.viewport, of_part(session.transform(), corner)};
    fit_if_new(session, placed);
    handle_mouse(session, wishes, placed);
    if (placed.transform != of_part(session.transform(), corner))
        wishes.add([transform = of_whole(placed.transform, corner)](Session& s) { s.change_transform() = transform; });
    overlay_.draw(session, placed);
    // Differences are no directions of the picture.
    if (info(session.view().quantity).kind == ScaleKind::cyclic && !session.comparison()) {
        const DVec2 end = frame.viewport.origin + frame.viewport.size;
        draw_azimuth_wheel(session, end - DVec2(wheel_radius + 10.0), wheel_radius);
    }
    if (!has_strip) return;
    ImGui::SetCursorScreenPos({origin.x + strip_padding, origin.y + size.y - strip + strip_padding});
    ImGui::BeginGroup();
    color_bar_.draw(session, wishes, size.x - 2.0F * strip_padding);
    ImGui::EndGroup();
    ImGui::SetCursorScreenPos({origin.x + strip_padding, origin.y + size.y - hover_readout_height() - strip_padding});
    ImGui::BeginGroup();
    draw_hover_readout(session);
    ImGui::EndGroup();
}

void PicturePanel::fit_if_new(const Session& session, PlacedPicture& placed) {
    const StokesImage& picture = session.current()->picture();
    const WholePicture whole = whole_of(picture);
    const bool is_new = fitted_whole_ != whole;
    const bool has_new_size = placed.transform.fitted && fitted_view_ != placed.viewport.size;
    if (is_new || has_new_size) {
        ViewTransform transform = session.transform();
        fit(transform, whole, placed.viewport.size);
        placed.transform = of_part(transform, corner_of(picture));
    }
    fitted_whole_ = whole;
    fitted_view_ = placed.viewport.size;
}

void PicturePanel::handle_mouse(const Session& session, Wishes& wishes, PlacedPicture& placed) {
    const ImGuiIO& io = ImGui::GetIO();
    ViewTransform& transform = placed.transform;
    const DVec2 at = DVec2(io.MousePos.x, io.MousePos.y) - placed.viewport.origin;
    if (ImGui::IsItemHovered() && io.MouseWheel != 0.0F) handle_wheel(session, wishes, placed, at);
    const DVec2 extent = extent_of(session);
    const DVec2 p = transform.picture_from_view(at);
    const bool is_inside = p.x >= 0.0 && p.y >= 0.0 && p.x < extent.x && p.y < extent.y;
    const PixelAddress pixel{static_cast<int>(p.x), static_cast<int>(p.y)};
    const auto hovered = ImGui::IsItemHovered() && is_inside ? std::optional(pixel) : std::nullopt;
    if (hovered != session.selection().hovered) wishes.add([hovered](Session& s) { s.hover(hovered); });

    if (ImGui::IsItemActivated()) {
        drag_ = Drag::none;
        drag_from_ = p;
    }
    const bool is_left = io.MouseDown[ImGuiMouseButton_Left];
    const auto button = is_left ? ImGuiMouseButton_Left : ImGuiMouseButton_Middle;
    if (ImGui::IsItemActive() && drag_ == Drag::none && ImGui::IsMouseDragging(button, click_slack))
        drag_ = is_left ? drag_meant(session) : Drag::pan;
    // The picture point that was taken hold of stays under the cursor.
    if (ImGui::IsItemActive() && drag_ == Drag::pan) transform.pan(at - transform.view_from_picture(drag_from_));
    if (ImGui::IsItemActive() && drag_ == Drag::region)
        wishes.add([region = touched(drag_from_, p, extent)](Session& s) { s.select_region(region); });
    move_camera(session, wishes, transform.scale);
    if (ImGui::IsItemDeactivated() && drag_ == Drag::none && ImGui::IsMouseReleased(ImGuiMouseButton_Left)) {
        if (io.KeyShift)
            wishes.add([](Session& s) { s.select_region({}); });
        else if (is_inside)
            wishes.add([pixel](Session& s) { s.pin(pixel); });
    }
}

PicturePanel::Drag PicturePanel::drag_meant(const Session& session) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyAlt && session.current()->has_scene()) return io.KeyShift ? Drag::pan_camera : Drag::orbit_camera;
    return io.KeyShift ? Drag::region : Drag::pan;
}

void PicturePanel::handle_wheel(const Session& session, Wishes& wishes, PlacedPicture& placed, const DVec2& at) {
    const ImGuiIO& io = ImGui::GetIO();
    const double factor = std::pow(zoom_per_notch, static_cast<double>(io.MouseWheel));
    if (!io.KeyAlt || !session.current()->has_scene()) {
        placed.transform.zoom_at(at, factor);
        return;
    }
    wish_camera(session, wishes, dollied(session.current()->scene().camera, factor), "camera dolly");
    dollying_ = true;
}

/// A drag is one step of undo, and so are the turns of the wheel until Alt is let go.
void PicturePanel::move_camera(const Session& session, Wishes& wishes, double points_per_pixel) {
    const Document& document = *session.current();
    const ImGuiIO& io = ImGui::GetIO();
    const bool dragging = drag_ == Drag::orbit_camera || drag_ == Drag::pan_camera;
    const DVec2 moved(io.MouseDelta.x, io.MouseDelta.y);
    if (dragging && document.has_scene() && ImGui::IsItemActive() && moved != DVec2(0.0)) {
        const Camera& camera = document.scene().camera;
        if (drag_ == Drag::orbit_camera)
            wish_camera(session, wishes, orbited(camera, moved), "camera orbit");
        else
            wish_camera(session, wishes, panned(camera, moved / points_per_pixel, document.picture().width),
                        "camera pan");
    }
    const bool ended = (dragging && ImGui::IsItemDeactivated()) || (dollying_ && !io.KeyAlt);
    if (!ended) return;
    wishes.add([of = &document](Session& s) { s.end_edit(of); });
    dollying_ = false;
}

}  // namespace pol
