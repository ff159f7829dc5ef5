// SPDX-License-Identifier: Apache-2.0
#include "cli/render_command.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>

#include "cli/interruption.h"
#include "cli/messages.h"
#include "cli/output_checks.h"
#include "cli/progress_line.h"
#include "cli/render_display.h"
#include "cli/render_report.h"
#include "cli/scene_options.h"
#include "core/result.h"
#include "io/files/output_file.h"
#include "io/pictures/exr_file.h"
#include "io/scenes/picture_attributes.h"
#include "plan/compile.h"
#include "render/memory.h"
#include "render/renderer.h"

namespace pol {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Takes the place of the plan of a scene whose residual must be finer.
Result<Done> refine(Scene& scene, std::shared_ptr<const Plan>& plan, double residual, bool quiet) {
    if (!quiet)
        remark(fmt::format("too much light is untraced: residual {:.3g} instead of {:.3g}\n", residual,
                           scene.render.residual_in_force()));
    scene.render.residual = residual;
    POL_TRY(auto finer_plan, compile(scene));
    plan = std::move(finer_plan);
    return Done{};
}

/// Renders until the samples are there, a rule ends it, or a signal comes. Starts over with a finer residual as long as
/// the error rule finds too much light untraced: then `plan` becomes the finer one.
Result<RenderOutcome> render_to_stop(Renderer& renderer, const RenderRequest& request, Scene& scene,
                                     std::shared_ptr<const Plan>& plan, bool open_ended) {
    constexpr double look_every_s = 0.1;
    ProgressLine line(request.quiet);
    RenderOutcome outcome;
    outcome.open_ended = open_ended;
    bool goal_told = request.quiet;
    std::optional<ErrorReport> coarser;  // the last one, of a residual that was not fine enough
    double truncation_share = 0.0;
    if (request.error) {
        const double residual = residual_for(*plan, cheapest_goal(*plan, *request.error));
        if (residual < scene.render.residual_in_force()) POL_TRY_DONE(refine(scene, plan, residual, request.quiet));
    }
    for (;;) {
        RenderOptions options;
        options.stop.error = request.error;
        options.stop.truncation_share = truncation_share;
        if (request.seconds) options.stop.seconds = *request.seconds - outcome.seconds;
        renderer.start(plan, options);
        RenderProgress& progress = outcome.progress;
        std::size_t told = 0;
        do {
            renderer.wait_for(look_every_s);
            progress = renderer.progress();
            if (progress.goal && !goal_told) remark(goal_text(*progress.goal));
            goal_told = goal_told || progress.goal;
            const double expected = progress.seconds + progress.seconds_left.value_or(0.0);
            const double share = open_ended && progress.seconds_left ? progress.seconds / expected : progress.done;
            if (caught_signal() == 0) line.show(share, progress.seconds);
            for (; told < progress.reports.size() && !request.quiet; ++told) {
                line.finish();
                print_error_report(progress.reports[told]);
            }
            if (caught_signal() != 0) renderer.cancel();
        } while (!progress.finished);
        line.finish();
        outcome.seconds += progress.seconds;
        outcome.reports.insert(outcome.reports.end(), progress.reports.begin(), progress.reports.end());
        if (progress.reason == StopReason::cancelled) outcome.signal = caught_signal();
        if (progress.reason == StopReason::memory) throw std::bad_alloc();
        if (progress.reason != StopReason::truncation) return outcome;

        if (request.seconds && outcome.seconds >= *request.seconds) return outcome;
        const ErrorReport& last = outcome.reports.back();
        if (const auto share = coarser ? share_needed(*coarser, last, *progress.goal) : std::nullopt;
            share && *share > truncation_share) {
            truncation_share = *share;
            goal_told = request.quiet;  // there is another one
            continue;
        }
        const auto finer = finer_residual(last, scene.render.residual_in_force(), *progress.goal);
        if (!finer) return outcome;
        coarser = last;
        POL_TRY_DONE(refine(scene, plan, *finer, request.quiet));
    }
}

/// An hour of work must not end at a missing folder: what speaks against the outputs is found out first.
std::optional<Error> unusable_output(const RenderRequest& request) {
    if (auto problem = output_problem(request.output, ".exr", {request.scene.scene})) return problem;
    if (request.statistics.empty()) {
        auto probe = OutputFile::create(request.output);
        return probe ? std::nullopt : std::optional(probe.error());
    }
    if (auto problem = output_problem(request.statistics, "", {request.scene.scene, request.output})) return problem;
    for (const std::string& path : {request.output, request.statistics}) POL_TRY_DONE(OutputFile::create(path));
    return std::nullopt;
}

int run(const RenderRequest& request) {
    if (request.threads && (*request.threads < 1 || *request.threads > 1024))
        return report(
            {ErrorKind::usage, fmt::format("{} threads cannot work", *request.threads), {}, "--threads", "1 to 1024"});
    if (request.seconds && !(*request.seconds > 0.0 && *request.seconds < 1e9))
        return report({ErrorKind::usage,
                       fmt::format("{} s is no time limit", *request.seconds),
                       {},
                       "--time",
                       "a positive number of seconds"});
    if (request.error && !(*request.error > 0.0 && *request.error < 10.0))
        return report({ErrorKind::usage,
                       fmt::format("{} is no error to stop at", *request.error),
                       {},
                       "--error",
                       "a share of the picture, for example 0.01"});
    const auto load_start = Clock::now();
    auto loaded = load_scene_with(request.scene);
    if (!loaded) return report(loaded.error());
    Scene scene = std::move(loaded).value();
    RenderSettings& settings = scene.render;
    if (request.error && !request.scene.gives("mode")) settings.mode = SampleMode::area;
    // All samples of a point are the same ray.
    const bool open_ended =
        (request.seconds || request.error) && !request.scene.gives("spp") && settings.mode == SampleMode::area;
    if (open_ended) settings.samples_per_pixel = 1 << 24;
    auto compiled = compile(scene);
    if (!compiled) return report(compiled.error());
    std::shared_ptr<const Plan> plan = std::move(compiled).value();
    if (const auto problem = unusable_output(request)) return report(*problem);
    remark_doubts(*plan);
    if (!fits_memory(*plan)) throw std::bad_alloc();  // program.cpp ends with its message
    RenderTiming timing;
    timing.load_s = seconds_since(load_start);

    remember_signals();
    const int threads = request.threads.value_or(hardware_threads());
    Renderer renderer(threads);
    std::unique_ptr<RenderDisplay> display;
    if (!request.display.empty()) {
        auto opened = RenderDisplay::open(request.display, request.output, *plan, renderer);
        if (!opened) return report(opened.error());
        display = std::move(opened).value();
    }
    const double cpu_start = cpu_seconds();
    const auto outcome = render_to_stop(renderer, request, scene, plan, open_ended);
    if (!outcome) return report(outcome.error());
    timing.render_cpu_s = cpu_seconds() - cpu_start;

    if (display) display->finish();
    const auto output_start = Clock::now();
    StokesImage image = renderer.snapshot();
    image.attributes.merge(picture_attributes(scene, image.samples, request.scene.scene));
    if (auto written = write_exr(image, request.output); !written) return report(written.error());
    timing.output_s = seconds_since(output_start);

    if (!request.statistics.empty()) {
        const auto written = write_statistics(request, *plan, outcome.value(), image, timing, threads,
                                              renderer.film().bytes_per_pixel());
        if (!written) return report(written.error());
    }
    return conclude(request, outcome.value(), image);
}

}  // namespace

void add_render_command(ProgramCommand app, int& exit_code) {
    auto request = std::make_shared<RenderRequest>();
    ProgramCommand command =
        app.add_subcommand("render", "Trace a scene and write the Stokes vectors of every pixel to an OpenEXR file");
    add_scene_options(command, request->scene);
    command.add_option("-o,--output", request->output, "OpenEXR file to write").type_name("NAME.exr").required();
    command.add_option("--threads", request->threads,
                       "Worker threads; the picture does not depend on it (default: all cores)");
    command.add_option("--time", request->seconds,
                       "Stop after this many seconds and write what is there; in mode area without --spp, "
                       "add samples until then");
    command.add_option("--error", request->error,
                       "Stop when the estimated error is below this share of the picture, for example 0.01");
    command.add_option("--stats", request->statistics, "Write times, counts and errors to this JSON file")
        .type_name("FILE");
    command.add_option("--display", request->display, "Show it while it is made, in tev or in a window that listens")
        .type_name("HOST:PORT");
    command.add_flag("--quiet", request->quiet, "Print errors and doubts only");
    command.footer(
        "Ctrl-C stops, writes what is there and exits with 130 (SIGTERM: 143). Ctrl-Z pauses, fg goes on; a pause "
        "counts\n"
        "neither for --time nor for the time left.\n"
        "\n--error E: light that is not traced (a bound, for which the residual is refined) and too few samples (a\n"
        "limit of confidence, 95 % over all looks) must each fall below its share of E: a few trees tell which split\n"
        "costs least. Samples go to the pixels where they take most of the error away (maps --map samples). Mode area\n"
        "unless --mode says otherwise; without --spp, the most of a pixel, they are added until then. Exit code 10 if\n"
        "--time or --spp ends it before, or the picture stays black.\n"
        "\nExamples:\n"
        "  polariscope render assets/scenes/paper-calcite-unpolarized.yaml -o calcite.exr --wavelengths 380:780:20\n"
        "  polariscope render assets/scenes/paper-glass-unpolarized.yaml -o glass9.exr --depth 9   (the paper's cut)\n"
        "  polariscope render assets/scenes/bench/g1.yaml -o g1.exr --mode area --spp 64 --residual 3e-3 --stats "
        "g1.json\n"
        "  polariscope render assets/scenes/paper-glass-unpolarized.yaml -o glass.exr --error 0.02 --time 60\n"
        "  polariscope render assets/scenes/bench/g1.yaml -o g1.exr --display 127.0.0.1:14158   (view --listen)");
    command.callback([request, &exit_code] { exit_code = run(*request); });
}

}  // namespace pol
