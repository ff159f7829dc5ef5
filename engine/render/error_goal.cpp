// SPDX-License-Identifier: Apache-2.0
#include "render/error_goal.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tracer/sample_task.h"
#include "tracer/trace_sample.h"

namespace pol {

ErrorGoal cheapest_goal(const Plan& plan, double error) {
    const RenderSettings& settings = plan.settings;
    if (settings.mode == SampleMode::point) return {error, 1.0};
    if (settings.depth) return {error, 0.5};
    constexpr int side = 16;
    constexpr double finer = 8.0;
    double branches = 0.0;
    double more_branches = 0.0;
    int group = 0;
    std::vector<Stokes<double>> light;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const int x = static_cast<int>((column + 0.5) / side * settings.width);
            const int y = static_cast<int>((row + 0.5) / side * settings.height);
            TraceTask task = sample_task(plan, x, y, 1, group);
            light.resize(plan.groups[static_cast<std::size_t>(group)].wavelengths.size());
            branches += trace_sample(plan, task, light).nodes;
            task.residual /= finer;
            more_branches += trace_sample(plan, task, light).nodes;
            group = (group + 1) % static_cast<int>(plan.groups.size());
        }
    }
    const double growth = (more_branches - branches) / std::log(finer) / more_branches;
    return {error, std::clamp(growth / (growth + 4.0 / 3.0), 0.01, 0.5)};
}

}  // namespace pol
