// SPDX-License-Identifier: Apache-2.0
#include "scene/setting_table.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "core/number_text.h"
#include "core/overloaded.h"
#include "scene/check.h"
#include "scene/node_budget.h"
#include "spectrum/wavelength_grid.h"

namespace pol {

namespace {

template <auto member>
ChoiceSetting choice_of(std::vector<std::string_view> words) {
    return {std::move(words), [](const RenderSettings& settings) { return static_cast<int>(settings.*member); },
            [](RenderSettings& settings, int index) {
                using Enum = std::remove_reference_t<decltype(settings.*member)>;
                settings.*member = static_cast<Enum>(index);
            }};
}

std::string_view residual_words(const RenderSettings& settings) {
    return settings.until_determined() ? "until-determined" : "";
}

std::optional<Error> problem(std::string what, std::string_view hint) {
    return Error{ErrorKind::input, std::move(what), {}, {}, std::string(hint)};
}

std::optional<Error> limits_problem(double value, double least, double most, std::string_view hint) {
    if (value >= least && value <= most) return std::nullopt;
    const auto text = [](double number) {
        const auto whole = static_cast<std::int64_t>(std::abs(number) < 1e15 ? number : 0.0);
        return static_cast<double>(whole) == number ? std::to_string(whole) : number_text(number);
    };
    return problem("must lie between " + text(least) + " and " + text(most) + ", not " + text(value), hint);
}

}  // namespace

const std::vector<RenderSetting>& render_settings() {
    static const std::vector<RenderSetting> rows{
        {"size", "", "", "Picture size in pixels, for example 800x600", "512 by 512 is usual",
         SizeSetting{&RenderSettings::width, &RenderSettings::height}},
        {"wavelengths", "wavelengths_nm", "wavelengths", "Vacuum wavelengths in nm: 580, 450,550,650 or 380:780:20", "",
         WavelengthsSetting{&RenderSettings::wavelengths_nm}},
        {"mode", "mode", "mode", "point: one ray through the pixel centre; area: quasi-random over the pixel",
         "point or area", choice_of<&RenderSettings::mode>({"point", "area"})},
        {"spp", "spp_wanted", "samples per pixel", "Samples per pixel", "1 to 64 is usual",
         WholeSetting{&RenderSettings::samples_per_pixel, 1, 1 << 24, 0.2}},
        {"residual", "residual_target", "residual",
         "Largest share of a pixel that may stay untraced, for example 1e-3; without it mode point goes on until the "
         "maps are determined",
         "1e-3 means that at most 0.1 % of a pixel stays untraced; leave it out to go on until the maps are determined",
         UsualNumberSetting{&RenderSettings::residual, &RenderSettings::residual_in_force, residual_words, 0.0, 1.0,
                            1e-5}},
        {"depth", "depth_limit", "depth", "Cut the tree after this many interfaces (the paper: 9) instead of by energy",
         "the paper used 9; leave it out to cut by energy alone",
         LimitSetting{&RenderSettings::depth, &RenderSettings::cut_by_depth_alone, &RenderSettings::cut_by_energy, 0,
                      1000000, 9}},
        {"node_budget", "node_budget", "branch budget", "Branches to follow before one random path stands for the rest",
         "leave it out for the default: 1000, or 12 in mode area where trees branch",
         UsualSetting{&RenderSettings::node_budget, &node_budget_in_force, 1, 1 << 30, 1.0}},
        {"seed", "seed", "seed", "Seed of the random numbers", "", SeedSetting{&RenderSettings::seed}},
        {"unpolarized", "unpolarized", "forget polarization",
         "Forget polarization at every surface: what a renderer without it would show", "",
         FlagSetting{&RenderSettings::unpolarized}},
    };
    return rows;
}

const std::vector<const RenderSetting*>& settings_in_order_of_effect() {
    static const std::vector<const RenderSetting*> order = [] {
        std::vector<const RenderSetting*> pointers;
        for (const RenderSetting& setting : render_settings()) pointers.push_back(&setting);
        std::stable_partition(pointers.begin(), pointers.end(),
                              [](const RenderSetting* s) { return std::holds_alternative<LimitSetting>(s->kind); });
        return pointers;
    }();
    return order;
}

std::string option_name(const RenderSetting& setting) {
    std::string name = "--" + std::string(setting.key);
    std::replace(name.begin(), name.end(), '_', '-');
    return name;
}

std::optional<Error> setting_problem(const RenderSetting& setting, const RenderSettings& settings) {
    using Problem = std::optional<Error>;
    return std::visit(Overloaded{
                          [&](const SizeSetting& kind) -> Problem {
                              const int width = settings.*kind.width;
                              const int height = settings.*kind.height;
                              if (width < 1 || height < 1 || width > max_picture_side || height > max_picture_side)
                                  return problem("each side must have 1 to 65536 pixels", setting.hint);
                              if (static_cast<double>(width) * static_cast<double>(height) > max_picture_pixels)
                                  return problem("the picture has more than 2^31 pixels", setting.hint);
                              return std::nullopt;
                          },
                          [&](const WavelengthsSetting& kind) -> Problem {
                              const auto wavelengths = checked_wavelengths(settings.*kind.nm);
                              return wavelengths ? std::nullopt
                                                 : problem(wavelengths.error().what, wavelengths.error().hint);
                          },
                          [&](const ChoiceSetting& /*kind*/) -> Problem { return std::nullopt; },
                          [&](const WholeSetting& kind) {
                              return limits_problem(settings.*kind.value, kind.least, kind.most, setting.hint);
                          },
                          [&](const LimitSetting& kind) -> Problem {
                              const std::optional<int>& value = settings.*kind.value;
                              return value ? limits_problem(*value, kind.least, kind.most, setting.hint) : std::nullopt;
                          },
                          [&](const UsualSetting& kind) -> Problem {
                              const std::optional<int>& value = settings.*kind.value;
                              return value ? limits_problem(*value, kind.least, kind.most, setting.hint) : std::nullopt;
                          },
                          [&](const UsualNumberSetting& kind) {
                              return limits_problem((settings.*kind.in_force)(), kind.least, kind.most, setting.hint);
                          },
                          [&](const SeedSetting& /*kind*/) -> Problem { return std::nullopt; },
                          [&](const FlagSetting& /*kind*/) -> Problem { return std::nullopt; },
                      },
                      setting.kind);
}

}  // namespace pol
