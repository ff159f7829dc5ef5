// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/status_line.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>
#include <string>

#include "report/number_words.h"
#include "viewer/widgets/theme.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

/// One entry of the line, with what it means.
void entry(const char* name, const ImVec4& color, const std::string& text, const char* meaning) {
    ImGui::SameLine(0.0F, ImGui::GetFontSize());
    ImGui::TextColored(color, "%s", text.c_str());
    name_widget(std::string("status ") + name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", meaning);
}

std::string percent(double share) {
    return std::isfinite(share) ? fmt::format("{:.2g} %", 100.0 * share) : "unknown";
}

const char* why_it_ended(StopReason reason) {
    switch (reason) {
        case StopReason::time:
            return "stopped: time is up";
        case StopReason::error:
            return "finished: error reached";
        case StopReason::truncation:
            return "stopped: needs a smaller residual";
        case StopReason::dark:
            return "stopped: no light to be relative to";
        case StopReason::cancelled:
            return "cancelled";
        case StopReason::memory:
            return "stopped: out of memory, choose a smaller picture";
        default:
            return "finished";
    }
}

void draw_progress(const Document& document, const RenderProgress& progress, const ThemeColors& color) {
    if (document.paused()) {
        entry("progress", color.warning, fmt::format("paused at {:.0f} %", 100.0 * progress.done), "Space goes on.");
    } else if (progress.finished) {
        const bool well = progress.reason != StopReason::truncation && progress.reason != StopReason::dark &&
                          progress.reason != StopReason::cancelled && progress.reason != StopReason::memory;
        entry("progress", well ? color.good : color.warning,
              fmt::format("{} in {}", why_it_ended(progress.reason), duration_text(progress.seconds)),
              "By the first of the rules: samples asked for, time, error.");
    } else {
        std::string text = fmt::format("{:.0f} %", 100.0 * progress.done);
        if (progress.seconds_left) text += ", " + duration_text(*progress.seconds_left) + " left";
        entry("progress", color.text, text, "Share of the samples asked for. Space pauses.");
    }
}

std::string sampling_text(const PictureError& error) {
    if (!error.sampling) return "sampling not estimated";
    if (!error.random_samples) return "no sampling error";
    return "sampling \u00b1" + percent(*error.sampling) + " (estimated, 68 %)";
}

/// What the picture leaves out, and the three figures that say how good it is else.
void draw_errors(const Features& features, const FilmStatus& film, const ThemeColors& color) {
    if (!features.doubts.empty()) {
        std::string all;
        for (const std::string& doubt : features.doubts) all += (all.empty() ? "" : "\n\n") + doubt;
        entry("doubt", color.warning, "doubt: " + features.doubts.front().substr(0, features.doubts.front().find(':')),
              all.c_str());
    }
    if (film.mean_samples <= 0.0) return;
    const bool doubted = !features.doubts.empty();
    entry("bound", color.text, (doubted ? "untraced at most " : "off by at most ") + percent(film.error.truncation),
          doubted ? "How far the picture may be off because light was not traced. What is doubted comes on top."
                  : "How far the picture may be off because light was not traced: a rigorous bound, relative to the "
                    "picture.");
    entry("sampling", color.text, sampling_text(film.error),
          "How far the picture is off because of too few samples: in mode area an estimate from two independent\n"
          "halves of them. In mode point every pixel is the light at its centre; where random paths stand for a part\n"
          "of it, their error is within the bound, but not estimated.");
    entry("samples", color.text, fmt::format("{:.3g} sample{}", film.mean_samples, film.mean_samples == 1.0 ? "" : "s"),
          "Per pixel, on average.");
}

/// What is on screen is not final before the reference is.
void draw_reference(const Session& session, const ThemeColors& color) {
    if (!session.comparison() && session.layout() == CompareLayout::single) return;
    const RenderProgress progress = session.reference()->progress();
    if (progress.finished) return;
    entry("reference", color.warning, fmt::format("reference at {:.0f} %", 100.0 * progress.done),
          "The picture that this one is compared with is still being rendered.");
}

void draw_listening(const Session& session, const ThemeColors& color) {
    const LiveListener* listener = session.listener();
    if (listener == nullptr) return;
    const std::uint64_t connections = listener->counts().connections;
    entry("live", color.text,
          fmt::format("listening on {}, {} connection{} so far", listener->address().text(), connections,
                      connections == 1 ? "" : "s"),
          "Programs that speak the protocol of the viewer tev can send pictures there. File > Listen for pictures ends "
          "it.");
}

/// The file that is being written, and how many wait for it.
void draw_export(const ExportQueue& exports, const ThemeColors& color) {
    const auto running = exports.running();
    if (running.empty()) return;
    std::string text =
        fmt::format("writing {}, {:.0f} %", running.front().path.filename().string(), 100.0 * running.front().progress);
    if (running.size() > 1) text += fmt::format(" (+{})", running.size() - 1);
    entry("export", color.text, text, "Files are written in the background; quitting waits for them.");
}

/// The last message; a click opens the log, where its further lines (address, remedy) are.
void draw_message(const Session& session, Wishes& wishes) {
    const std::vector<LogLine>& lines = session.log().lines();
    if (lines.empty()) return;
    ImGui::SameLine(0.0F, ImGui::GetFontSize());
    std::string text = lines.back().text;
    if (const std::size_t end = text.find('\n'); end != std::string::npos) text = text.substr(0, end) + " ...";
    ImGui::PushStyleColor(ImGuiCol_Text, color_of(session.window().theme, lines.back().severity));
    if (ImGui::Selectable(text.c_str())) wishes.set(&WindowState::log_visible, !session.window().log_visible);
    ImGui::PopStyleColor();
    name_widget("last message");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s\n\nClick: all messages (Ctrl+L)", lines.back().text.c_str());
}

}  // namespace

void draw_status_line(const Session& session, Wishes& wishes) {
    const Document* document = session.current();
    const ThemeColors& color = colors(session.window().theme);
    if (document == nullptr) {
        ImGui::TextUnformatted("Nothing is open");
    } else {
        ImGui::Text("%s%s", document->name().c_str(), document->dirty() ? " *" : "");
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", document->path().c_str());
        if (document->has_scene()) {
            const RenderProgress progress = document->progress();
            draw_progress(*document, progress, color);
            draw_errors(document->plan()->features, progress.film, color);
        } else {
            const char* what = document->growing()        ? "being received"
                               : document->path().empty() ? "picture without a file"
                                                          : "picture from a file";
            entry("progress", color.text, what, "Nothing is traced: there is no scene.");
        }
    }
    draw_reference(session, color);
    draw_listening(session, color);
    draw_export(session.exports(), color);
    draw_message(session, wishes);
}

}  // namespace pol
