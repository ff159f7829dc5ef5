// SPDX-License-Identifier: Apache-2.0
#include "render/stop_rules.h"

#include <algorithm>
#include <cmath>

namespace pol {

bool is_enough_to_judge(double samples, std::size_t pixels) {
    return samples >= 16.0 || samples * static_cast<double>(pixels) >= 65536.0;
}

std::optional<double> sampling_limit(const ErrorReport& report) {
    const PictureError& error = report.error;
    if (!error.random_samples) return error.sampling;
    if (!error.sampling || report.look == 0) return std::nullopt;
    constexpr double alpha = 0.05;
    const double look = report.look;
    const double z = std::sqrt(2.0 * std::log(look * (look + 1.0) / (2.0 * alpha)));
    const double deviations = z * error.sampling_spread;
    return *error.sampling * std::sqrt(std::max(1.0 + 2.0 * deviations, std::exp(2.0 * deviations / std::sqrt(3.0))));
}

bool has_fallen(ErrorPart part, const ErrorReport& report, const ErrorGoal& goal) {
    if (part == ErrorPart::truncation) return report.error.truncation <= goal.truncation();
    if (!report.error.random_samples) return true;  // what is random is within the bound of truncation
    const auto limit = sampling_limit(report);
    return limit && *limit <= goal.sampling();
}

StopReason judge(const ErrorReport& report, const ErrorGoal& goal) {
    constexpr double light_is_known = 0.25;
    const PictureError& error = report.error;
    if (error.random_samples) {
        if (!error.sampling) return report.samples >= most_dark_samples ? StopReason::dark : StopReason::none;
        if (*error.sampling > std::max(light_is_known, goal.sampling())) return StopReason::none;
    }
    // Samples average what each of them leaves untraced: more of them leave as much.
    if (!has_fallen(ErrorPart::truncation, report, goal)) return StopReason::truncation;
    return has_fallen(ErrorPart::sampling, report, goal) ? StopReason::error : StopReason::none;
}

std::optional<ErrorPart> last_to_fall(const std::vector<ErrorReport>& reports, const ErrorGoal& goal) {
    if (reports.empty() || judge(reports.back(), goal) != StopReason::error) return std::nullopt;
    for (auto report = reports.rbegin(); report != reports.rend(); ++report) {
        const bool truncation = !has_fallen(ErrorPart::truncation, *report, goal);
        const bool sampling = !has_fallen(ErrorPart::sampling, *report, goal);
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

std::optional<double> finer_residual(const ErrorReport& report, double residual, const ErrorGoal& goal) {
    constexpr double margin = 0.5;
    // Rounding errors of a tree add up to less than that (energy_tolerance).
    constexpr double finest = 1e-9;
    const double finer = margin * residual * goal.truncation() / report.error.truncation;
    if (!(finer >= finest)) return std::nullopt;
    return finer;
}

std::optional<double> share_needed(const ErrorReport& before, const ErrorReport& now, const ErrorGoal& goal) {
    constexpr double fell = 0.9;
    constexpr double margin = 1.5;
    const double share = margin * now.error.truncation / goal.error;
    const bool is_stuck = now.error.truncation > fell * before.error.truncation;
    return is_stuck && share <= 0.5 ? std::optional(share) : std::nullopt;
}

}  // namespace pol
