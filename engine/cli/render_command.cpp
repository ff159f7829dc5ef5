// SPDX-License-Identifier: Apache-2.0
#include "cli/render_command.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/progress_line.h"
#include "cli/report.h"
#include "cli/scene_options.h"
#include "io/exr_file.h"
#include "io/output_file.h"
#include "io/scene_hash.h"
#include "plan/compile.h"
#include "render/renderer.h"

namespace pol {

namespace {

using Clock = std::chrono::steady_clock;

struct RenderRequest {
    SceneOptions scene;
    std::string output;
    std::optional<int> threads;
    std::optional<double> seconds;
    std::string statistics;
    bool quiet = false;
};

volatile std::sig_atomic_t caught_signal = 0;

void remember_signal(int signal) {
    caught_signal = signal;
}

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

enum class Stop { samples, time_limit, signal };

struct Outcome {
    Stop stop = Stop::samples;
    double done = 0.0;     ///< share of the samples asked for
    double seconds = 0.0;  ///< from start to stop, without pauses
};

/// `open_ended`: samples are asked for as long as there is time.
Outcome run_to_stop(Renderer& renderer, const RenderRequest& request, bool open_ended) {
    constexpr double look_every_s = 0.1;
    // Only a suspended program (Ctrl-Z, a sleeping computer) comes back this late.
    constexpr double pause_from_s = 1.0;
    ProgressLine line(request.quiet);
    Outcome outcome;
    auto last = Clock::now();
    for (;;) {
        double wait = look_every_s;
        if (request.seconds) wait = std::clamp(*request.seconds - outcome.seconds, 0.0, wait);
        const bool finished = renderer.wait_for(wait);
        const auto now = Clock::now();
        const double passed = std::chrono::duration<double>(now - last).count();
        last = now;
        outcome.seconds += passed > wait + pause_from_s ? wait : passed;
        outcome.done = renderer.progress().done;
        line.show(open_ended ? std::min(1.0, outcome.seconds / *request.seconds) : outcome.done, outcome.seconds);
        if (finished) break;
        if (caught_signal != 0) outcome.stop = Stop::signal;
        if (request.seconds && outcome.seconds >= *request.seconds) outcome.stop = Stop::time_limit;
        if (outcome.stop != Stop::samples) {
            renderer.cancel();
            while (!renderer.wait_for(1.0)) {
            }
            break;
        }
    }
    line.finish();
    return outcome;
}

std::string settings_text(const RenderSettings& s) {
    return fmt::format("mode={} spp={} residual={} depth={} node_budget={} seed={}",
                       s.mode == SampleMode::area ? "area" : "point", s.samples_per_pixel, s.residual,
                       s.depth ? std::to_string(*s.depth) : "none", s.node_budget, s.seed);
}

struct Timing {
    double load_s = 0.0;
    double render_wall_s = 0.0;
    double render_cpu_s = 0.0;
    double output_s = 0.0;
};

Result<Done> write_statistics(const RenderRequest& request, const LoadedPlan& loaded, const Renderer& renderer,
                              const StokesImage& image, const Timing& timing, int threads,
                              const std::string& stop_reason) {
    const Plan& plan = *loaded.plan;
    const RenderStatistics& s = renderer.progress().statistics;
    const auto mean = [](const std::vector<double>& v) {
        double sum = 0.0;
        for (const double x : v) sum += x;
        return v.empty() ? 0.0 : sum / static_cast<double>(v.size());
    };
    nlohmann::ordered_json out;
    out["tool"] = "polariscope";
    out["tool_version"] = POL_VERSION;
    out["kernel_features"] = plan.features.kernel;
    out["precision"] = "f64";
    out["threads"] = threads;
    out["scene"] = request.scene.scene;
    out["scene_hash"] = image.attributes.at("scene_hash");
    out["width"] = plan.settings.width;
    out["height"] = plan.settings.height;
    out["mode"] = plan.settings.mode == SampleMode::area ? "area" : "point";
    out["wavelengths_nm"] = plan.wavelengths_nm;
    out["trees_per_sample"] = plan.groups.size();
    out["spp"] = plan.settings.samples_per_pixel;
    out["residual_target"] = plan.settings.residual;
    out["depth_limit"] =
        plan.settings.depth ? nlohmann::ordered_json(*plan.settings.depth) : nlohmann::ordered_json(nullptr);
    out["seed"] = plan.settings.seed;
    out["t_load_s"] = timing.load_s;
    out["t_render_wall_s"] = timing.render_wall_s;
    out["t_render_cpu_s"] = timing.render_cpu_s;
    out["t_output_s"] = timing.output_s;
    out["camera_samples"] = s.samples;
    out["rays"] = s.nodes;
    out["nodes_mean"] =
        s.samples > 0 ? static_cast<double>(s.nodes) / static_cast<double>(s.samples * plan.groups.size()) : 0.0;
    out["nodes_max"] = s.most_nodes;
    out["residual_mean"] = mean(image.residual);
    out["residual_max"] =
        image.residual.empty() ? 0.0 : *std::max_element(image.residual.begin(), image.residual.end());
    out["tail_mean"] = mean(image.tail);
    out["brightest"] = image.brightest;
    out["energy_defect_max"] = s.worst_energy_defect;
    out["failures"] = s.failures;
    out["film_bytes_per_pixel"] = renderer.film().bytes_per_pixel();
    out["stop_reason"] = stop_reason;
    auto file = OutputFile::create(request.statistics);
    if (!file) return file.error();
    const std::string text = out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    file.value()->write(text.data(), text.size());
    return file.value()->commit();
}

/// An hour of work must not end at a missing folder: what speaks against the outputs is found out first.
std::optional<Error> unusable_output(const RenderRequest& request) {
    if (auto problem = output_problem(request.output, ".exr", {request.scene.scene})) return problem;
    if (request.statistics.empty()) {
        auto probe = OutputFile::create(request.output);
        return probe ? std::nullopt : std::optional(probe.error());
    }
    if (auto problem = output_problem(request.statistics, "", {request.scene.scene, request.output})) return problem;
    for (const std::string& path : {request.output, request.statistics})
        if (auto probe = OutputFile::create(path); !probe) return probe.error();
    return std::nullopt;
}

/// Says on stdout what was made, and on stderr what is wrong with it; returns the exit code.
int conclude(const RenderRequest& request, const Outcome& outcome, bool open_ended, const RenderStatistics& statistics,
             const StokesImage& image) {
    constexpr int self_check_failed = 5;
    constexpr int stopped_by_time = 10;
    if (!request.quiet) {
        const auto largest = [](const std::vector<double>& shares) {
            return shares.empty() ? 0.0 : *std::max_element(shares.begin(), shares.end());
        };
        const std::string guessed = image.tail.empty() ? ""
                                                       : fmt::format(", estimated by one random path at most {:.3g} %",
                                                                     100.0 * largest(image.tail));
        const double samples = static_cast<double>(statistics.samples) / static_cast<double>(image.pixel_count());
        fmt::print("{}: {}x{}, {} wavelength{}, {}{}, {} rays, untraced at most {:.3g} % of a pixel{}\n",
                   printable(request.output), image.width, image.height, image.wavelengths_nm.size(),
                   image.wavelengths_nm.size() == 1 ? "" : "s",
                   samples > 1.0 ? fmt::format("{:.1f} samples per pixel, ", samples) : "",
                   duration_text(outcome.seconds), count_text(statistics.nodes), 100.0 * largest(image.residual),
                   guessed);
    }
    if (outcome.stop == Stop::signal || (outcome.stop == Stop::time_limit && !open_ended)) {
        const std::string share =
            open_ended ? "what was done" : fmt::format("{:.3g} % of the samples", 100.0 * outcome.done);
        fmt::print(stderr, "polariscope: {} after {}; {} holds {}\n",
                   outcome.stop == Stop::signal ? "stopped" : "the time limit came", duration_text(outcome.seconds),
                   printable(request.output), share);
    }
    if (statistics.failures > 0) {
        fmt::print(stderr,
                   "polariscope: self-check failed in {} of {} samples (energy, not-a-number or a leaking solid)\n"
                   "  hint: the picture is written; its channel 'failures' counts them per pixel\n",
                   statistics.failures, statistics.samples);
        return self_check_failed;
    }
    if (outcome.stop == Stop::signal) return 128 + static_cast<int>(caught_signal);
    if (outcome.stop == Stop::time_limit && !open_ended) return stopped_by_time;
    return 0;
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
    const auto load_start = Clock::now();
    auto scene = load_scene_with(request.scene);
    if (!scene) return report(scene.error());
    RenderSettings& settings = scene.value().render;
    // All samples of a point are the same ray.
    const bool open_ended = request.seconds && !request.scene.samples && settings.mode == SampleMode::area;
    if (open_ended) settings.samples_per_pixel = 1 << 24;
    auto plan = compile(scene.value());
    if (!plan) return report(plan.error());
    const LoadedPlan loaded{std::move(scene).value(), std::move(plan).value()};
    if (const auto problem = unusable_output(request)) return report(*problem);
    Timing timing;
    timing.load_s = seconds_since(load_start);

    std::signal(SIGINT, remember_signal);
    std::signal(SIGTERM, remember_signal);
    const int threads = request.threads.value_or(hardware_threads());
    Renderer renderer(threads);
    const double cpu_start = cpu_seconds();
    renderer.start(loaded.plan);
    const Outcome outcome = run_to_stop(renderer, request, open_ended);
    timing.render_wall_s = outcome.seconds;
    timing.render_cpu_s = cpu_seconds() - cpu_start;

    const auto output_start = Clock::now();
    StokesImage image = renderer.snapshot();
    image.attributes["scene"] = std::filesystem::path(request.scene.scene).filename().string();
    image.attributes["scene_hash"] = scene_hash(loaded.scene);
    image.attributes["settings"] = settings_text(loaded.plan->settings);
    if (auto written = write_exr(image, request.output); !written) return report(written.error());
    timing.output_s = seconds_since(output_start);

    if (!request.statistics.empty()) {
        const std::string reason = outcome.stop == Stop::samples      ? "samples"
                                   : outcome.stop == Stop::time_limit ? "time"
                                                                      : "signal";
        const auto written = write_statistics(request, loaded, renderer, image, timing, threads, reason);
        if (!written) return report(written.error());
    }
    return conclude(request, outcome, open_ended, renderer.progress().statistics, image);
}

}  // namespace

void add_render_command(CLI::App& app, int& exit_code) {
    auto request = std::make_shared<RenderRequest>();
    CLI::App* command =
        app.add_subcommand("render", "Trace a scene and write the Stokes vectors of every pixel to an OpenEXR file");
    add_scene_options(*command, request->scene);
    command->add_option("-o,--output", request->output, "OpenEXR file to write, NAME.exr")->required();
    command->add_option("--threads", request->threads,
                        "Worker threads; the picture does not depend on it (default: all cores)");
    command->add_option("--time", request->seconds,
                        "Stop after this many seconds and write what is there; in mode area without --spp, "
                        "add samples until then");
    command->add_option("--stats", request->statistics, "Write times, counts and errors to this JSON file");
    command->add_flag("--quiet", request->quiet, "Print errors only");
    command->footer(
        "Ctrl-C stops, writes what is there and exits with 130 (SIGTERM: 143). Ctrl-Z pauses, fg goes on; a pause "
        "counts\n"
        "neither for --time nor for the time left.\n"
        "\nExamples:\n"
        "  polariscope render assets/scenes/paper-calcite-unpolarized.yaml -o calcite.exr --wavelengths 380:780:20\n"
        "  polariscope render assets/scenes/paper-glass-unpolarized.yaml -o glass9.exr --depth 9   (the paper's cut)\n"
        "  polariscope render assets/scenes/bench/g1.yaml -o g1.exr --mode area --spp 64 --residual 3e-3 --stats "
        "g1.json");
    command->callback([request, &exit_code] { exit_code = run(*request); });
}

}  // namespace pol
