// SPDX-License-Identifier: Apache-2.0
#include "scene/node_budget.h"

#include <algorithm>
#include <variant>

namespace pol {

namespace {

/// Whether a sample can have more than one branch open at a time for long.
bool trees_branch(const Scene& scene) {
    int solids = 0;
    for (const Object& object : scene.objects) {
        if (std::holds_alternative<Sheet>(object.role)) return true;
        const auto* filling = std::get_if<FilledWith>(&object.role);
        if (filling == nullptr) continue;
        const bool splits = std::any_of(scene.media.begin(), scene.media.end(), [&](const Medium& medium) {
            const UniaxialMedium* crystal = crystal_in(medium.matter);
            return medium.name == filling->medium && crystal != nullptr && crystal->ordinary != crystal->extraordinary;
        });
        if (splits || ++solids > 1) return true;
    }
    return false;
}

}  // namespace

int usual_node_budget(const Scene& scene) {
    if (scene.render.depth) return RenderSettings::whole_tree;
    return scene.render.mode == SampleMode::area && trees_branch(scene) ? 12 : 1000;
}

int node_budget_in_force(const Scene& scene) {
    return scene.render.node_budget.value_or(usual_node_budget(scene));
}

}  // namespace pol
