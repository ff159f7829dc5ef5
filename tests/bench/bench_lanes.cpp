// SPDX-License-Identifier: Apache-2.0
// Samples per second of the kernels that follow branches one by one and side by side, on G1, G2, a brilliant of N-BK7
// and a ball.
#include <benchmark/benchmark.h>

#include <atomic>
#include <memory>
#include <string>

#include "io/scenes/scene_file.h"
#include "plan/compile.h"
#include "render/render_pass.h"

namespace pol {
namespace {

std::shared_ptr<const Plan> plan_of(const std::string& name) {
    Scene scene = load_scene(std::string(POL_ASSETS) + "/scenes/bench/" + name + ".yaml").value();
    scene.render.width = scene.render.height = 64;
    scene.render.samples_per_pixel = 16;
    return compile(scene).value();
}

void trace_picture(benchmark::State& state, const std::string& name, Follow follow) {
    const auto plan = plan_of(name);
    const auto tracer = make_pass_tracer(*plan, follow);
    const std::atomic<bool> cancelled{false};
    TileBuffer buffer;
    buffer.rect = {0, 0, plan->settings.width, plan->settings.height};
    std::uint64_t samples = 0;
    for (auto _ : state) samples += tracer->trace({0, 16}, cancelled, buffer).samples;
    state.SetItemsProcessed(static_cast<std::int64_t>(samples));
}
BENCHMARK_CAPTURE(trace_picture, g1_one_by_one, "g1", Follow::one_by_one);
BENCHMARK_CAPTURE(trace_picture, g1_side_by_side, "g1", Follow::side_by_side);
BENCHMARK_CAPTURE(trace_picture, g2_one_by_one, "g2", Follow::one_by_one);
BENCHMARK_CAPTURE(trace_picture, g2_side_by_side, "g2", Follow::side_by_side);
BENCHMARK_CAPTURE(trace_picture, n_bk7_one_by_one, "g1-n-bk7", Follow::one_by_one);
BENCHMARK_CAPTURE(trace_picture, n_bk7_side_by_side, "g1-n-bk7", Follow::side_by_side);
BENCHMARK_CAPTURE(trace_picture, ball_one_by_one, "glass-ball", Follow::one_by_one);
BENCHMARK_CAPTURE(trace_picture, ball_side_by_side, "glass-ball", Follow::side_by_side);

}  // namespace
}  // namespace pol
