// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <string_view>

#include "cli/messages.h"
#include "io/scenes/scene_file.h"
#include "plan/compile.h"
#include "scene/check.h"
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

}  // namespace

void add_scene_options(CLI::App& command, SceneOptions& options) {
    command.add_option("SCENE", options.scene, "Scene file (YAML, see assets/scenes/README.md)")
        ->type_name("NAME.yaml")
        ->required();
    command.add_option("--size", options.size, "Picture size in pixels, for example 800x600")->type_name("WxH");
    command.add_option("--spp", options.samples, "Samples per pixel");
    command
        .add_option("--mode", options.mode,
                    "point: one ray through the pixel centre; area: quasi-random over the pixel")
        ->type_name("point|area");
    command.add_option("--residual", options.residual,
                       "Largest share of a pixel that may stay untraced, for example 1e-3");
    command.add_option("--depth", options.depth,
                       "Cut the tree after this many interfaces (the paper: 9) instead of by energy");
    command.add_option("--node-budget", options.node_budget,
                       "Branches to follow before one random path stands for the rest");
    command.add_option("--wavelengths", options.wavelengths,
                       "Vacuum wavelengths in nm: 580, 450,550,650 or 380:780:20");
    command.add_option("--seed", options.seed, "Seed of the random numbers")->check(seed_problem);
    command.add_flag("--unpolarized", options.unpolarized,
                     "Forget polarization at every surface: what a renderer without it would show");
}

namespace {

Error usage(const char* field, std::string what, std::string hint) {
    return {ErrorKind::usage, std::move(what), {}, field, std::move(hint)};
}

Result<Done> set_size(std::string_view text, RenderSettings& settings) {
    constexpr int largest_side = 65536;
    const std::size_t by = text.find('x');
    const auto parse = [](std::string_view part, int& value) {
        const auto [end, status] = std::from_chars(part.data(), part.data() + part.size(), value);
        return status == std::errc() && end == part.data() + part.size() && value > 0 && value <= largest_side;
    };
    if (by == std::string_view::npos || !parse(text.substr(0, by), settings.width) ||
        !parse(text.substr(by + 1), settings.height))
        return usage("--size", fmt::format("'{}' is no picture size", text),
                     "two numbers from 1 to 65536, for example 800x600");
    return Done{};
}

/// Two gigapixels would already need 100 GB.
constexpr std::int64_t most_pixels = std::int64_t{1} << 31U;

}  // namespace

Result<Scene> load_scene_with(const SceneOptions& options) {
    auto loaded = load_scene(options.scene);
    if (!loaded) return loaded.error();
    Scene scene = std::move(loaded).value();
    RenderSettings& settings = scene.render;
    if (options.size) {
        if (auto done = set_size(*options.size, settings); !done) return done.error();
    }
    if (std::int64_t{settings.width} * settings.height > most_pixels)
        return usage("--size", fmt::format("{}x{} is more than 2^31 pixels", settings.width, settings.height),
                     "choose a smaller picture");
    if (options.samples) {
        if (*options.samples < 1)
            return usage("--spp", fmt::format("{} samples make no picture", *options.samples), "at least 1");
        settings.samples_per_pixel = *options.samples;
    }
    if (options.mode) {
        if (*options.mode != "point" && *options.mode != "area")
            return usage("--mode", fmt::format("there is no mode '{}'", *options.mode), "point or area");
        settings.mode = *options.mode == "area" ? SampleMode::area : SampleMode::point;
    }
    if (options.depth) {
        if (*options.depth < 0) return usage("--depth", fmt::format("{} is no depth", *options.depth), "0 or more");
        settings.cut_by_depth_alone(*options.depth);
    }
    if (options.residual) {
        if (!(*options.residual >= 0.0) || *options.residual > 1.0)
            return usage("--residual", fmt::format("{} is no share of a pixel", *options.residual),
                         "0 to 1, for example 1e-3");
        settings.residual = *options.residual;
    }
    if (options.node_budget) {
        if (*options.node_budget < 1)
            return usage("--node-budget", fmt::format("{} branches make no tree", *options.node_budget), "at least 1");
        settings.node_budget = *options.node_budget;
    }
    if (options.wavelengths) {
        auto wavelengths = parse_wavelengths(*options.wavelengths);
        if (!wavelengths) return usage("--wavelengths", wavelengths.error().what, wavelengths.error().hint);
        settings.wavelengths_nm = std::move(wavelengths).value();
    }
    if (options.seed) settings.seed = *options.seed;
    if (options.unpolarized) settings.unpolarized = true;
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
    auto scene = load_scene_with(options);
    if (!scene) return scene.error();
    auto plan = compile(scene.value());
    if (!plan) return plan.error();
    return LoadedPlan{std::move(scene).value(), std::move(plan).value()};
}

}  // namespace pol
