// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/spectrum_plot.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "viewer/pages/readout_text.h"

namespace pol {

std::optional<std::size_t> draw_spectrum_plot(const PageCurve& curve, const std::vector<Band>& bands,
                                              std::size_t current, float height) {
    ImGui::Text("%s: %s at %s", curve.name.c_str(), curve.texts[current].c_str(), band_text(bands[current]).c_str());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, height);
    ImGui::PushID(curve.name.c_str());
    const bool clicked = ImGui::InvisibleButton("plot", size);
    ImGui::PopID();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 far(corner.x + size.x, corner.y + size.y);
    draw.AddRectFilled(corner, far, ImGui::GetColorU32(ImGuiCol_FrameBg));
    const double range = curve.high > curve.low ? curve.high - curve.low : 1.0;
    const bool is_spectrum = !wavelengths_of(bands).empty();
    const auto place = [&](std::size_t b) { return is_spectrum ? *bands[b].wavelength_nm : static_cast<double>(b); };
    const double first = place(0);
    const double span = std::max(place(bands.size() - 1) - first, 1e-9);
    constexpr float margin = 6.0F;
    const auto x_of = [&](std::size_t w) {
        return corner.x + margin + (size.x - 2.0F * margin) * static_cast<float>((place(w) - first) / span);
    };
    const auto y_of = [&](double value) {
        return far.y - 3.0F - (size.y - 6.0F) * static_cast<float>((value - curve.low) / range);
    };
    draw.AddLine({x_of(current), corner.y}, {x_of(current), far.y}, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    const ImU32 ink = ImGui::GetColorU32(ImGuiCol_PlotLines);
    for (std::size_t w = 0; w < curve.values.size(); ++w) {
        if (!curve.values[w]) continue;
        const ImVec2 here(x_of(w), y_of(*curve.values[w]));
        draw.AddCircleFilled(here, w == current ? 3.5F : 1.5F, ink);
        if (w == 0 || !curve.values[w - 1]) continue;
        const double step = *curve.values[w] - *curve.values[w - 1];
        if (curve.cyclic && std::abs(step) > 0.5 * range) continue;  // through the ends of the scale
        draw.AddLine({x_of(w - 1), y_of(*curve.values[w - 1])}, here, ink, 1.5F);
    }
    const ImU32 dim = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    draw.AddText({corner.x + 2.0F, corner.y}, dim, short_number(curve.high, 4).c_str());
    draw.AddText({corner.x + 2.0F, far.y - ImGui::GetFontSize()}, dim, short_number(curve.low, 4).c_str());

    const float mouse = ImGui::GetIO().MousePos.x;
    std::size_t nearest = 0;
    for (std::size_t w = 1; w < bands.size(); ++w)
        if (std::abs(x_of(w) - mouse) < std::abs(x_of(nearest) - mouse)) nearest = w;
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s at %s (click to show it)", curve.texts[nearest].c_str(),
                          band_text(bands[nearest]).c_str());
    return clicked ? std::optional(nearest) : std::nullopt;
}

}  // namespace pol
