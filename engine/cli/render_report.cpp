// SPDX-License-Identifier: Apache-2.0
#include "cli/render_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "cli/messages.h"
#include "core/overloaded.h"
#include "core/version.h"
#include "io/files/output_file.h"
#include "report/number_words.h"
#include "scene/setting_table.h"

namespace pol {

namespace {

using Json = nlohmann::ordered_json;

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

double largest(const std::vector<double>& values) {
    return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

std::string stop_text(const RenderOutcome& outcome) {
    switch (outcome.progress.reason) {
        case StopReason::time:
            return "time";
        case StopReason::error:
            return "error";
        case StopReason::truncation:
            return "truncation";
        case StopReason::dark:
            return "dark";
        case StopReason::cancelled:
            return "signal";
        case StopReason::memory:
            return "memory";
        case StopReason::none:
        case StopReason::samples:
            break;
    }
    return "samples";
}

const char* part_text(ErrorPart part) {
    return part == ErrorPart::truncation ? "truncation" : "sampling";
}

/// JSON knows no infinity.
Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json error_json(const PictureError& error) {
    return {{"truncation", number(error.truncation)},
            {"sampling", error.sampling ? number(*error.sampling) : Json(nullptr)},
            {"residual_mean", error.residual_mean},
            {"residual_max", error.residual_max}};
}

Json error_rule_json(const RenderOutcome& outcome) {
    Json passes = Json::array();
    for (const ErrorReport& report : outcome.reports) {
        Json pass = {{"samples", report.samples}, {"seconds", report.seconds}};
        pass.update(error_json(report.error));
        const auto limit = sampling_limit(report);
        pass["sampling_limit"] = limit ? number(*limit) : Json(nullptr);
        passes.push_back(pass);
    }
    const ErrorGoal& goal = *outcome.progress.goal;
    const auto last = last_to_fall(outcome.reports, goal);
    return {{"target", goal.error},
            {"truncation_share", goal.truncation_share},
            {"last_to_fall", last ? Json(part_text(*last)) : Json(nullptr)},
            {"passes", passes}};
}

void add_setting(Json& out, const RenderSetting& setting, const RenderSettings& settings) {
    Json value;
    std::visit(Overloaded{
                   [&](const SizeSetting& kind) {
                       out["width"] = settings.*kind.width;
                       out["height"] = settings.*kind.height;
                   },
                   [&](const WavelengthsSetting& kind) { value = settings.*kind.nm; },
                   [&](const ChoiceSetting& kind) { value = kind.words[static_cast<std::size_t>(kind.get(settings))]; },
                   [&](const WholeSetting& kind) { value = settings.*kind.value; },
                   [&](const LimitSetting& kind) {
                       if (settings.*kind.value) value = *(settings.*kind.value);
                   },
                   [&](const UsualSetting& kind) { value = (settings.*kind.value).value(); },
                   [&](const UsualNumberSetting& kind) {
                       const std::string_view words = kind.words(settings);
                       value = words.empty() ? Json((settings.*kind.in_force)()) : Json(words);
                   },
                   [&](const SeedSetting& kind) { value = settings.*kind.value; },
                   [&](const FlagSetting& kind) { value = settings.*kind.value; },
               },
               setting.kind);
    if (!setting.statistic.empty()) out[std::string(setting.statistic)] = std::move(value);
}

}  // namespace

std::string goal_text(const ErrorGoal& goal) {
    return fmt::format(
        "error {:.3g}: at most {:.2g} by light that is not traced, {:.2g} by sampling, which costs least\n", goal.error,
        goal.truncation(), goal.sampling());
}

void print_error_report(const ErrorReport& report) {
    std::string sampling = report.error.sampling ? fmt::format("{:.3g} (68 %)", *report.error.sampling) : "not known";
    if (const auto limit = sampling_limit(report)) sampling += fmt::format(", at most {:.3g} (95 %)", *limit);
    remark(fmt::format("{:.4g} sample{} per pixel, {}: bound of truncation {:.3g}, estimate of sampling {}\n",
                       report.samples, report.samples == 1 ? "" : "s", duration_text(report.seconds),
                       report.error.truncation, sampling));
}

Result<Done> write_statistics(const RenderRequest& request, const Plan& plan, const RenderOutcome& outcome,
                              const StokesImage& image, const RenderTiming& timing, int threads,
                              double film_bytes_per_pixel) {
    const RenderStatistics& s = outcome.progress.statistics;
    Json out;
    out["tool"] = "polariscope";
    out["tool_version"] = program_version();
    out["kernel_features"] = plan.features.kernel;
    out["precision"] = "f64";
    out["threads"] = threads;
    out["scene"] = request.scene.scene;
    out["scene_hash"] = image.attributes.at("scene_hash");
    for (const RenderSetting& setting : render_settings()) add_setting(out, setting, plan.settings);
    if (outcome.open_ended) out["spp_wanted"] = nullptr;
    out["trees_per_sample"] = plan.groups.size();
    out["spp"] = outcome.progress.film.fewest_samples;
    out["spp_mean"] = outcome.progress.film.mean_samples;
    out["t_load_s"] = timing.load_s;
    out["t_render_wall_s"] = outcome.seconds;
    out["t_render_cpu_s"] = timing.render_cpu_s;
    out["t_output_s"] = timing.output_s;
    out["camera_samples"] = s.samples;
    out["rays"] = s.nodes;
    out["nodes_mean"] =
        s.samples > 0 ? static_cast<double>(s.nodes) / static_cast<double>(s.samples * plan.groups.size()) : 0.0;
    out["nodes_max"] = s.most_nodes;
    out["residual_mean"] = mean(image.residual);
    out["residual_max"] = largest(image.residual);
    out["tail_mean"] = mean(image.tail);
    out["brightest"] = image.brightest;
    out["energy_defect_max"] = s.worst_energy_defect;
    out["failures"] = s.failures;
    out["film_bytes_per_pixel"] = film_bytes_per_pixel;
    out["error"] = error_json(outcome.progress.film.error);
    if (request.error) out["error_rule"] = error_rule_json(outcome);
    out["stop_reason"] = stop_text(outcome);
    return write_file(request.statistics, out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

namespace {

void print_picture(const RenderRequest& request, const RenderOutcome& outcome, const StokesImage& image) {
    const std::string guessed = image.tail.empty() ? ""
                                                   : fmt::format(", estimated by one random path at most {:.3g} %",
                                                                 100.0 * largest(image.tail));
    const RenderStatistics& statistics = outcome.progress.statistics;
    const double samples = static_cast<double>(statistics.samples) / static_cast<double>(image.pixel_count());
    fmt::print("{}: {}x{}, {} wavelength{}, {}{}, {} rays, untraced at most {:.3g} % of a pixel{}\n",
               printable(request.output), image.width, image.height, image.bands.size(),
               image.bands.size() == 1 ? "" : "s",
               samples != 1.0 ? fmt::format("{:.3g} samples per pixel, ", samples) : "", duration_text(outcome.seconds),
               count_text(statistics.nodes), 100.0 * largest(image.residual), guessed);
    if (outcome.progress.reason != StopReason::error) return;
    const ErrorReport& report = outcome.reports.back();
    const auto last = last_to_fall(outcome.reports, *outcome.progress.goal);
    const std::string sampling = report.error.random_samples
                                     ? fmt::format(", {:.3g} (95 %) by sampling", sampling_limit(report).value_or(0.0))
                                     : (report.error.sampling ? "" : ", what random paths may miss included");
    fmt::print("{}: error below {:.3g} of the picture: at most {:.3g} by truncation{}{}\n", printable(request.output),
               *request.error, report.error.truncation, sampling,
               last ? fmt::format("; {} was the last to fall", part_text(*last)) : "");
}

/// Why the picture is less than what was asked for; empty if it is not.
std::string shortfall(const RenderRequest& request, const RenderOutcome& outcome) {
    const std::string after = duration_text(outcome.seconds);
    const std::string samples = fmt::format("{:.3g} % of the samples", 100.0 * outcome.progress.done);
    const std::string share = outcome.open_ended ? "what was done" : samples;
    switch (outcome.progress.reason) {
        case StopReason::cancelled:
            return fmt::format("stopped after {}; {} holds {}", after, printable(request.output), share);
        case StopReason::time:
            if (outcome.progress.film.fewest_samples == 0)
                return fmt::format(
                    "the time limit came after {}, before every pixel had a sample; {} is black where "
                    "there is none\n  hint: a longer --time, or a smaller --size",
                    after, printable(request.output));
            if (outcome.open_ended && !request.error) return {};
            return fmt::format("the time limit came after {}; {} holds {}", after, printable(request.output), share);
        case StopReason::truncation:
            return fmt::format(
                "no residual brings the light that is not traced below {:.3g} of the picture, its share of {:.3g}; {} "
                "holds "
                "what was done\n  hint: a larger --node-budget, --mode area, or no --depth",
                outcome.progress.goal->truncation(), *request.error, printable(request.output));
        case StopReason::dark:
            return fmt::format(
                "no light in {} samples per pixel: a black picture has no relative error; {} holds what was done\n"
                "  hint: is there a lamp that the camera can see, and does it face the scene?",
                outcome.progress.film.fewest_samples, printable(request.output));
        case StopReason::samples:
            if (!request.error) return {};
            return fmt::format("the samples ended before the error fell below {:.3g}\n  hint: a larger --spp, or none",
                               *request.error);
        case StopReason::none:
        case StopReason::error:
        case StopReason::memory:
            break;
    }
    return {};
}

}  // namespace

int conclude(const RenderRequest& request, const RenderOutcome& outcome, const StokesImage& image) {
    constexpr int less_than_asked_for = 10;
    if (!request.quiet) print_picture(request, outcome, image);
    const std::string complaint = shortfall(request, outcome);
    if (!complaint.empty()) remark(fmt::format("polariscope: {}\n", complaint));
    const RenderStatistics& statistics = outcome.progress.statistics;
    if (statistics.failures > 0) {
        remark(
            fmt::format("polariscope: self-check failed in {} of {} samples (energy, not-a-number or a leaking solid)\n"
                        "  hint: the picture is written; its channel 'failures' counts them per pixel\n",
                        statistics.failures, statistics.samples));
        return self_check_failed;
    }
    if (outcome.progress.reason == StopReason::cancelled) return 128 + outcome.signal;
    return complaint.empty() ? 0 : less_than_asked_for;
}

}  // namespace pol
