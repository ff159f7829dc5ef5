// SPDX-License-Identifier: Apache-2.0
#include "viewer/widgets/polarization_ellipse.h"

#include <imgui.h>

#include <array>
#include <cmath>

#include "core/units.h"

namespace pol {

namespace {

constexpr int points = 96;

/// Takes the square's place and draws its axes; returns its center.
ImVec2 draw_axes(float side, float radius, ImU32 dim) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy({side, side});
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 center(corner.x + 0.5F * side, corner.y + 0.5F * side);
    draw.AddLine({center.x - radius, center.y}, {center.x + radius, center.y}, dim);
    draw.AddLine({center.x, center.y - radius}, {center.x, center.y + radius}, dim);
    draw.AddText({center.x + radius - ImGui::GetFontSize() * 0.4F, center.y + 1.0F}, dim, "x");
    draw.AddText({center.x + 3.0F, center.y - radius - ImGui::GetFontSize() * 0.4F}, dim, "y");
    return center;
}

}  // namespace

void draw_azimuth(const Measures<double>& seen, float side) {
    const float radius = 0.42F * side;
    const ImVec2 center = draw_axes(side, radius, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    if (!seen.has_azimuth) return;
    const double length = radius * std::sqrt(std::min(1.0, seen.dolp));
    const auto x = static_cast<float>(length * std::cos(seen.azimuth));
    const auto y = static_cast<float>(length * std::sin(seen.azimuth));
    ImGui::GetWindowDrawList()->AddLine({center.x - x, center.y + y}, {center.x + x, center.y - y},
                                        ImGui::GetColorU32(ImGuiCol_PlotLines), 2.0F);
}

void draw_polarization_ellipse(const Measures<double>& seen, float side) {
    const float radius = 0.42F * side;
    const ImU32 dim = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    const ImU32 ink = ImGui::GetColorU32(ImGuiCol_PlotLines);
    const ImVec2 center = draw_axes(side, radius, dim);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (!seen.has_light) return;

    const auto place = [&](const DVec2& e, double share) {
        const double r = radius * std::sqrt(share);
        return ImVec2(center.x + static_cast<float>(r * e.x), center.y - static_cast<float>(r * e.y));
    };
    const auto field_at = [&](double phase) { return field_tip(seen.azimuth, seen.ellipticity_angle, phase); };
    const double unpolarized = std::max(0.0, seen.unpolarized);
    for (int i = 0; i < points; i += 4) {  // half the unpolarized light in any direction: mean radius sqrt(share / 2)
        const double from = 2.0 * pi * i / points;
        const double to = 2.0 * pi * (i + 2) / points;
        const auto on_circle = [](double a) { return DVec2(std::cos(a), std::sin(a)); };
        draw.AddLine(place(on_circle(from), 0.5 * unpolarized), place(on_circle(to), 0.5 * unpolarized), dim);
    }
    if (!seen.has_polarization) return;
    const double polarized = std::min(1.0, seen.dop);
    std::array<ImVec2, points> outline;
    for (int i = 0; i < points; ++i)
        outline[static_cast<std::size_t>(i)] = place(field_at(2.0 * pi * i / points), polarized);
    draw.AddPolyline(outline.data(), points, ink, ImDrawFlags_Closed, 2.0F);
    if (seen.handedness == 0) return;

    // The field at a quarter of a turn before it comes back to the major axis, and a little later.
    constexpr double phase = -0.25 * pi;
    const ImVec2 tip = place(field_at(phase + 0.12), polarized);
    const ImVec2 tail = place(field_at(phase - 0.12), polarized);
    const float length = std::hypot(tip.x - tail.x, tip.y - tail.y);
    if (length < 1e-3F) return;
    const ImVec2 along((tip.x - tail.x) / length, (tip.y - tail.y) / length);
    const float size = 0.06F * side;
    draw.AddTriangleFilled({tip.x + size * along.x, tip.y + size * along.y},
                           {tip.x - 0.6F * size * along.y, tip.y + 0.6F * size * along.x},
                           {tip.x + 0.6F * size * along.y, tip.y - 0.6F * size * along.x}, ink);
}

}  // namespace pol
