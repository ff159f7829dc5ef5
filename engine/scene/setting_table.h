// SPDX-License-Identifier: Apache-2.0
// The settings of a picture, a row each. Scene files, the command line, the attributes of pictures, reports and the
// window read the rows: a setting is a member of RenderSettings, a row here, a line in assets/scenes/README.md, and
// what the kernel makes of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/result.h"
#include "scene/scene.h"

namespace pol {

/// Width and height in pixels.
struct SizeSetting {
    int RenderSettings::*width;
    int RenderSettings::*height;
};

/// Vacuum wavelengths in nm.
struct WavelengthsSetting {
    std::vector<double> RenderSettings::*nm;
};

/// One of a few words; get() and set() count them from 0.
struct ChoiceSetting {
    std::vector<std::string_view> words;
    int (*get)(const RenderSettings&);
    void (*set)(RenderSettings&, int);
};

struct WholeSetting {
    int RenderSettings::*value;
    int least;
    int most;
    double per_point;  ///< how much one point of the mouse changes in the window
};

/// A whole number that there may be. With it, and without it again, other settings change: they are set after it.
struct LimitSetting {
    std::optional<int> RenderSettings::*value;
    void (RenderSettings::*impose)(int limit);
    void (RenderSettings::*lift)();
    int least;
    int most;
    int usual;
};

/// A whole number; without it, one that follows from the scene is in force. Plans have it set.
struct UsualSetting {
    std::optional<int> RenderSettings::*value;
    int (*in_force)(const Scene&);
    int least;
    int most;
    double per_point;
};

/// The same of any number. In words, where it is more than a number; empty: it is not.
struct UsualNumberSetting {
    std::optional<double> RenderSettings::*value;
    double (RenderSettings::*in_force)() const;
    std::string_view (*words)(const RenderSettings&);
    double least;
    double most;
    double per_point;
};

/// Any number of 64 bit.
struct SeedSetting {
    std::uint64_t RenderSettings::*value;
};

/// Off, and then not mentioned, or on.
struct FlagSetting {
    bool RenderSettings::*value;
};

using SettingKind = std::variant<SizeSetting, WavelengthsSetting, ChoiceSetting, WholeSetting, LimitSetting,
                                 UsualSetting, UsualNumberSetting, SeedSetting, FlagSetting>;

struct RenderSetting {
    std::string_view key;        ///< in scene files and in the attribute `settings` of pictures
    std::string_view statistic;  ///< in the report of --stats; a size is width and height there
    std::string_view label;      ///< in the window; a size is width and height there
    std::string_view help;       ///< a sentence for command line and window
    std::string_view hint;       ///< a value that makes sense
    SettingKind kind;
};

/// All settings, in the order in which they are written.
const std::vector<RenderSetting>& render_settings();

/// The same, but first those that change others.
const std::vector<const RenderSetting*>& settings_in_order_of_effect();

/// "--node-budget" for node_budget.
std::string option_name(const RenderSetting& setting);

/// What is wrong with the value that `settings` has there: what and hint.
std::optional<Error> setting_problem(const RenderSetting& setting, const RenderSettings& settings);

}  // namespace pol
