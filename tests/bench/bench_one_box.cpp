// SPDX-License-Identifier: Apache-2.0
// What generality costs a scene that needs none: the engine's kernel against one that was written for that scene alone.
// The goal is a ratio of 1.3.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <atomic>
#include <ctime>
#include <memory>
#include <stdexcept>
#include <vector>

#include "bench/one_box.h"
#include "io/scenes/scene_file.h"
#include "plan/compile.h"
#include "render/render_pass.h"

namespace pol::bench {
namespace {

/// Of this program, so that what else runs on the machine does not count.
double cpu_seconds() {
    return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

std::shared_ptr<const Plan> plan_of_one_box() {
    auto scene = parse_scene(one_box_scene, "one-box.yaml", ".");
    if (!scene) throw std::runtime_error(to_string(scene.error()));
    auto plan = compile(scene.value());
    if (!plan) throw std::runtime_error(to_string(plan.error()));
    return std::move(plan).value();
}

/// Both in turn, the same picture; the ratio is the median over the rounds.
void engine_over_hand_written(benchmark::State& state) {
    const auto plan = plan_of_one_box();
    const auto tracer = make_pass_tracer(*plan);
    const int width = plan->settings.width;
    const int height = plan->settings.height;
    const std::atomic<bool> cancelled{false};
    TileBuffer buffer;
    buffer.rect = {0, 0, width, height};
    std::vector<double> ratios;
    double engine_s = 0.0;
    double hand_written_s = 0.0;
    for (auto _ : state) {
        double begin = cpu_seconds();
        tracer->trace({0, 1}, cancelled, buffer);
        const double engine = cpu_seconds() - begin;
        begin = cpu_seconds();
        const std::vector<Stokes<double>> picture = one_box_picture(plan->camera, width, height);
        const double hand_written = cpu_seconds() - begin;
        if (!(relative_difference(buffer.stokes, picture) <= 1e-12)) state.SkipWithError("the pictures differ");
        ratios.push_back(engine / hand_written);
        engine_s += engine;
        hand_written_s += hand_written;
    }
    std::sort(ratios.begin(), ratios.end());
    const double samples = static_cast<double>(width) * height * static_cast<double>(ratios.size());
    state.counters["ratio"] = ratios.empty() ? 0.0 : ratios[ratios.size() / 2];
    state.counters["engine_ns"] = engine_s / samples * 1e9;
    state.counters["hand_written_ns"] = hand_written_s / samples * 1e9;
}
BENCHMARK(engine_over_hand_written)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pol::bench
