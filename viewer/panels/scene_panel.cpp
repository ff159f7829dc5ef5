// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/scene_panel.h"

#include <imgui.h>

#include <optional>
#include <string>

#include "viewer/commands/command_actions.h"
#include "viewer/panels/picture_header.h"
#include "viewer/panels/scene_sections.h"
#include "viewer/widgets/section.h"
#include "viewer/widgets/theme.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

bool button(const char* name, bool enabled, const std::string& hint) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(name);
    ImGui::EndDisabled();
    name_widget(std::string("button ") + name);
    if (ImGui::IsItemHovered() && !hint.empty()) ImGui::SetTooltip("%s", hint.c_str());
    return pressed;
}

void draw_file(const Session& session, Wishes& wishes, const Document& document) {
    const EditHistory& history = document.history();
    ImGui::TextWrapped("%s%s", document.name().c_str(), document.dirty() ? "  (edited)" : "");
    if (button("Undo", history.can_undo(), history.can_undo() ? "Takes back: " + history.undo_label() : ""))
        wishes.add(&Session::undo);
    ImGui::SameLine();
    if (button("Redo", history.can_redo(), history.can_redo() ? "Does again: " + history.redo_label() : ""))
        wishes.add(&Session::redo);
    ImGui::SameLine();
    if (button("Reload", !document.path().empty(), "Reads the file again (F5).")) wishes.add(&Session::reload);
    ImGui::SameLine();
    const bool can_save = document.dirty() || document.path().empty();
    if (button("Save", can_save, "Writes the scene as YAML (Ctrl+Shift+S).")) wishes.add(action::save_scene);
    if (const auto& problem = document.problem()) {
        ImGui::PushStyleColor(ImGuiCol_Text, colors(session.window().theme).error);
        ImGui::TextWrapped("%s", to_string(*problem).c_str());
        ImGui::PopStyleColor();
    }
}

/// A rule that is off until it is checked. True if it was changed.
bool draw_rule(const char* name, std::optional<double>& rule, double usual, const char* hint) {
    ImGui::PushID(name);
    bool on = rule.has_value();
    bool changed = ImGui::Checkbox("##on", &on);
    name_widget(std::string("rule ") + name);
    if (changed) rule = on ? std::optional(usual) : std::nullopt;
    ImGui::SameLine();
    if (rule) {
        double value = *rule;
        ImGui::InputDouble(name, &value, 0.0, 0.0, "%.4g");
        if (ImGui::IsItemDeactivatedAfterEdit() && value > 0.0) {
            rule = value;
            changed = true;
        }
    } else {
        ImGui::TextUnformatted(name);
    }
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", hint);
    ImGui::PopID();
    return changed;
}

void draw_stop_rules(const Document& document, Wishes& wishes) {
    StopRules rules = document.stop_rules();
    const bool time =
        draw_rule("seconds", rules.seconds, 60.0, "Stops after this time. A change starts the render over.");
    const bool error = draw_rule("error", rules.error, 0.01,
                                 "Stops when truncation (bound) and sampling (95 %) have together fallen to this part "
                                 "of the picture. A change starts the render over.");
    if (time || error) wishes.add([of = &document, rules](Session& s) { s.set_stop_rules(of, rules); });
}

/// What the plan needs, and what it leaves out with the reason.
void draw_plan(const Plan& plan) {
    ImGui::TextWrapped("kernel: %s", plan.features.kernel.c_str());
    if (!ImGui::BeginTable("features", 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("name");
    ImGui::TableSetupColumn("reason", ImGuiTableColumnFlags_WidthStretch);
    for (const Feature& feature : plan.features.list) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        if (feature.needed)
            ImGui::TextUnformatted(feature.name.c_str());
        else
            ImGui::TextDisabled("no %s", feature.name.c_str());
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", feature.reason.c_str());
    }
    ImGui::EndTable();
}

}  // namespace

void ScenePanel::draw(const Session& session, Wishes& wishes) {
    const Document* document = session.current();
    if (document == nullptr) {
        ImGui::TextDisabled("Nothing is open");
        return;
    }
    if (!document->has_scene()) {
        draw_picture_header(session, wishes);
        return;
    }
    draw_file(session, wishes, *document);
    EditForm form(session, wishes);
    ImGui::PushItemWidth(0.5F * ImGui::GetContentRegionAvail().x);
    section("Camera", [&] { draw_camera_section(form); });
    section("Media", [&] { draw_media_section(form); });
    section("Lamps", [&] { draw_light_section(form); });
    section("Render", [&] { draw_render_section(form, wavelengths_); });
    section("Stop", [&] { draw_stop_rules(*document, wishes); });
    ImGui::PopItemWidth();
    section("Plan", [&] { draw_plan(*document->plan()); });
}

}  // namespace pol
