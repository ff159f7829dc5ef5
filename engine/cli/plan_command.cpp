// SPDX-License-Identifier: Apache-2.0
#include "cli/plan_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "cli/ablation_report.h"
#include "cli/interruption.h"
#include "cli/messages.h"
#include "cli/progress_line.h"
#include "cli/scene_options.h"
#include "verify/ablation/ablation.h"

namespace pol {

namespace {

struct PlanRequest {
    SceneOptions scene;
    bool json = false;
    bool ablate = false;
    std::optional<int> rounds;
    bool quiet = false;
};

void print_text(const Plan& plan) {
    fmt::print("kernel: {}\n", plan.features.kernel);
    fmt::print("wavelengths: {}, traced as {} {}\n", plan.wavelengths_nm.size(), plan.groups.size(),
               plan.groups.size() == 1 ? "tree" : "trees");
    fmt::print("solids: {}, surfaces: {}, regions: {}\n\n", plan.solids.size(), plan.surfaces.size(),
               plan.regions.size());
    for (const bool needed : {true, false}) {
        fmt::print("{}\n", needed ? "needed" : "left out");
        for (const Feature& feature : plan.features.list)
            if (feature.needed == needed) fmt::print("  {:<28}{}\n", feature.name, feature.reason);
    }
    for (const std::string& doubt : plan.features.doubts) fmt::print("\ndoubt: {}\n", printable(doubt));
}

void print_json(const Plan& plan) {
    nlohmann::ordered_json out;
    out["kernel"] = plan.features.kernel;
    out["wavelengths_nm"] = plan.wavelengths_nm;
    out["trees"] = plan.groups.size();
    for (const Feature& feature : plan.features.list)
        out["features"].push_back({{"name", feature.name}, {"needed", feature.needed}, {"reason", feature.reason}});
    out["doubts"] = plan.features.doubts;
    for (const Region& region : plan.regions) {
        nlohmann::ordered_json entry{{"medium", plan.medium_names[static_cast<std::size_t>(region.medium)]},
                                     {"inside", nlohmann::ordered_json::array()}};
        for (const int member : region.members) entry["inside"].push_back(plan.solid(member).name);
        out["regions"].push_back(entry);
    }
    fmt::print("{}\n", out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

/// Few enough to be soon done, and more than one, so that what is kept for several is there.
constexpr int most_ablation_samples = 2;

int run_ablation(const PlanRequest& request) {
    constexpr int most_rounds = 1000;
    constexpr double longest_render_s = 0.1;
    verify::AblationRequest work;
    work.rounds = request.rounds.value_or(work.rounds);
    if (work.rounds < 1 || work.rounds > most_rounds)
        return report(usage_error("--rounds", fmt::format("{} rounds measure nothing", work.rounds),
                                  fmt::format("1 to {}", most_rounds)));
    auto scene = load_scene_with(request.scene);
    if (!scene) return report(scene.error());
    work.scene = std::move(scene).value();
    int& samples = work.scene.render.samples_per_pixel;
    if (!request.scene.gives("spp")) samples = std::min(samples, most_ablation_samples);
    if (!request.scene.gives("size")) work.longest_render_s = longest_render_s;

    remember_signals();
    ProgressLine line(request.quiet, stderr);
    const auto result = verify::ablate(work, [&line](double done, const std::string& doing) {
        if (caught_signal() == 0) line.show(done, std::numeric_limits<double>::quiet_NaN(), doing);
        return caught_signal() == 0;
    });
    line.finish();
    if (!result) return report(result.error());
    if (!result.value().complete) {
        remark("polariscope: stopped before all was measured; there is no table\n");
        return interrupted_exit_code();
    }
    fmt::print("{}", request.json ? ablation_json(result.value()) : ablation_text(result.value()));
    return conclude(result.value());
}

int run(const PlanRequest& request) {
    if (request.ablate) return run_ablation(request);
    if (request.rounds || request.quiet)
        return report(
            usage_error(request.rounds ? "--rounds" : "--quiet", "nothing is rendered", "it goes with --ablate"));
    const auto loaded = load_plan(request.scene);
    if (!loaded) return report(loaded.error());
    request.json ? print_json(*loaded.value().plan) : print_text(*loaded.value().plan);
    return 0;
}

}  // namespace

void add_plan_command(ProgramCommand app, int& exit_code) {
    auto request = std::make_shared<PlanRequest>();
    ProgramCommand command =
        app.add_subcommand("plan", "Show what a scene needs of the tracer and what is left out, and why");
    add_scene_options(command, request->scene);
    command.add_flag("--json", request->json, "Print JSON");
    command.add_flag(
        "--ablate", request->ablate,
        "Keep what is left out, a feature at a time: what does leaving it out save, and is the picture the "
        "same to the bit?");
    command.add_option("--rounds", request->rounds, "Of --ablate: renders with and without each feature (default: 5)");
    command.add_flag("--quiet", request->quiet, "Of --ablate: no progress");
    command.footer(
        "--ablate renders with and without a feature in turn, on one thread, and prints medians of CPU time. Without\n"
        "--size the picture is made so small that a render takes 0.1 s, without --spp of no more than 2 samples.\n"
        "Exit code 1: with some feature kept the picture is another one.\n"
        "\nExamples:\n"
        "  polariscope plan assets/scenes/cube-calcite.yaml --wavelengths 380:780:20\n"
        "  polariscope plan assets/scenes/cube-glass.yaml --ablate --size 256x256");
    command.callback([request, &exit_code] { exit_code = run(*request); });
}

}  // namespace pol
