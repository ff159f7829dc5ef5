// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/status_line.h"

#include <imgui.h>

#include "viewer/widgets/theme.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

void separated() {
    ImGui::SameLine(0.0F, ImGui::GetFontSize());
}

void draw_progress(const Document& document, const ThemeColors& color) {
    const RenderProgress progress = document.progress();
    if (!document.has_scene())
        ImGui::TextUnformatted("picture from a file");
    else if (document.paused())
        ImGui::TextColored(color.warning, "paused at %.0f %%", 100.0 * progress.done);
    else if (progress.finished)
        ImGui::TextColored(color.good, "finished");
    else
        ImGui::Text("rendering %.0f %%", 100.0 * progress.done);
}

/// The last message; a click opens the log. `first_line`: errors have their address and remedy below.
void draw_message(Session& session) {
    const std::vector<LogLine>& lines = session.log.lines();
    if (lines.empty()) return;
    separated();
    std::string text = lines.back().text;
    if (const std::size_t end = text.find('\n'); end != std::string::npos) text = text.substr(0, end) + " ...";
    ImGui::PushStyleColor(ImGuiCol_Text, color_of(session.window.theme, lines.back().severity));
    if (ImGui::Selectable(text.c_str())) session.window.log_visible = !session.window.log_visible;
    ImGui::PopStyleColor();
    name_widget("last message");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s\n\nClick: all messages (Ctrl+L)", lines.back().text.c_str());
}

}  // namespace

void draw_status_line(Session& session) {
    const Document* document = session.current();
    if (document == nullptr) {
        ImGui::TextUnformatted("Nothing is open");
    } else {
        ImGui::Text("%s%s", document->name().c_str(), document->dirty() ? " *" : "");
        separated();
        draw_progress(*document, colors(session.window.theme));
    }
    draw_message(session);
}

}  // namespace pol
