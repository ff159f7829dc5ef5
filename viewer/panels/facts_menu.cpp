// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/facts_menu.h"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

#include "verify/facts/fact.h"
#include "viewer/widgets/ink.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

/// Facts live as long as the program.
void open(Wishes& wishes, const verify::Fact& fact, std::size_t view) {
    wishes.add([&fact, view](Session& session) { session.open_fact(fact, view); });
}

void draw_views(Wishes& wishes, const verify::Fact& fact) {
    for (std::size_t view = 0; view < fact.views.size(); ++view) {
        if (ImGui::MenuItem(fact.views[view].name.c_str())) open(wishes, fact, view);
        name_widget("fact " + fact.id + " view " + std::to_string(view + 1));
        tooltip(fact.source.c_str());
    }
}

void draw_fact(Wishes& wishes, const verify::Fact& fact) {
    const std::string title = fact.id + "  " + fact.sentence;
    if (fact.views.size() > 1) {
        const bool open = ImGui::BeginMenu(title.c_str());
        name_widget("fact " + fact.id);
        if (!open) return;
        draw_views(wishes, fact);
        ImGui::EndMenu();
        return;
    }
    if (ImGui::MenuItem(title.c_str(), nullptr, false, !fact.views.empty())) open(wishes, fact, 0);
    name_widget("fact " + fact.id);
    tooltip((fact.not_modelled.empty() ? fact.source : "Not modelled: " + fact.not_modelled).c_str());
}

}  // namespace

void draw_facts_menu(Wishes& wishes) {
    constexpr std::size_t per_group = 10;
    const bool facts_open = ImGui::BeginMenu("Facts");
    name_widget("menu Facts");
    if (!facts_open) return;
    const std::vector<verify::Fact>& facts = verify::facts();
    for (std::size_t first = 0; first < facts.size(); first += per_group) {
        const std::size_t end = std::min(first + per_group, facts.size());
        const bool open = ImGui::BeginMenu((facts[first].id + " to " + facts[end - 1].id).c_str());
        name_widget("facts from " + facts[first].id);
        if (!open) continue;
        for (std::size_t i = first; i < end; ++i) draw_fact(wishes, facts[i]);
        ImGui::EndMenu();
    }
    ImGui::EndMenu();
}

}  // namespace pol
