// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <optional>

#include "cli/messages.h"
#include "core/contract.h"
#include "core/join.h"
#include "core/overloaded.h"
#include "core/result.h"
#include "io/scenes/scene_file.h"
#include "plan/compile.h"
#include "scene/check.h"
#include "scene/setting_table.h"
#include "spectrum/wavelength_grid.h"

namespace pol {

namespace {

/// CLI11 would take -1 for 2^64 - 1, and any larger number, too.
std::string seed_problem(const std::string& text) {
    std::uint64_t value = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status == std::errc() && end == text.data() + text.size()) return {};
    return fmt::format("'{}' is no whole number from 0 to 2^64 - 1", text);
}

template <class Value>
ProgramOption add_setting(ProgramCommand command, const RenderSetting& setting, SceneOptions& options) {
    const std::function<void(const Value&)> take = [&options, key = setting.key](const Value& value) {
        options.given[key] = value;
    };
    return command.add_option_function(option_name(setting), take, std::string(setting.help));
}

std::optional<Error> usage(const RenderSetting& setting, std::string what, std::string hint) {
    return Error{ErrorKind::usage, std::move(what), {}, option_name(setting), std::move(hint)};
}

bool parse_size(std::string_view text, int& width, int& height) {
    const auto parse = [](std::string_view part, int& value) {
        const auto [end, status] = std::from_chars(part.data(), part.data() + part.size(), value);
        return status == std::errc() && end == part.data() + part.size();
    };
    const std::size_t by = text.find('x');
    return by != std::string_view::npos && parse(text.substr(0, by), width) && parse(text.substr(by + 1), height);
}

/// Puts the value in place, or says why there is no such value.
std::optional<Error> set(const RenderSetting& setting, const GivenSetting& given, RenderSettings& settings) {
    using Problem = std::optional<Error>;
    const Problem none;
    return std::visit(Overloaded{
                          [&](const SizeSetting& kind) -> Problem {
                              const auto& text = std::get<std::string>(given);
                              if (parse_size(text, settings.*kind.width, settings.*kind.height)) return none;
                              return usage(setting, fmt::format("'{}' is no picture size", text),
                                           "two numbers from 1 to 65536, for example 800x600");
                          },
                          [&](const WavelengthsSetting& kind) -> Problem {
                              auto wavelengths = parse_wavelengths(std::get<std::string>(given));
                              if (!wavelengths)
                                  return usage(setting, wavelengths.error().what, wavelengths.error().hint);
                              settings.*kind.nm = std::move(wavelengths).value();
                              return none;
                          },
                          [&](const ChoiceSetting& kind) -> Problem {
                              const auto& word = std::get<std::string>(given);
                              const auto found = std::find(kind.words.begin(), kind.words.end(), word);
                              if (found == kind.words.end())
                                  return usage(setting, fmt::format("there is no {} '{}'", setting.key, word),
                                               join(kind.words, " or "));
                              kind.set(settings, static_cast<int>(found - kind.words.begin()));
                              return none;
                          },
                          [&](const WholeSetting& kind) -> Problem {
                              settings.*kind.value = std::get<int>(given);
                              return none;
                          },
                          [&](const LimitSetting& kind) -> Problem {
                              (settings.*kind.impose)(std::get<int>(given));
                              return none;
                          },
                          [&](const UsualSetting& kind) -> Problem {
                              settings.*kind.value = std::get<int>(given);
                              return none;
                          },
                          [&](const UsualNumberSetting& kind) -> Problem {
                              settings.*kind.value = std::get<double>(given);
                              return none;
                          },
                          [&](const SeedSetting& kind) -> Problem {
                              settings.*kind.value = std::get<std::uint64_t>(given);
                              return none;
                          },
                          [&](const FlagSetting& kind) -> Problem {
                              settings.*kind.value = std::get<bool>(given);
                              return none;
                          },
                      },
                      setting.kind);
}

}  // namespace

bool SceneOptions::gives(std::string_view key) const {
    const auto& rows = render_settings();
    POL_EXPECTS(std::any_of(rows.begin(), rows.end(), [&](const RenderSetting& row) { return row.key == key; }));
    return given.count(key) > 0;
}

void add_scene_options(ProgramCommand command, SceneOptions& options) {
    command.add_option("SCENE", options.scene, "Scene file (YAML, see assets/scenes/README.md)")
        .type_name("NAME.yaml")
        .required();
    for (const RenderSetting& setting : render_settings()) {
        std::visit(Overloaded{
                       [&](const SizeSetting& /*kind*/) {
                           add_setting<std::string>(command, setting, options).type_name("WxH");
                       },
                       [&](const WavelengthsSetting& /*kind*/) { add_setting<std::string>(command, setting, options); },
                       [&](const ChoiceSetting& kind) {
                           add_setting<std::string>(command, setting, options).type_name(join(kind.words, "|"));
                       },
                       [&](const WholeSetting& /*kind*/) { add_setting<int>(command, setting, options); },
                       [&](const LimitSetting& /*kind*/) { add_setting<int>(command, setting, options); },
                       [&](const UsualSetting& /*kind*/) { add_setting<int>(command, setting, options); },
                       [&](const UsualNumberSetting& /*kind*/) { add_setting<double>(command, setting, options); },
                       [&](const SeedSetting& /*kind*/) {
                           add_setting<std::uint64_t>(command, setting, options).check(seed_problem);
                       },
                       [&](const FlagSetting& /*kind*/) {
                           command.add_flag_callback(
                               option_name(setting), [&options, key = setting.key] { options.given[key] = true; },
                               std::string(setting.help));
                       },
                   },
                   setting.kind);
    }
}

std::string given_text(const SceneOptions& options) {
    std::string text;
    for (const RenderSetting& setting : render_settings()) {
        const auto found = options.given.find(setting.key);
        if (found == options.given.end()) continue;
        text += " " + option_name(setting);
        std::visit(Overloaded{[](bool /*is_there*/) {}, [&](const auto& value) { text += fmt::format(" {}", value); }},
                   found->second);
    }
    return text;
}

Result<Scene> load_scene_with(const SceneOptions& options) {
    POL_TRY(Scene scene, load_scene(options.scene));
    for (const RenderSetting* setting : settings_in_order_of_effect()) {
        const auto found = options.given.find(setting->key);
        if (found == options.given.end()) continue;
        if (auto problem = set(*setting, found->second, scene.render)) return *problem;
        if (auto problem = setting_problem(*setting, scene.render))
            return *usage(*setting, std::move(problem->what), std::move(problem->hint));
    }
    // New wavelengths may lie outside an index record: who asks for this scene may make a folder for it next.
    if (auto problem = first_problem(scene)) return *problem;
    for (const std::string& unknown : unknown_extinctions(scene)) remark("polariscope: " + printable(unknown) + "\n");
    return scene;
}

void remark_doubts(const Plan& plan) {
    for (const std::string& doubt : plan.features.doubts)
        remark(fmt::format("polariscope: doubt: {}\n", printable(doubt)));
}

Result<LoadedPlan> load_plan(const SceneOptions& options) {
    POL_TRY(auto scene, load_scene_with(options));
    POL_TRY(auto plan, compile(scene));
    return LoadedPlan{std::move(scene), std::move(plan)};
}

}  // namespace pol
