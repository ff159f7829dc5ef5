// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/picture_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

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
/// To each side of the line of a wipe, where it can be taken hold of.
constexpr float wipe_reach = 5.0F;
constexpr double gap_between_sides = 4.0;

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

void show_texture(std::uintptr_t texture, const ViewRect& viewport) {
    if (texture == 0) return;
    ImGui::GetWindowDrawList()->AddImage(reinterpret_cast<ImTextureID>(texture), point(viewport.origin),
                                         point(viewport.origin + viewport.size), {0.0F, 1.0F}, {1.0F, 0.0F});
}

/// Which picture that is, in the upper corner on its side.
void label(const std::string& name, const ViewRect& viewport, bool to_the_right) {
    constexpr double margin = 8.0;
    const double width = ImGui::CalcTextSize(name.c_str()).x;
    const DVec2 at = viewport.origin + DVec2(to_the_right ? viewport.size.x - width - margin : margin, margin);
    rimmed_text(*ImGui::GetWindowDrawList(), point(glm::round(at)), white_ink, name);
}

/// The reference left of the line, which can be dragged.
void draw_wipe(const Session& session, Wishes& wishes, const Frame& frame) {
    const ViewRect& all = frame.viewport;
    const double x = std::round(std::clamp(session.view().wipe, 0.0, 1.0) * all.size.x);
    const ViewRect left{all.origin, {x, all.size.y}};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(point(left.origin), point(left.origin + left.size), true);
    list.AddRectFilled(point(left.origin), point(left.origin + left.size), rim_color | IM_COL32_A_MASK);
    show_texture(frame.reference_texture, all);
    label(session.reference()->name(), left, false);
    list.PopClipRect();
    list.PushClipRect(point(all.origin + DVec2(x, 0.0)), point(all.origin + all.size), true);
    label(session.current()->name(), all, true);
    list.PopClipRect();
    const ImVec2 top = point(all.origin + DVec2(x, 0.0));
    rimmed_line(list, top, {top.x, top.y + static_cast<float>(all.size.y)}, pin_ink);
    ImGui::SetCursorScreenPos({top.x - wipe_reach, top.y});
    ImGui::InvisibleButton("wipe", {2.0F * wipe_reach, static_cast<float>(all.size.y)});
    name_widget("wipe");
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    const double wanted = std::clamp((ImGui::GetIO().MousePos.x - all.origin.x) / all.size.x, 0.0, 1.0);
    if (ImGui::IsItemActive() && wanted != session.view().wipe) wishes.set(&ViewSettings::wipe, wanted);
}

/// What takes the mouse: the viewport, and the reference's beside it.
void place_viewport(const char* name, const ViewRect& viewport) {
    ImGui::SetCursorScreenPos(point(viewport.origin));
    ImGui::InvisibleButton(name, point(viewport.size),
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
    name_widget(name);
}

void wish_camera(const Session& session, Wishes& wishes, const Camera& camera, const char* label) {
    wishes.add([of = session.current(), camera, label](Session& s) { s.move_camera(of, camera, label); });
}

/// The cursor's place and the pins on the reference, and the cursor's on the picture if it is on the reference.
void draw_pointers(const Session& session, const PlacedPicture& placed, const ViewRect& beside) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const PlacedPicture other{beside, placed.transform};
    const double half = std::max(4.0, 0.5 * placed.transform.scale);
    const auto box = [&](const PlacedPicture& where, const PixelAddress& pixel, ImU32 color) {
        const DVec2 center = where.window_from_picture({pixel.x + 0.5, pixel.y + 0.5});
        list.PushClipRect(point(where.viewport.origin), point(where.viewport.origin + where.viewport.size), true);
        list.AddRect(point(center - half), point(center + half), rim_color, 0.0F, 0, 3.5F);
        list.AddRect(point(center - half), point(center + half), color, 0.0F, 0, 1.5F);
        list.PopClipRect();
    };
    const Selection& selection = session.selection();
    for (const PixelAddress& pin : selection.pins) box(other, pin, pin == selection.pinned() ? pin_ink : white_ink);
    if (!selection.hovered) return;
    const bool is_on_reference = ImGui::GetIO().MousePos.x < placed.viewport.origin.x;
    box(is_on_reference ? placed : other, *selection.hovered, white_ink);
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
    frame.reference_viewport = {};
    const CompareLayout layout = session.layout();
    if (layout == CompareLayout::wipe) frame.reference_viewport = frame.viewport;
    if (layout == CompareLayout::side_by_side) {
        ViewRect& left = frame.reference_viewport;
        left = frame.viewport;
        left.size.x = std::max(1.0, std::floor(0.5 * (left.size.x - gap_between_sides)));
        frame.viewport.size.x = left.size.x;
        frame.viewport.origin.x += left.size.x + gap_between_sides;
    }
    show_texture(frame.picture_texture, frame.viewport);
    if (session.current() == nullptr) {
        place_viewport("picture", frame.viewport);
        fitted_whole_.reset();
        invite(frame.viewport);
        return;
    }
    if (layout == CompareLayout::wipe) draw_wipe(session, wishes, frame);
    if (layout == CompareLayout::side_by_side) {
        show_texture(frame.reference_texture, frame.reference_viewport);
        label(session.reference()->name(), frame.reference_viewport, false);
        label(session.current()->name(), frame.viewport, true);
    }
    const PixelAddress corner = corner_of(session.current()->picture());
    PlacedPicture placed{frame.viewport, of_part(session.transform(), corner)};
    fit_if_new(session, placed);
    std::optional<PixelAddress> hovered;
    if (layout == CompareLayout::side_by_side) {
        // Both sides have the same zoom and pan: the mouse does on the one what it does on the other.
        PlacedPicture beside{frame.reference_viewport, placed.transform};
        place_viewport("reference", beside.viewport);
        hovered = handle_mouse(session, wishes, beside);
        placed.transform = beside.transform;
    }
    place_viewport("picture", placed.viewport);
    if (const auto here = handle_mouse(session, wishes, placed)) hovered = here;
    if (hovered != session.selection().hovered) wishes.add([hovered](Session& s) { s.hover(hovered); });
    if (placed.transform != of_part(session.transform(), corner))
        wishes.add([transform = of_whole(placed.transform, corner)](Session& s) { s.change_transform() = transform; });
    overlay_.draw(session, placed);
    if (layout == CompareLayout::side_by_side) draw_pointers(session, placed, frame.reference_viewport);
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

std::optional<PixelAddress> PicturePanel::handle_mouse(const Session& session, Wishes& wishes, PlacedPicture& placed) {
    const ImGuiIO& io = ImGui::GetIO();
    ViewTransform& transform = placed.transform;
    const DVec2 at = DVec2(io.MousePos.x, io.MousePos.y) - placed.viewport.origin;
    if (ImGui::IsItemHovered() && io.MouseWheel != 0.0F) handle_wheel(session, wishes, placed, at);
    const DVec2 extent = extent_of(session);
    const DVec2 p = transform.picture_from_view(at);
    const bool is_inside = p.x >= 0.0 && p.y >= 0.0 && p.x < extent.x && p.y < extent.y;
    const PixelAddress pixel{static_cast<int>(p.x), static_cast<int>(p.y)};
    const auto hovered = ImGui::IsItemHovered() && is_inside ? std::optional(pixel) : std::nullopt;

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
    return hovered;
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
