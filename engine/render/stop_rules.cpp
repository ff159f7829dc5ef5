// SPDX-License-Identifier: Apache-2.0
#include "render/stop_rules.h"

namespace pol {

bool has_fallen(ErrorPart part, const ErrorReport& report, double target) {
    if (part == ErrorPart::truncation) return report.error.truncation <= 0.5 * target;
    const bool is_believed = !report.error.random_samples || report.samples >= fewest_samples_to_stop;
    return report.error.sampling && is_believed && *report.error.sampling <= 0.5 * target;
}

StopReason judge(const ErrorReport& report, double target) {
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
