// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/random.h"
#include "core/vec.h"
#include "plan/plan.h"
#include "tracer/trace.h"

namespace pol {

/// Where in its pixel a sample lies, (0,0) top left to (1,1). Sample 0 is always the centre, so that a click shows the
/// same tree in both modes; of an area picture it is no part (RenderSettings::first_sample). The first, third, ... and
/// the second, fourth, ... of the others each follow the R2 sequence (M. Roberts, "The unreasonable effectiveness of
/// quasirandom sequences", 2018), shifted at random per pixel and half: each sample is uniform in the pixel, and the
/// halves are two independent estimates of it, whose difference tells their error (film/picture_error.h).
inline DVec2 sample_position(SampleMode mode, std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample) {
    if (mode == SampleMode::point || sample == 0) return {0.5, 0.5};
    constexpr double step_x = 0.7548776662466927;  // 1/p, p^3 = p + 1
    constexpr double step_y = 0.5698402909980532;  // 1/p^2
    const RandomKey key{seed, pixel, 0, 0};
    const std::uint32_t half = (sample - 1) % 2;
    const std::uint32_t step = (sample - 1) / 2;
    const double x = random_unit(key, 2 * half) + step_x * static_cast<double>(step);
    const double y = random_unit(key, 2 * half + 1) + step_y * static_cast<double>(step);
    return {x - std::floor(x), y - std::floor(y)};
}

/// The sample of a pixel, as the picture and the explanation both trace it. Its random numbers do not depend on which
/// other wavelengths are asked for.
inline TraceTask sample_task(const Plan& plan, int x, int y, std::uint32_t sample, int group) {
    const auto pixel = static_cast<std::uint32_t>(y * plan.settings.width + x);
    const DVec2 inside = sample_position(plan.settings.mode, plan.settings.seed, pixel, sample);
    TraceTask task;
    task.ray = plan.camera.ray(x + inside.x, y + inside.y);
    task.group = group;
    task.region = plan.camera_region >= 0 ? plan.camera_region : plan.region_at(task.ray.origin);
    task.key = {plan.settings.seed, pixel, sample, plan.groups[static_cast<std::size_t>(group)].key};
    task.residual = plan.settings.residual;
    task.node_budget = plan.settings.node_budget;
    return task;
}

}  // namespace pol
