// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/sphere_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/units.h"
#include "maps/color_scale.h"
#include "viewer/pages/readout_text.h"
#include "viewer/widgets/ink.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

constexpr std::size_t most_points = 4000;
constexpr float click_slack = 3.0F;
constexpr double pick_distance = 8.0;

TileRect region_of(const Session& session) {
    const StokesImage& picture = session.current()->picture();
    const TileRect whole{0, 0, picture.width, picture.height};
    if (!session.selection().region) return whole;
    TileRect region = *session.selection().region;
    region.x1 = std::min(region.x1, whole.x1);
    region.y1 = std::min(region.y1, whole.y1);
    return region.x0 < region.x1 && region.y0 < region.y1 ? region : whole;
}

DVec2 on_screen(const DVec3& seen, const DVec2& center, double radius) {
    return center + radius * DVec2(seen.x, -seen.y);
}

/// A circle of the sphere with the unit axes `a` and `b` in its plane: the front half strong, the back half faint.
void draw_circle(ImDrawList& list, const SphereView& view, const DVec3& a, const DVec3& b, const DVec2& center,
                 double radius) {
    constexpr int steps = 96;
    DVec3 before = view.seen(a);
    for (int i = 1; i <= steps; ++i) {
        const double angle = 2.0 * pi * i / steps;
        const DVec3 now = view.seen(std::cos(angle) * a + std::sin(angle) * b);
        const int alpha = now.z >= 0.0 ? 150 : 50;
        list.AddLine(point(on_screen(before, center, radius)), point(on_screen(now, center, radius)),
                     ImGui::GetColorU32(ImGuiCol_Text, static_cast<float>(alpha) / 255.0F));
        before = now;
    }
}

void draw_globe(ImDrawList& list, const SphereView& view, const Convention& convention, const DVec2& center,
                double radius) {
    list.AddCircle(point(center), static_cast<float>(radius), ImGui::GetColorU32(ImGuiCol_Text, 0.6F), 96);
    const DVec3 s1(1.0, 0.0, 0.0);
    const DVec3 s2(0.0, 1.0, 0.0);
    const DVec3 s3(0.0, 0.0, 1.0);
    draw_circle(list, view, s1, s2, center, radius);
    draw_circle(list, view, s1, s3, center, radius);
    draw_circle(list, view, s2, s3, center, radius);
    for (const SphereLabel& label : sphere_labels(convention)) {
        const DVec3 seen = view.seen(1.09 * label.at);
        const ImVec2 size = ImGui::CalcTextSize(label.text.c_str());
        list.AddText(point(on_screen(seen, center, radius) - 0.5 * DVec2(size.x, size.y)),
                     ImGui::GetColorU32(ImGuiCol_Text, seen.z >= 0.0 ? 1.0F : 0.4F), label.text.c_str());
    }
}

/// The shape says the wavelength: five of them in turn, from the shortest on.
void draw_marker(ImDrawList& list, const DVec2& at, std::size_t wavelength, float size, ImU32 color) {
    const ImVec2 p = point(at);
    switch (wavelength % 5) {
        case 0:
            list.AddCircleFilled(p, size, color, 12);
            break;
        case 1:
            list.AddRectFilled({p.x - size, p.y - size}, {p.x + size, p.y + size}, color);
            break;
        case 2:
            list.AddTriangleFilled({p.x, p.y - 1.2F * size}, {p.x + 1.1F * size, p.y + size},
                                   {p.x - 1.1F * size, p.y + size}, color);
            break;
        case 3:
            list.AddNgonFilled(p, 1.3F * size, color, 4);
            break;
        default:
            list.AddLine({p.x - size, p.y - size}, {p.x + size, p.y + size}, color, 2.0F);
            list.AddLine({p.x - size, p.y + size}, {p.x + size, p.y - size}, color, 2.0F);
            break;
    }
}

}  // namespace

void SpherePanel::draw(const Session& session, Wishes& wishes) {
    if (session.current() == nullptr) {
        ImGui::TextDisabled("Open a scene or a picture");
        return;
    }
    choose_source(session, wishes);
    points_ = points(session);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 available = ImGui::GetContentRegionAvail();
    const float side = std::max(40.0F, std::min(available.x, available.y - ImGui::GetTextLineHeightWithSpacing()));
    ImGui::InvisibleButton("sphere", {side, side});
    name_widget("sphere");
    const DVec2 center(at.x + 0.5F * side, at.y + 0.5F * side);
    const double radius = 0.42 * static_cast<double>(side);
    handle_mouse(session, wishes, center, radius);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + side, at.y + side}, IM_COL32(0, 0, 0, 60));
    draw_globe(list, view_, session.view().convention, center, radius);
    draw_points(session, center, radius);
    for (std::size_t i = 0; i + 1 < lasso_.size(); ++i)
        list.AddLine(point(center + radius * DVec2(lasso_[i].x, -lasso_[i].y)),
                     point(center + radius * DVec2(lasso_[i + 1].x, -lasso_[i + 1].y)), pin_ink, 1.5F);
    ImGui::TextDisabled("%zu %s; %s", points_.size(), points_.size() == 1 ? "point" : "points",
                        session.view().convention.stokes_text().c_str());
    const std::string missing =
        missing_text(StokesComponents::all(), session.shown_picture().known(session.view().band));
    if (!missing.empty()) list.AddText(at, ImGui::GetColorU32(ImGuiCol_Text), (missing + ": no place on it").c_str());
}

void SpherePanel::choose_source(const Session& session, Wishes& wishes) {
    int source = static_cast<int>(source_);
    ImGui::RadioButton("pins", &source, static_cast<int>(Source::pins));
    tooltip("The pinned pixels at all wavelengths; the shape of a marker says the wavelength, a line follows them.");
    ImGui::SameLine();
    ImGui::RadioButton("region", &source, static_cast<int>(Source::region));
    tooltip(
        "The pixels of the region (Shift and drag in the picture), or of the whole picture, at the shown wavelength.");
    ImGui::SameLine();
    ImGui::RadioButton("leaves", &source, static_cast<int>(Source::leaves));
    tooltip("What each leaf of the pinned pixel's tree brings to the pixel, in the pixel's frame.");
    source_ = static_cast<Source>(source);
    ImGui::SameLine();
    ImGui::Checkbox("front", &front_only_);
    tooltip("The lasso (Shift and drag) takes only points of the half that faces you.");
    if (!session.selection().marked.empty()) {
        ImGui::SameLine();
        if (ImGui::SmallButton("clear marks")) wishes.add([](Session& s) { s.mark({}); });
    }
}

std::vector<SpherePoint> SpherePanel::points(const Session& session) const {
    const StokesImage& picture = session.current()->picture();
    const ShownPicture shown = session.shown_picture();
    std::vector<SpherePoint> found;
    if (source_ == Source::region) return sphere_points(shown, session.view().band, region_of(session), most_points);
    if (source_ == Source::pins) {
        for (const PixelAddress& pin : session.selection().pins) {
            for (std::size_t w = 0; w < picture.bands.size(); ++w) {
                if (shown.known(w) != StokesComponents::all()) continue;
                auto point = sphere_point(shown.stokes(w, picture.pixel(pin.x, pin.y)));
                if (!point) continue;
                point->band = w;
                point->pixel = pin;
                found.push_back(*point);
            }
        }
        return found;
    }
    const auto explanation = session.explanation();
    return explanation ? sphere_points(*explanation, session.polarimeter(), session.view().convention, most_points)
                       : found;
}

void SpherePanel::handle_mouse(const Session& session, Wishes& wishes, const DVec2& center, double radius) {
    const ImGuiIO& io = ImGui::GetIO();
    const DVec2 mouse(io.MousePos.x, io.MousePos.y);
    const DVec2 place = DVec2(mouse.x - center.x, center.y - mouse.y) / radius;
    if (ImGui::IsItemActivated()) {
        is_lasso_ = io.KeyShift;
        lasso_.clear();
    }
    const bool is_dragging = ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, click_slack);
    if (is_dragging && is_lasso_) lasso_.push_back(place);
    if (is_dragging && !is_lasso_) view_.drag(DVec2(io.MouseDelta.x, io.MouseDelta.y) / radius);
    const bool was_click = ImGui::IsItemDeactivated() &&
                           ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, click_slack).x == 0.0F &&
                           ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, click_slack).y == 0.0F;
    if (ImGui::IsItemDeactivated() && lasso_.size() > 2) {
        wishes.add([pixels = pixels_inside(session.shown_picture(), session.view().band, region_of(session), view_,
                                           lasso_, front_only_)](Session& s) { s.mark(pixels); });
        source_ = Source::region;
    }
    if (ImGui::IsItemDeactivated()) lasso_.clear();
    if (!ImGui::IsItemHovered() || is_dragging) return;

    const SpherePoint* nearest = nullptr;
    double least = pick_distance;
    for (const SpherePoint& candidate : points_) {
        const double distance = glm::length(on_screen(view_.seen(candidate.place), center, radius) - mouse);
        if (distance >= least) continue;
        least = distance;
        nearest = &candidate;
    }
    if (nearest == nullptr) return;
    const StokesImage& picture = session.current()->picture();
    const std::string what =
        nearest->pixel ? fmt::format("pixel {},{}", picture.left + nearest->pixel->x, picture.top + nearest->pixel->y)
                       : fmt::format("branch {}", *nearest->node);
    ImGui::SetTooltip("%s, %s\nS/S0 = (%s, %s, %s)\nS0 = %s", what.c_str(),
                      band_text(session.current()->picture().bands[nearest->band]).c_str(),
                      short_number(nearest->place.x, 4).c_str(), short_number(nearest->place.y, 4).c_str(),
                      short_number(nearest->place.z, 4).c_str(), short_number(nearest->intensity, 4).c_str());
    if (!was_click) return;
    if (nearest->pixel) wishes.add([pixel = *nearest->pixel](Session& s) { s.pin(pixel); });
    if (nearest->node) wishes.add([node = *nearest->node](Session& s) { s.select_branch(node); });
}

void SpherePanel::draw_points(const Session& session, const DVec2& center, double radius) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    double brightest = std::numeric_limits<double>::min();
    for (const SpherePoint& p : points_) brightest = std::max(brightest, p.intensity);
    const StokesImage& picture = session.current()->picture();
    const std::vector<bool>& marked = session.selection().marked;
    const bool has_marks = marked.size() == picture.pixel_count();
    const SpherePoint* before = nullptr;
    for (const SpherePoint& p : points_) {
        const DVec3 seen = view_.seen(p.place);
        const DVec2 at = on_screen(seen, center, radius);
        if (source_ == Source::pins && before != nullptr && before->pixel == p.pixel)
            list.AddLine(point(on_screen(view_.seen(before->place), center, radius)), point(at),
                         ImGui::GetColorU32(ImGuiCol_Text, 0.25F));
        before = &p;
        const bool is_dimmed = has_marks && p.pixel && !marked[picture.pixel(p.pixel->x, p.pixel->y)];
        const int alpha = is_dimmed ? 30 : seen.z >= 0.0 ? 255 : 90;
        // The dark end of the scale would not be seen on the dark ground.
        const Rgb color = scale_color(ColorScale::sequential, 0.3 + 0.7 * p.intensity / brightest);
        const bool is_many = source_ == Source::region;
        draw_marker(list, at, is_many ? 0 : p.band, is_many ? 1.8F : 3.5F, ink(encode(color), alpha));
        const bool is_selected =
            (p.node && p.node == session.selection().node) || (p.pixel && p.pixel == session.selection().hovered);
        if (is_selected) list.AddCircle(point(at), 6.0F, pin_ink, 16, 1.5F);
    }
}

}  // namespace pol
