// SPDX-License-Identifier: Apache-2.0
#include "render/error_goal.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "film/picture_error.h"
#include "polarization/coherence_matrix.h"
#include "tracer/sample_task.h"
#include "tracer/trace_sample.h"

namespace pol {

namespace {

/// What a few hundred trees over the picture say, each at one of its wavelengths' groups in turn.
struct TreeSurvey {
    double branches = 0.0;
    double truncation = 0.0;  ///< PictureError::truncation; infinite where the trees met no light
};

TreeSurvey survey(const Plan& plan, double residual) {
    const RenderSettings& settings = plan.settings;
    constexpr int side = 16;
    TreeSurvey found;
    double missing = 0.0;
    double met = 0.0;
    int group = 0;
    std::vector<Stokes<double>> light;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const int x = static_cast<int>((column + 0.5) / side * settings.width);
            const int y = static_cast<int>((row + 0.5) / side * settings.height);
            TraceTask task = sample_task(plan, x, y, 1, group);
            task.residual = residual;
            const std::vector<int>& members = plan.groups[static_cast<std::size_t>(group)].wavelengths;
            light.assign(members.size(), {});
            const TraceResult result = trace_sample(plan, task, light);
            found.branches += result.nodes;
            const double tail = settings.mode == SampleMode::point ? result.tail : 0.0;
            for (std::size_t i = 0; i < members.size(); ++i) {
                const double bound =
                    truncation_bound(result.residual, tail) * plan.brightest[static_cast<std::size_t>(members[i])];
                missing += bound * bound;
                met += frobenius_square(light[i]);
            }
            group = (group + 1) % static_cast<int>(plan.groups.size());
        }
    }
    found.truncation = std::sqrt(missing / met);
    return found;
}

}  // namespace

ErrorGoal cheapest_goal(const Plan& plan, double error) {
    const RenderSettings& settings = plan.settings;
    if (settings.mode == SampleMode::point) return {error, 1.0};
    if (settings.depth) return {error, 0.5};
    constexpr double finer = 8.0;
    const double branches = survey(plan, settings.residual_in_force()).branches;
    const double more_branches = survey(plan, settings.residual_in_force() / finer).branches;
    const double growth = (more_branches - branches) / std::log(finer) / more_branches;
    return {error, std::clamp(growth / (growth + 4.0 / 3.0), 0.01, 0.5)};
}

double residual_for(const Plan& plan, const ErrorGoal& goal) {
    constexpr double finest = 1e-9;
    constexpr double margin = 0.7;  // 256 trees know light and residual of the picture to some ten per cent
    double residual = plan.settings.residual_in_force();
    for (int look = 0; look < 4 && residual > finest; ++look) {
        const double truncation = survey(plan, residual).truncation;
        if (truncation <= margin * goal.truncation()) return residual;
        if (!std::isfinite(truncation)) break;
        residual *= 0.9 * margin * goal.truncation() / truncation;
    }
    return plan.settings.residual_in_force();
}

}  // namespace pol
