// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/reading_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <string>

#include "report/number_words.h"
#include "viewer/widgets/question.h"
#include "viewer/widgets/theme.h"

namespace pol {

std::string reading_text(const PictureReading& reading) {
    const PictureHeader& header = reading.header();
    std::string text = fmt::format(
        "Opening {}, {} x {}, {} band{}: {:.0f} %", reading.source().path().filename().string(), header.width,
        header.height, header.bands.size(), header.bands.size() == 1 ? "" : "s", 100.0 * reading.progress());
    if (const auto left = reading.seconds_left()) text += ", " + duration_text(*left) + " left";
    return text;
}

void draw_reading_panel(const Session& session, Wishes& wishes, Frame& frame) {
    const auto readings = session.readings();
    if (readings.empty()) return;
    // The window sleeps while nothing happens, and a share that grows is no event.
    constexpr double look_again_s = 0.1;
    frame.again(look_again_s);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * display.x, 0.9F * display.y}, ImGuiCond_Always, {0.5F, 1.0F});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, colors(session.window().theme).popup);
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_NoFocusOnAppearing;
    if (ImGui::Begin("Opening", nullptr, flags)) {
        log_window();
        for (const PictureReading* reading : readings) {
            ImGui::PushID(reading);
            ImGui::TextUnformatted(reading_text(*reading).c_str());
            ImGui::SameLine();
            if (button("Cancel")) wishes.add([reading](Session& s) { s.cancel_reading(reading); });
            ImGui::PopID();
        }
    }
    ImGui::End();
    ImGui::PopStyleColor();
}

}  // namespace pol
