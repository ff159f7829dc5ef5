// SPDX-License-Identifier: Apache-2.0
#include "io/scenes/picture_attributes.h"

#include <fmt/format.h>

#include <variant>

#include "core/overloaded.h"
#include "io/scenes/scene_hash.h"
#include "scene/node_budget.h"
#include "scene/setting_table.h"

namespace pol {

namespace {

/// "spp=16"; empty: the picture says so itself, or there is nothing to say.
std::string attribute_text(const RenderSetting& setting, const RenderSettings& s) {
    const auto with_key = [&](const auto& value) { return fmt::format("{}={}", setting.key, value); };
    return std::visit(
        Overloaded{
            [](const SizeSetting& /*kind*/) { return std::string(); },
            [](const WavelengthsSetting& /*kind*/) { return std::string(); },
            [&](const ChoiceSetting& kind) { return with_key(kind.words[static_cast<std::size_t>(kind.get(s))]); },
            [&](const NumberSetting& kind) { return with_key(s.*kind.value); },
            [&](const WholeSetting& kind) { return with_key(s.*kind.value); },
            [&](const LimitSetting& kind) { return s.*kind.value ? with_key(*(s.*kind.value)) : with_key("none"); },
            [&](const UsualSetting& kind) { return with_key((s.*kind.value).value()); },
            [&](const SeedSetting& kind) { return with_key(s.*kind.value); },
            [&](const FlagSetting& kind) { return std::string(s.*kind.value ? setting.key : ""); },
        },
        setting.kind);
}

}  // namespace

std::map<std::string, std::string> picture_attributes(const Scene& scene, int samples_per_pixel,
                                                      const std::filesystem::path& file) {
    RenderSettings made = scene.render;
    made.samples_per_pixel = samples_per_pixel;
    made.node_budget = node_budget_in_force(scene);
    std::string settings;
    for (const RenderSetting& setting : render_settings()) {
        const std::string text = attribute_text(setting, made);
        if (!text.empty()) settings.append(settings.empty() ? "" : " ").append(text);
    }
    return {{"scene", file.filename().string()}, {"scene_hash", scene_hash(scene)}, {"settings", settings}};
}

}  // namespace pol
