// SPDX-License-Identifier: Apache-2.0
#include "cli/explain_command.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "cli/messages.h"
#include "cli/output_checks.h"
#include "cli/scene_options.h"
#include "io/files/output_file.h"
#include "report/explain_report.h"
#include "report/ray_table.h"
#include "spectrum/wavelength_grid.h"
#include "tracer/explain.h"
#include "verify/facts/pixel_case.h"

namespace pol {

namespace {

struct ExplainRequest {
    SceneOptions scene;
    std::vector<int> pixel;
    int sample = 0;
    std::optional<double> wavelength_nm;
    double least_share = 1e-3;
    bool json = false;
    bool is_case = false;  ///< SCENE is a pixel case
    std::string csv;
    std::string obj;
};

/// Index of the plan's wavelength that was asked for, or of the default one.
Result<int> wavelength_index(const Plan& plan, std::optional<double> asked_nm) {
    constexpr double same_nm = 1e-6;
    const std::size_t nearest = nearest_wavelength(plan.wavelengths_nm, asked_nm.value_or(default_wavelength_nm));
    if (!asked_nm || std::abs(plan.wavelengths_nm[nearest] - *asked_nm) <= same_nm) return static_cast<int>(nearest);
    if (auto problem = wavelength_problem(*asked_nm)) {
        problem->field = "--wavelength";
        return *problem;
    }
    return Error{ErrorKind::usage,
                 fmt::format("{} nm is not among the scene's wavelengths", *asked_nm),
                 {},
                 "--wavelength",
                 fmt::format("add --wavelengths {}", *asked_nm)};
}

/// What speaks against the files asked for, before anything is traced.
std::optional<Error> unusable_output(const ExplainRequest& request) {
    if (!request.csv.empty())
        if (auto problem = output_problem(request.csv, ".csv", {request.scene.scene})) return problem;
    if (!request.obj.empty()) return output_problem(request.obj, ".obj", {request.scene.scene, request.csv});
    return std::nullopt;
}

/// Writes and prints what was asked for; returns the exit code. Files come first: who reads the text may stop at any
/// line, which ends the program.
int show(const ExplainRequest& request, const Plan& plan, const Explanation& explanation) {
    if (!request.csv.empty())
        if (const auto done = write_file(request.csv, ray_table_as_csv(plan, explanation)); !done)
            return report(done.error());
    if (!request.obj.empty())
        if (const auto done = write_file(request.obj, paths_as_obj(plan, explanation)); !done)
            return report(done.error());
    fmt::print("{}", request.json ? explanation_as_json(plan, explanation)
                                  : explanation_as_text(plan, explanation, request.least_share));
    return explanation.result.failures == 0 && explanation.exact() ? 0 : self_check_failed;
}

/// An option that a pixel case leaves nothing to say to: the case names its pixel, and its scene has the settings.
std::optional<Error> idle_option(const ProgramCommand& command) {
    constexpr std::array useful{"--case", "--csv", "--obj", "--least", "--help", "SCENE"};
    for (const std::string& given : command.given_options())
        if (std::find(useful.begin(), useful.end(), given) == useful.end())
            return Error{ErrorKind::usage,
                         "the case says that itself",
                         {},
                         given,
                         "leave it out, or change it in the case file"};
    return std::nullopt;
}

int run_case(const ExplainRequest& request) {
    const auto loaded = load_pixel_case(request.scene.scene);
    if (!loaded) return report(loaded.error());
    const PixelCase& pixel_case = loaded.value();
    const auto verdict = check(pixel_case);
    if (!verdict) return report(verdict.error());
    const auto line = [](const char* name, const CoherenceMatrix<double>& j) {
        fmt::print("{} xx {:.17g}  yy {:.17g}  xy {:.17g} {:+.17g} i\n", name, j.xx, j.yy, j.xy.re, j.xy.im);
    };
    line("expected", pixel_case.expected);
    line("computed", verdict.value().computed);
    const bool same = verdict.value().computed == pixel_case.expected;
    fmt::print("the case {}: {}\n\n", verdict.value().holds ? "holds" : "DOES NOT HOLD",
               same ? std::string("equal to the last bit")
                    : fmt::format("differs by {:.3g}, allowed {:.3g}", verdict.value().difference,
                                  pixel_case.tolerance * trace(pixel_case.expected)));
    const int shown = show(request, *verdict.value().plan, verdict.value().explanation);
    return verdict.value().holds ? shown : self_check_failed;
}

int run(const ExplainRequest& request) {
    if (!(request.least_share >= 0.0 && request.least_share <= 1.0))
        return report({ErrorKind::usage,
                       fmt::format("{} is no weight", request.least_share),
                       {},
                       "--least",
                       "from 0, all branches, to 1"});
    if (const auto problem = unusable_output(request)) return report(*problem);
    if (request.is_case) return run_case(request);
    if (request.pixel.empty())
        return report({ErrorKind::usage, "which pixel?", {}, "--pixel", "for example --pixel 256,200"});
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
    if (request.sample < 0 || request.sample > plan.settings.last_sample())
        return report(
            {ErrorKind::usage,
             fmt::format("there is no sample {}: they end at {}", request.sample, plan.settings.last_sample()),
             {},
             "--sample",
             "0 is the pixel's centre, and the first sample of mode point; those of mode area count from 1"});
    const auto wavelength = wavelength_index(plan, request.wavelength_nm);
    if (!wavelength) return report(wavelength.error());
    const Explanation explanation = explain(plan, x, y, static_cast<std::uint32_t>(request.sample), wavelength.value());
    return show(request, plan, explanation);
}

}  // namespace

void add_explain_command(ProgramCommand app, int& exit_code) {
    auto request = std::make_shared<ExplainRequest>();
    ProgramCommand command =
        app.add_subcommand("explain", "Show a pixel's coherence matrix and the backward tree that made it");
    add_scene_options(command, request->scene);
    command.add_option("--pixel", request->pixel, "Pixel X,Y; 0,0 is top left (needed without --case)").list(',', 2, 2);
    command.add_option("--sample", request->sample,
                       "Sample of the pixel; 0 is its centre, which mode area shows here only: "
                       "those of its picture count from 1");
    command.add_option("--wavelength", request->wavelength_nm,
                       "Which of the wavelengths, in nm (default: the one nearest to 580)");
    command.add_option("--least", request->least_share, "Leave out branches of less than this weight (text only)")
        .capture_default_str();
    command.add_flag("--json", request->json, "Print JSON with every branch at full precision");
    command.add_option("--csv", request->csv, "Also write a table of ray states, one line per segment (*.csv)")
        .type_name("NAME.csv");
    command.add_option("--obj", request->obj, "Also write the paths as lines in space (*.obj)").type_name("NAME.obj");
    command.add_flag(
        "--case", request->is_case,
        "SCENE is a pixel case (see assets/cases/README.md): check its matrix again; exit code 5 if it differs");
    command.footer(
        "Examples:\n"
        "  polariscope explain assets/scenes/cube-calcite.yaml --pixel 256,200\n"
        "  polariscope explain assets/scenes/cube-calcite.yaml --pixel 256,200 --json > tree.json\n"
        "  polariscope explain assets/scenes/cube-calcite.yaml --pixel 256,200 --csv rays.csv --obj rays.obj\n"
        "  polariscope explain --case assets/cases/brewster.yaml");
    command.callback([request, command, &exit_code] {
        const auto problem = request->is_case ? idle_option(command) : std::nullopt;
        exit_code = problem ? report(*problem) : run(*request);
    });
}

}  // namespace pol
