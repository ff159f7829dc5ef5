// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/polarimeter_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/units.h"
#include "viewer/pages/readout_text.h"
#include "viewer/widgets/dial.h"
#include "viewer/widgets/ink.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

constexpr double quarter_wave = 0.5 * pi;
constexpr double half_wave = pi;

/// A number in degrees that can be dragged or typed; radians outside.
bool degrees_field(const char* name, double& rad, double speed) {
    double shown = degrees(rad);
    ImGui::SetNextItemWidth(78.0F);
    if (!ImGui::DragScalar(name, ImGuiDataType_Double, &shown, static_cast<float>(speed), nullptr, nullptr,
                           "%.2f\u00b0"))
        return false;
    if (!std::isfinite(shown)) return false;
    rad = radians(shown);
    return true;
}

/// What the user did with one element besides turning it.
struct Click {
    bool remove = false;
    int move = 0;
};

Click draw_element(PolarimeterElement& element) {
    Click click;
    axis_dial("dial", element.axis, 48.0F);
    ImGui::SameLine();
    ImGui::BeginGroup();
    ImGui::Checkbox(element.kind == PolarimeterElementKind::polarizer ? "polarizer" : "retarder", &element.in_beam);
    tooltip("In the beam or out of it.");
    ImGui::SameLine();
    if (ImGui::ArrowButton("up", ImGuiDir_Up)) click.move = -1;
    tooltip("Meets the light one place earlier.");
    ImGui::SameLine(0.0F, 2.0F);
    if (ImGui::ArrowButton("down", ImGuiDir_Down)) click.move = 1;
    tooltip("Meets the light one place later.");
    ImGui::SameLine(0.0F, 2.0F);
    if (ImGui::SmallButton("x")) click.remove = true;
    tooltip("Removes the element.");
    degrees_field("##axis", element.axis, 0.5);
    tooltip(element.kind == PolarimeterElementKind::polarizer
                ? "Transmission axis, from image right, counter-clockwise as the camera sees it. Drag, or double click "
                  "to type."
                : "Fast axis, from image right, counter-clockwise as the camera sees it. Drag, or double click to "
                  "type.");
    if (element.kind == PolarimeterElementKind::retarder) {
        ImGui::SameLine();
        degrees_field("##retardance", element.retardance, 1.0);
        tooltip("Retardance: how far the slow axis falls behind the fast one. 90\u00b0 is a quarter wave.");
        ImGui::SameLine();
        if (ImGui::SmallButton("1/4")) element.retardance = quarter_wave;
        tooltip("Quarter wave.");
        ImGui::SameLine(0.0F, 2.0F);
        if (ImGui::SmallButton("1/2")) element.retardance = half_wave;
        tooltip("Half wave.");
    }
    ImGui::EndGroup();
    return click;
}

void draw_presets(Polarimeter& polarimeter, const Convention& convention) {
    if (ImGui::SmallButton("+ polarizer"))
        polarimeter.elements.push_back({PolarimeterElementKind::polarizer, true, 0.0, 0.0});
    tooltip("Ideal linear polarizer: passes the field along its axis, blocks the rest.");
    ImGui::SameLine();
    if (ImGui::SmallButton("+ retarder"))
        polarimeter.elements.push_back({PolarimeterElementKind::retarder, true, 0.0, quarter_wave});
    tooltip("Ideal retarder: delays the field across its fast axis.");
    ImGui::SameLine();
    if (ImGui::SmallButton("analyzer")) ImGui::OpenPopup("analyzers");
    name_widget("button analyzer");
    tooltip("Replaces the train by the analyzer of one of the six standard states.");
    if (!ImGui::BeginPopup("analyzers")) return;
    for (const StandardAnalyzer& analyzer : standard_analyzers()) {
        if (ImGui::MenuItem(convention.state_name(analyzer.passes).c_str())) polarimeter = analyzer.polarimeter;
    }
    ImGui::Separator();
    if (ImGui::MenuItem("Nothing in the beam")) polarimeter.elements.clear();
    ImGui::EndPopup();
}

void draw_mueller(const Polarimeter& polarimeter, const Convention& convention) {
    const MuellerMatrix<double> train = convention.mueller(polarimeter.mueller());
    if (ImGui::BeginTable("mueller", 4, ImGuiTableFlags_SizingStretchSame)) {
        for (const auto& row : train.m) {
            for (const double entry : row) {
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(fmt::format("{:6.3f}", std::abs(entry) < 5e-4 ? 0.0 : entry).c_str());
            }
        }
        ImGui::EndTable();
    }
    tooltip(("Mueller matrix of the whole train in the camera's frame; " + convention.stokes_text() + ".").c_str());
    if (!ImGui::SmallButton("copy Mueller matrix")) return;
    std::string text;
    for (const auto& row : train.m) text += fmt::format("{} {} {} {}\n", row[0], row[1], row[2], row[3]);
    ImGui::SetClipboardText(text.c_str());
}

}  // namespace

void draw_polarimeter_panel(const Session& session, Wishes& wishes) {
    Polarimeter polarimeter = session.polarimeter();
    draw_presets(polarimeter, session.view().convention);
    std::optional<std::size_t> removed;
    std::optional<std::pair<std::size_t, std::size_t>> swapped;
    for (std::size_t i = 0; i < polarimeter.elements.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const Click click = draw_element(polarimeter.elements[i]);
        ImGui::PopID();
        if (click.remove) removed = i;
        if (click.move < 0 && i > 0) swapped = {i - 1, i};
        if (click.move > 0 && i + 1 < polarimeter.elements.size()) swapped = {i, i + 1};
    }
    if (swapped) std::swap(polarimeter.elements[swapped->first], polarimeter.elements[swapped->second]);
    if (removed) polarimeter.elements.erase(polarimeter.elements.begin() + static_cast<std::ptrdiff_t>(*removed));
    if (polarimeter != session.polarimeter()) wishes.add([polarimeter](Session& s) { s.set_polarimeter(polarimeter); });
    if (polarimeter.empty())
        ImGui::TextDisabled("The light arrives as it is.");
    else
        draw_mueller(polarimeter, session.view().convention);
}

}  // namespace pol
