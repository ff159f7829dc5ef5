// SPDX-License-Identifier: Apache-2.0
#include "cli/explain_command.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "cli/explain_report.h"
#include "cli/report.h"
#include "cli/scene_options.h"
#include "tracer/explain.h"

namespace pol {

namespace {

struct ExplainRequest {
    SceneOptions scene;
    std::vector<int> pixel;
    int sample = 0;
    std::optional<double> wavelength_nm;
    double least_share = 1e-3;
    bool json = false;
};

/// The plan's wavelength that was asked for; without one 580 nm, the paper's, or the first.
Result<int> wavelength_index(const Plan& plan, std::optional<double> asked_nm) {
    constexpr double default_nm = 580.0;
    constexpr double same_nm = 1e-6;
    for (std::size_t w = 0; w < plan.wavelengths_nm.size(); ++w)
        if (std::abs(plan.wavelengths_nm[w] - asked_nm.value_or(default_nm)) <= same_nm) return static_cast<int>(w);
    if (!asked_nm) return 0;
    return Error{ErrorKind::usage,
                 fmt::format("{} nm is not among the scene's wavelengths", *asked_nm),
                 {},
                 "--wavelength",
                 fmt::format("add --wavelengths {}", *asked_nm)};
}

int run(const ExplainRequest& request) {
    const auto loaded = load_plan(request.scene);
    if (!loaded) return report(loaded.error());
    const Plan& plan = *loaded.value().plan;
    const int x = request.pixel[0];
    const int y = request.pixel[1];
    if (x < 0 || y < 0 || x >= plan.settings.width || y >= plan.settings.height)
        return report({ErrorKind::usage,
                       fmt::format("pixel {},{} lies outside the picture of {}x{}", x, y, plan.settings.width,
                                   plan.settings.height),
                       {},
                       "--pixel",
                       fmt::format("0,0 (top left) to {},{}", plan.settings.width - 1, plan.settings.height - 1)});
    if (request.sample < 0 || request.sample >= plan.settings.samples_per_pixel)
        return report(
            {ErrorKind::usage,
             fmt::format("there is no sample {}: a pixel has {}", request.sample, plan.settings.samples_per_pixel),
             {},
             "--sample",
             "they count from 0; --spp says how many there are"});
    const auto wavelength = wavelength_index(plan, request.wavelength_nm);
    if (!wavelength) return report(wavelength.error());
    const Explanation explanation = explain(plan, x, y, static_cast<std::uint32_t>(request.sample), wavelength.value());
    fmt::print("{}", request.json ? explanation_as_json(plan, explanation)
                                  : explanation_as_text(plan, explanation, request.least_share));
    constexpr int self_check_failed = 5;
    return explanation.result.failures == 0 && explanation.exact() ? 0 : self_check_failed;
}

}  // namespace

void add_explain_command(CLI::App& app, int& exit_code) {
    auto request = std::make_shared<ExplainRequest>();
    CLI::App* command =
        app.add_subcommand("explain", "Show a pixel's coherence matrix and the backward tree that made it");
    add_scene_options(*command, request->scene);
    command->add_option("--pixel", request->pixel, "Pixel X,Y; 0,0 is top left")
        ->required()
        ->delimiter(',')
        ->expected(2);
    command->add_option("--sample", request->sample, "Sample of the pixel; 0 is its centre");
    command->add_option("--wavelength", request->wavelength_nm,
                        "Which of the wavelengths, in nm (default 580, or the first)");
    command->add_option("--least", request->least_share, "Leave out branches of less than this weight (text only)")
        ->capture_default_str();
    command->add_flag("--json", request->json, "Print JSON with every branch at full precision");
    command->footer(
        "Examples:\n"
        "  polariscope explain assets/scenes/cube-calcite.yaml --pixel 256,200\n"
        "  polariscope explain assets/scenes/cube-calcite.yaml --pixel 256,200 --json > tree.json");
    command->callback([request, &exit_code] { exit_code = run(*request); });
}

}  // namespace pol
