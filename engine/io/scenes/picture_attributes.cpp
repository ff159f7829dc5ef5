// SPDX-License-Identifier: Apache-2.0
#include "io/scenes/picture_attributes.h"

#include <fmt/format.h>

#include <algorithm>
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
            [&](const WholeSetting& kind) { return with_key(s.*kind.value); },
            [&](const LimitSetting& kind) { return s.*kind.value ? with_key(*(s.*kind.value)) : with_key("none"); },
            [&](const UsualSetting& kind) { return with_key((s.*kind.value).value()); },
            [&](const UsualNumberSetting& kind) {
                const std::string_view words = kind.words(s);
                return words.empty() ? with_key((s.*kind.in_force)()) : with_key(words);
            },
            [&](const SeedSetting& kind) { return with_key(s.*kind.value); },
            [&](const FlagSetting& kind) { return std::string(s.*kind.value ? setting.key : ""); },
        },
        setting.kind);
}

}  // namespace

std::map<std::string, std::string> picture_attributes(const Scene& scene, std::span<const std::uint32_t> samples,
                                                      const std::filesystem::path& file) {
    const auto [fewest, most] = std::minmax_element(samples.begin(), samples.end());
    RenderSettings made = scene.render;
    if (!samples.empty()) made.samples_per_pixel = static_cast<int>(*fewest);
    made.node_budget = node_budget_in_force(scene);
    std::string settings;
    for (const RenderSetting& setting : render_settings()) {
        std::string text = attribute_text(setting, made);
        const auto* whole = std::get_if<WholeSetting>(&setting.kind);
        const bool is_samples = whole != nullptr && whole->value == &RenderSettings::samples_per_pixel;
        if (is_samples && !samples.empty() && *fewest != *most) text += fmt::format("..{}", *most);
        if (!text.empty()) settings.append(settings.empty() ? "" : " ").append(text);
    }
    return {{"scene", file.filename().string()}, {"scene_hash", scene_hash(scene)}, {"settings", settings}};
}

}  // namespace pol
