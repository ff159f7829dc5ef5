// SPDX-License-Identifier: Apache-2.0
// The tables of settings and of matter: sound in themselves, and told to the reader of assets/scenes/README.md.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "core/overloaded.h"
#include "scene/medium_fields.h"
#include "scene/setting_table.h"

namespace pol {
namespace {

/// A section of the README from its heading to the next one of that level.
std::string section_of_readme(const std::string& heading) {
    std::ifstream stream(std::string(POL_ASSETS) + "/scenes/README.md");
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    const std::size_t begin = text.find("\n## " + heading + "\n");
    EXPECT_NE(begin, std::string::npos) << heading;
    return text.substr(begin, text.find("\n## ", begin + 1) - begin);
}

TEST(SettingTable, EverySettingHasALineInTheReadme) {
    const std::string section = section_of_readme("render");
    for (const RenderSetting& setting : render_settings())
        EXPECT_NE(section.find("| `" + std::string(setting.key) + "` |"), std::string::npos) << setting.key;
}

TEST(SettingTable, NamesAreThereAndDifferent) {
    std::set<std::string> names;
    for (const RenderSetting& setting : render_settings()) {
        EXPECT_FALSE(setting.help.empty()) << setting.key;
        EXPECT_TRUE(names.insert(option_name(setting)).second) << setting.key;
        const bool is_size = std::holds_alternative<SizeSetting>(setting.kind);
        EXPECT_EQ(setting.label.empty(), is_size) << setting.key;
        EXPECT_EQ(setting.statistic.empty(), is_size) << setting.key;
    }
    EXPECT_EQ(names.count("--node-budget"), 1U);
}

TEST(SettingTable, TheDefaultsAreAllowed) {
    for (const RenderSetting& setting : render_settings())
        EXPECT_FALSE(setting_problem(setting, RenderSettings{})) << setting.key;
}

TEST(SettingTable, LimitsBelongToWhatIsAllowedAndWhatIsBeyondComesWithAHint) {
    for (const RenderSetting& setting : render_settings()) {
        SCOPED_TRACE(setting.key);
        const auto try_limits = [&](const auto& kind, auto step) {
            RenderSettings settings;
            for (const auto allowed : {kind.least, kind.most}) {
                settings.*kind.value = allowed;
                EXPECT_FALSE(setting_problem(setting, settings));
            }
            for (const auto beyond : {kind.least - step, kind.most + step}) {
                settings.*kind.value = beyond;
                const auto problem = setting_problem(setting, settings);
                ASSERT_TRUE(problem);
                EXPECT_NE(problem->what.find("must lie between "), std::string::npos) << problem->what;
                EXPECT_FALSE(problem->hint.empty());
            }
        };
        std::visit(Overloaded{
                       [](const SizeSetting&) {},
                       [](const WavelengthsSetting&) {},
                       [](const ChoiceSetting&) {},
                       [&](const WholeSetting& kind) { try_limits(kind, 1); },
                       [&](const LimitSetting& kind) { try_limits(kind, 1); },
                       [&](const UsualSetting& kind) { try_limits(kind, 1); },
                       [&](const UsualNumberSetting& kind) { try_limits(kind, 1e-9); },
                       [](const SeedSetting&) {},
                       [](const FlagSetting&) {},
                   },
                   setting.kind);
    }
}

TEST(SettingTable, SaysInWordsWhatIsMoreThanANumber) {
    const auto words = [](const RenderSettings& settings) {
        for (const RenderSetting& setting : render_settings())
            if (const auto* kind = std::get_if<UsualNumberSetting>(&setting.kind)) return kind->words(settings);
        return std::string_view("no such setting");
    };
    RenderSettings settings;
    EXPECT_EQ(words(settings), "until-determined");
    settings.residual = 1e-3;
    EXPECT_EQ(words(settings), "");
    settings.residual.reset();
    settings.mode = SampleMode::area;
    EXPECT_EQ(words(settings), "");
}

TEST(SettingTable, WhatChangesOtherSettingsIsSetBeforeThem) {
    ASSERT_EQ(settings_in_order_of_effect().size(), render_settings().size());
    EXPECT_EQ(settings_in_order_of_effect().front()->key, "depth");
    EXPECT_EQ(std::set<const RenderSetting*>(settings_in_order_of_effect().begin(), settings_in_order_of_effect().end())
                  .size(),
              render_settings().size());
}

TEST(MediumFields, EveryPropertyOfMatterStandsInTheReadme) {
    const std::string section = section_of_readme("media");
    int kinds = 0;
    for_each_kind([&](const auto& kind) {
        ++kinds;
        for_each_field(kind, [&](const auto& row, const auto& /*value*/) {
            EXPECT_NE(section.find("`" + std::string(row.key) + "`"), std::string::npos) << row.key;
        });
    });
    EXPECT_EQ(kinds, 3);
}

TEST(MediumFields, EveryKindOfMatterHasAKeyThatNamesItAndNoOtherKindHas) {
    std::set<std::string> keys;
    for_each_kind([&](const auto& kind) {
        const std::size_t before = keys.size();
        for_each_field(kind, [&](const auto& row, const auto& /*value*/) {
            if (row.presence != Presence::required) return;
            EXPECT_TRUE(keys.insert(std::string(row.key)).second) << row.key;
        });
        EXPECT_GT(keys.size(), before);
    });
}

}  // namespace
}  // namespace pol
