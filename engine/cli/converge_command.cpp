// SPDX-License-Identifier: Apache-2.0
#include "cli/converge_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "cli/interruption.h"
#include "cli/messages.h"
#include "cli/output_checks.h"
#include "cli/progress_line.h"
#include "cli/scene_options.h"
#include "core/result.h"
#include "core/version.h"
#include "io/files/output_file.h"
#include "render/renderer.h"
#include "report/html_page.h"
#include "report/number_words.h"
#include "verify/convergence/convergence.h"
#include "verify/convergence/convergence_report.h"
#include "verify/convergence/convergence_summary.h"

namespace pol {

namespace {

struct ConvergeRequest {
    SceneOptions scene;
    std::string folder;
    std::string reference;
    std::optional<int> threads;
    int seeds = 5;
    bool quiet = false;
};

/// Curves are about the shape of error against time, which a small picture shows as well as a large one.
void shrink(RenderSettings& settings) {
    constexpr int longest_side = 96;
    const int longest = std::max(settings.width, settings.height);
    if (longest <= longest_side) return;
    const auto scaled = [&](int side) {
        return std::max(1, static_cast<int>(std::lround(static_cast<double>(side) * longest_side / longest)));
    };
    settings.width = scaled(settings.width);
    settings.height = scaled(settings.height);
}

std::string number_or_dash(double value, const char* format = "{:.2e}") {
    return std::isnan(value) ? "-" : fmt::format(fmt::runtime(format), value);
}

void print_summary(const verify::ConvergenceResult& result, const std::filesystem::path& folder) {
    const auto curves = verify::curves(result.rows);
    fmt::print("reference: {}; {}\n\n", printable(result.reference_id), verify::text_about_reference(result));
    fmt::print("{:<34} {:>9} {:>9} {:>9} {:>9} {:>9}  {}\n", "setting (median of seeds)", "error", "from", "to",
               "bound", "CPU s", "");
    for (const verify::Curve& curve : curves) {
        fmt::print("{}{}\n", curve.series,
                   curve.slope ? fmt::format(": error falls as time^{:.2f}", *curve.slope) : std::string());
        for (const verify::CurvePoint& p : curve.points)
            fmt::print("  {:<32} {:>9.2e} {:>9.2e} {:>9.2e} {:>9} {:>9.3g}  {}\n", p.setting, p.error, p.error_low,
                       p.error_high, number_or_dash(p.bound), p.cpu_s, p.below_floor ? "below the floor" : "");
    }
    fmt::print("\ncheapest setting for an error (fro_c) of\n");
    for (const verify::Cheapest& best : verify::cheapest(curves, {1e-1, 1e-2, 1e-3}))
        fmt::print("  {:<7g} {}\n", best.error,
                   best.point ? fmt::format("{}: {} ({}, {:.3g} CPU s, error {:.2e})", best.series, best.point->setting,
                                            duration_text(best.point->wall_s), best.point->cpu_s, best.point->error)
                              : std::string("not reached by any setting"));
    fmt::print("\n{:<34} {:>11} {:>11} {:>11} {:>11} {:>14}\n", "error taken apart", "truncation", "its bound",
               "sampling", "spectral", "floating point");
    for (const verify::ErrorBudget& budget : verify::error_budgets(result.rows))
        fmt::print("  {:<32} {:>11} {:>11} {:>11} {:>11} {:>14}\n", budget.setting, number_or_dash(budget.truncation),
                   number_or_dash(budget.truncation_bound),
                   std::isnan(budget.sampling) ? "unknown" : number_or_dash(budget.sampling),
                   number_or_dash(budget.spectral), number_or_dash(budget.floating_point));
    if (result.rounding) fmt::print("\nfloating point: {}\n", verify::text_of(*result.rounding));
    fmt::print("\nof our own pictures: {} (must be 100.00)\n", verify::text_about_bounds(result));
    fmt::print("{}\n", printable((folder / "report.html").string()));
}

Result<Done> write_report(const verify::ConvergenceRequest& work, const verify::ConvergenceResult& result,
                          const std::string& command) {
    POL_TRY(const auto pictures, verify::budget_pictures(work, result));
    for (const verify::NamedPlot& named : verify::convergence_plots(result))
        if (auto done = write_file(work.folder / (named.name + ".svg"), plot_svg(named.plot)); !done) return done;
    return write_file(work.folder / "report.html",
                      html_page("Error against run time: " + work.scene_name,
                                verify::convergence_section(work, result, pictures, command)));
}

/// The command line that makes the report again.
std::string command_text(const ConvergeRequest& request) {
    std::string text =
        "polariscope converge " + request.scene.scene + " -o " + request.folder + given_text(request.scene);
    if (request.threads) text += fmt::format(" --threads {}", *request.threads);
    if (!request.reference.empty()) text += " --reference " + request.reference;
    return text + fmt::format(" --seeds {}", request.seeds);
}

std::optional<Error> unusable(const ConvergeRequest& request) {
    if (request.threads && (*request.threads < 1 || *request.threads > 1024))
        return Error{
            ErrorKind::usage, fmt::format("{} threads cannot work", *request.threads), {}, "--threads", "1 to 1024"};
    if (request.seeds < 1 || request.seeds > 1000)
        return Error{ErrorKind::usage,
                     fmt::format("{} seeds make no curve", request.seeds),
                     {},
                     "--seeds",
                     "1 to 1000; at least 5 for a band worth looking at"};
    return std::nullopt;
}

int run_converge(const ConvergeRequest& request) {
    if (const auto problem = unusable(request)) return report(*problem);
    const auto loading = std::chrono::steady_clock::now();
    auto scene = load_scene_with(request.scene);
    if (!scene) return report(scene.error());
    if (const auto made = make_folder(request.folder); !made) return report(made.error());
    verify::ConvergenceRequest work;
    work.load_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - loading).count();
    work.scene = std::move(scene).value();
    if (!request.scene.gives("size") && request.reference.empty()) shrink(work.scene.render);
    work.scene_name = std::filesystem::path(request.scene.scene).filename().string();
    work.folder = request.folder;
    if (!request.reference.empty()) work.reference = request.reference;
    work.threads = request.threads.value_or(hardware_threads());
    work.seeds = request.seeds;
    work.tool_version = program_version();

    remember_signals();
    ProgressLine line(request.quiet);
    const auto result = verify::converge(work, [&](const verify::ConvergenceProgress& progress) {
        line.show(static_cast<double>(progress.done) / std::max(1, progress.all), progress.seconds_left,
                  progress.doing);
        return caught_signal() == 0;
    });
    line.finish();
    if (!result) return report(result.error());
    if (result.value().rows.empty()) {
        remark("polariscope: stopped before the first run was finished; there is no report\n");
        return interrupted_exit_code();
    }
    if (const auto written = write_report(work, result.value(), command_text(request)); !written)
        return report(written.error());
    print_summary(result.value(), request.folder);
    if (!result.value().complete) {
        remark("polariscope: stopped; the same command goes on where it was\n");
        return interrupted_exit_code();
    }
    if (result.value().reference_check && result.value().reference_check->contradicts())
        remark(
            fmt::format("polariscope: {}: {}\n  hint: another scene, camera, frame or unit of radiance? "
                        "polariscope check names what cannot be light\n",
                        printable(request.reference), verify::text_about_reference(result.value())));
    return verify::bounds_hold(result.value()) ? 0 : self_check_failed;
}

}  // namespace

void add_converge_command(ProgramCommand app, int& exit_code) {
    auto request = std::make_shared<ConvergeRequest>();
    ProgramCommand command =
        app.add_subcommand("converge", "Measure error against run time over many settings of a scene");
    add_scene_options(command, request->scene);
    command
        .add_option("-o,--output", request->folder,
                    "Folder for report.html, its plots as SVG, runs.csv and reference.exr")
        .type_name("FOLDER")
        .required();
    command
        .add_option("--reference", request->reference,
                    "Stokes picture to measure against instead of our own; it is held "
                    "against our deepest picture first")
        .type_name("NAME.exr");
    command.add_option("--seeds", request->seeds, "Runs of each setting, with different random numbers")
        .capture_default_str();
    command.add_option("--threads", request->threads, "Worker threads (default: all cores)");
    command.add_flag("--quiet", request->quiet, "No progress");
    command.footer(
        "Turns residual, samples, depth, branches and wavelengths one at a time, and tells truncation, sampling,\n"
        "spectral and floating-point error apart (the last one against the trees of some pixels followed in 128 bit).\n"
        "Without --size the longer side of the picture is cut to 96 pixels. Ctrl-C keeps the finished runs; the same\n"
        "command then goes on.\n"
        "What is cheapest depends on the scene: a depth limit never finds the light it cuts, and in glass energy is\n"
        "the better cut at every error; in a crystal (cube-calcite) depth 7 to 9 may be the cheapest way to 0.1.\n"
        "Exit code 5: a bound did not hold, or the --reference lies outside the bounds of our own deepest picture.\n"
        "\nExamples:\n"
        "  polariscope converge assets/scenes/paper-glass-unpolarized.yaml -o glass\n"
        "  polariscope converge assets/scenes/paper-glass-unpolarized.yaml -o aa --mode area --wavelengths 380:780:20");
    command.callback([request, &exit_code] { exit_code = run_converge(*request); });
}

}  // namespace pol
