// SPDX-License-Identifier: Apache-2.0
#include "render/stop_rules.h"

#include <algorithm>
#include <cmath>

namespace pol {

std::optional<double> sampling_limit(const ErrorReport& report) {
    const PictureError& error = report.error;
    if (!error.random_samples) return error.sampling;
    if (!error.sampling || report.samples < fewest_samples_to_stop) return std::nullopt;
    constexpr double alpha = 0.05;
    const double look = std::ceil(std::log2(static_cast<double>(report.samples) / fewest_samples_to_stop)) + 1.0;
    const double z = std::sqrt(2.0 * std::log(look * (look + 1.0) / (2.0 * alpha)));
    return *error.sampling * std::sqrt(1.0 + 2.0 * z * error.sampling_spread);
}

bool has_fallen(ErrorPart part, const ErrorReport& report, double target) {
    if (part == ErrorPart::truncation) return report.error.truncation <= 0.5 * target;
    if (!report.error.random_samples) return true;  // what is random is within the bound of truncation
    const auto limit = sampling_limit(report);
    return limit && *limit <= 0.5 * target;
}

StopReason judge(const ErrorReport& report, double target) {
    constexpr double light_is_known = 0.25;
    const PictureError& error = report.error;
    if (error.random_samples) {
        if (!error.sampling) return report.samples >= most_dark_samples ? StopReason::dark : StopReason::none;
        if (*error.sampling > std::max(light_is_known, 0.5 * target)) return StopReason::none;
    }
    // Samples average what each of them leaves untraced: more of them leave as much.
    if (!has_fallen(ErrorPart::truncation, report, target)) return StopReason::truncation;
    return has_fallen(ErrorPart::sampling, report, target) ? StopReason::error : StopReason::none;
}

std::optional<ErrorPart> last_to_fall(const std::vector<ErrorReport>& reports, double target) {
    if (reports.empty() || judge(reports.back(), target) != StopReason::error) return std::nullopt;
    for (auto report = reports.rbegin(); report != reports.rend(); ++report) {
        const bool truncation = !has_fallen(ErrorPart::truncation, *report, target);
        const bool sampling = !has_fallen(ErrorPart::sampling, *report, target);
        if (truncation && sampling) {
            const bool truncation_was_larger =
                report->error.sampling && report->error.truncation > *report->error.sampling;
            return truncation_was_larger ? ErrorPart::truncation : ErrorPart::sampling;
        }
        if (truncation) return ErrorPart::truncation;
        if (sampling) return ErrorPart::sampling;
    }
    return std::nullopt;
}

std::optional<double> finer_residual(const ErrorReport& report, double residual, double target) {
    constexpr double margin = 0.5;
    // Rounding errors of a tree add up to less than that (energy_tolerance).
    constexpr double finest = 1e-9;
    const double finer = margin * residual * 0.5 * target / report.error.truncation;
    if (!(finer >= finest)) return std::nullopt;
    return finer;
}

}  // namespace pol
