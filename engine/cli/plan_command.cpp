// SPDX-License-Identifier: Apache-2.0
#include "cli/plan_command.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/messages.h"
#include "cli/scene_options.h"

namespace pol {

namespace {

struct PlanRequest {
    SceneOptions scene;
    bool json = false;
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

int run(const PlanRequest& request) {
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
    command.footer("Example:\n  polariscope plan assets/scenes/cube-calcite.yaml --wavelengths 380:780:20");
    command.callback([request, &exit_code] { exit_code = run(*request); });
}

}  // namespace pol
