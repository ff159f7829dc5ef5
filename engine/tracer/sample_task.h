// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/random.h"
#include "core/sobol.h"
#include "core/vec.h"
#include "plan/plan.h"
#include "tracer/trace.h"

namespace pol {

/// Where in its pixel a sample lies, (0,0) top left to (1,1). Sample 0 is always the centre, so that a click shows the
/// same tree in both modes; of an area picture it is no part (RenderSettings::first_sample), and no other sample meets
/// the centre. The first, third, ... and the second, fourth, ... of the others each follow the first two dimensions of
/// Sobol's sequence, Owen-scrambled apart for every pixel and half: each sample is uniform in the pixel, and the halves
/// are two independent estimates of it, whose difference tells their error (film/picture_error.h). Each half is a
/// (0,2)-sequence: 2^n of it from a multiple of 2^n on have one sample in every box of width 2^-m and height 2^(m-n).
/// `places` is WavelengthGroup::places: the noise of wavelengths that have places of their own averages out in a color.
inline DVec2 sample_position(SampleMode mode, std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample,
                             std::uint32_t places = 0) {
    if (mode == SampleMode::point || sample == 0) return {0.5, 0.5};
    const RandomKey key{seed, pixel, 0, places};
    const std::uint32_t half = (sample - 1) % 2;
    const std::uint32_t step = (sample - 1) / 2;
    const auto coordinate = [&](std::uint32_t axis, std::uint32_t sobol) {
        return (owen_scrambled(sobol, random_bits(key, 2 * half + axis)) + 0.5) * 0x1p-32;
    };
    return {coordinate(0, reversed_bits(step)), coordinate(1, sobol_second(step))};
}

/// The same in the picture, for CameraModel::ray.
inline DVec2 sample_place(const Plan& plan, int x, int y, std::uint32_t sample, int group) {
    const auto pixel = static_cast<std::uint32_t>(y * plan.settings.width + x);
    return DVec2(x, y) + sample_position(plan.settings.mode, plan.settings.seed, pixel, sample,
                                         plan.groups[static_cast<std::size_t>(group)].places);
}

/// The sample of a pixel, as the picture and the explanation both trace it. Its random numbers do not depend on which
/// other wavelengths are asked for.
inline TraceTask sample_task(const Plan& plan, int x, int y, std::uint32_t sample, int group) {
    const auto pixel = static_cast<std::uint32_t>(y * plan.settings.width + x);
    TraceTask task;
    task.key = {plan.settings.seed, pixel, sample, plan.groups[static_cast<std::size_t>(group)].key};
    const DVec2 place = sample_place(plan, x, y, sample, group);
    task.ray = plan.camera.ray(place.x, place.y);
    task.group = group;
    task.region = plan.camera_region >= 0 ? plan.camera_region : plan.region_at(task.ray.origin);
    task.residual = plan.settings.residual_in_force();
    task.until_determined = plan.settings.until_determined();
    task.node_budget = plan.settings.node_budget.value();
    return task;
}

}  // namespace pol
