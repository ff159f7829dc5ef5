// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/maps_panel.h"

#include <imgui.h>

#include <optional>
#include <string>

#include "viewer/commands/commands.h"
#include "viewer/pages/readout_text.h"
#include "viewer/widgets/ink.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

/// Which picture the others are compared with, and whether the difference is shown.
void draw_comparison(const Session& session, Wishes& wishes) {
    const Document* reference = session.reference();
    const auto possible = session.compare();
    for (const QuantityInfo& quantity : pair_quantities()) {
        const bool is_it = session.view().quantity == quantity.quantity;
        if (!possible) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        if (ImGui::Selectable(std::string(quantity.title_in_list()).c_str(), is_it))
            wishes.add([which = quantity.quantity](Session& s) { s.show(which); });
        if (!possible) ImGui::PopStyleColor();
        name_widget("map " + std::string(quantity.name));
        const std::string lacks = possible ? "" : "\nIt needs a reference: " + possible.error().what;
        tooltip((std::string(quantity.definition) + lacks).c_str());
    }
    bool is_shown = session.comparison().has_value();
    if (!possible) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.5F * ImGui::GetStyle().Alpha);
    if (ImGui::Checkbox("minus the reference", &is_shown)) wishes.add(&Session::toggle_difference);
    if (!possible) ImGui::PopStyleVar();
    name_widget("minus the reference");
    tooltip(possible ? "The shown map minus that of the reference picture (X)."
                     : (possible.error().what + "; " + possible.error().hint).c_str());
    if (ImGui::SmallButton("use this")) wishes.add(&Session::set_reference);
    name_widget("use as reference");
    tooltip("Makes the picture on screen the reference (Shift+X).");
    ImGui::SameLine();
    ImGui::TextDisabled("%s", reference != nullptr ? reference->name().c_str() : "no reference yet");
    if (reference != nullptr) tooltip(reference->name().c_str());
}

}  // namespace

void MapsPanel::draw(const Session& session, Wishes& wishes) {
    const float key_column = ImGui::CalcTextSize("Shift+D").x;
    std::optional<ShownPicture> shown;
    if (session.current() != nullptr) shown.emplace(session.shown_picture());
    const std::size_t band = session.view().band;
    MapGroup group = quantities().front().group;
    for (const QuantityInfo& quantity : quantities()) {
        if (quantity.group != group) ImGui::Separator();
        group = quantity.group;
        const std::string title(quantity.title_in_list());
        const KeyChord chord = chord_of(quantity.quantity);
        const bool is_measured = !shown || shown->measures(quantity.quantity, band);
        // It can still be chosen: the picture then says so, and another band may have it.
        if (!is_measured) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        if (ImGui::Selectable(title.c_str(), session.view().quantity == quantity.quantity))
            wishes.set(&ViewSettings::quantity, quantity.quantity);
        if (!is_measured) ImGui::PopStyleColor();
        name_widget("map " + std::string(quantity.name));
        std::string definition = session.view().convention.definition(quantity.quantity);
        if (!is_measured) {
            const std::string missing = missing_text(quantity.needs, shown->known(band));
            definition += "\nThis picture does not have it: " +
                          (missing.empty() ? std::string("it does not tell what was not traced") : missing);
        }
        tooltip(definition.c_str());
        if (chord.key == Key::none) continue;
        ImGui::SameLine(ImGui::GetContentRegionMax().x - key_column);
        ImGui::TextDisabled("%s", name_of(chord).c_str());
    }
    ImGui::Separator();
    draw_comparison(session, wishes);
}

}  // namespace pol
