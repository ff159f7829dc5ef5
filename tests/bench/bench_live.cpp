// SPDX-License-Identifier: Apache-2.0
// What a person at the window waits for: the first picture after opening, the first tiles after an edit, and what
// watching costs.
#include <benchmark/benchmark.h>

#include <chrono>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/scenes/scene_file.h"
#include "plan/compile.h"
#include "render/renderer.h"

namespace pol {
namespace {

using Clock = std::chrono::steady_clock;

std::shared_ptr<const Plan> calcite(int width, int height, int wavelengths) {
    auto scene = load_scene(std::string(POL_ASSETS) + "/scenes/paper-calcite-unpolarized.yaml");
    if (!scene) throw std::runtime_error(to_string(scene.error()));
    RenderSettings& settings = scene.value().render;
    settings.width = width;
    settings.height = height;
    settings.mode = SampleMode::area;
    settings.samples_per_pixel = 64;
    settings.wavelengths_nm.clear();
    for (int w = 0; w < wavelengths; ++w) settings.wavelengths_nm.push_back(580.0 + 10.0 * w);
    auto plan = compile(scene.value());
    if (!plan) throw std::runtime_error(to_string(plan.error()));
    return std::move(plan).value();
}

RenderOptions live() {
    RenderOptions options;
    options.watch = Watch::live;
    return options;
}

/// Seconds until `there` holds, looking as often as a fast window would.
double seconds_until(const std::function<bool()>& there) {
    const auto begin = Clock::now();
    while (!there()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

bool every_tile_shows_something(const Film& film, std::vector<Version>& seen) {
    bool all = true;
    for (int i = 0; i < film.tile_count(); ++i) {
        Version& version = seen[static_cast<std::size_t>(i)];
        if (version == 0) all = film.tile_if_newer(i, version).has_value() && all;
    }
    return all;
}

/// Argument: wavelengths.
void first_preview(benchmark::State& state) {
    const auto plan = calcite(1280, 800, static_cast<int>(state.range(0)));
    Renderer renderer(hardware_threads(), 16);
    for (auto _ : state) {
        const auto begin = Clock::now();
        renderer.start(plan, live());
        std::vector<Version> seen(static_cast<std::size_t>(renderer.film().tile_count()), 0);
        seconds_until([&] { return every_tile_shows_something(renderer.film(), seen); });
        state.SetIterationTime(std::chrono::duration<double>(Clock::now() - begin).count());
    }
    renderer.cancel();
}

/// From start() with another plan, in the middle of a job, to the first tile with all its samples 0.
void first_tile_after_restart(benchmark::State& state) {
    const auto plan = calcite(1280, 800, 1);
    const auto other = calcite(1280, 800, 1);
    Renderer renderer(hardware_threads(), 16);
    bool odd = false;
    for (auto _ : state) {
        renderer.wait_for(0.5);
        const auto begin = Clock::now();
        renderer.start(odd ? plan : other, live());
        odd = !odd;
        seconds_until([&] { return renderer.progress().statistics.samples > 0; });
        state.SetIterationTime(std::chrono::duration<double>(Clock::now() - begin).count());
    }
    renderer.cancel();
}

/// How long start() itself takes, which the window's thread waits for.
void start_alone(benchmark::State& state) {
    const auto plan = calcite(1280, 800, 1);
    Renderer renderer(hardware_threads(), 16);
    for (auto _ : state) renderer.start(plan, live());
    renderer.cancel();
}

/// Means of 1024 x 768 pixels at 21 wavelengths, with sampling errors.
void snapshot(benchmark::State& state) {
    FilmLayout layout;
    layout.width = 1024;
    layout.height = 768;
    for (int w = 0; w < 21; ++w) layout.group_of_wavelength.push_back(w);
    layout.group_count = 21;
    layout.brightest.assign(21, 1.0);
    layout.random_samples = true;
    Film film;
    film.reset(layout, 1);
    for (const TileRect& rect : cut_tiles(layout.width, layout.height, layout.tile_size)) {
        TileBuffer pass;
        pass.generation = 1;
        pass.rect = rect;
        pass.samples = 2;
        pass.stokes.assign(rect.pixel_count() * 21, {1.0, 0.5, 0.25, 0.125});
        pass.odd_minus_even = pass.stokes;
        pass.residual.assign(rect.pixel_count() * 21, 0.1);
        pass.tail.assign(rect.pixel_count() * 21, 0.0);
        pass.failures.assign(rect.pixel_count(), 0);
        film.merge(pass);
    }
    for (auto _ : state) benchmark::DoNotOptimize(film.snapshot());
}

/// Adding a pass of a tile of 32 x 32 pixels and measuring its error. Argument: wavelengths.
void merge(benchmark::State& state) {
    const auto wavelengths = static_cast<std::size_t>(state.range(0));
    FilmLayout layout;
    layout.width = layout.height = 32;
    layout.group_of_wavelength.assign(wavelengths, 0);
    layout.brightest.assign(wavelengths, 1.0);
    layout.random_samples = true;
    Film film;
    film.reset(layout, 1);
    TileBuffer pass;
    pass.generation = 1;
    pass.rect = {0, 0, 32, 32};
    pass.samples = 1;
    pass.stokes.assign(1024 * wavelengths, {1.0, 0.5, 0.25, 0.125});
    pass.odd_minus_even = pass.stokes;
    pass.residual.assign(1024, 0.1);
    pass.tail.assign(1024, 0.0);
    pass.failures.assign(1024, 0);
    for (auto _ : state) benchmark::DoNotOptimize(film.merge(pass));
}

BENCHMARK(first_preview)->Arg(1)->Arg(21)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(5);
BENCHMARK(first_tile_after_restart)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(5);
BENCHMARK(start_alone)->Unit(benchmark::kMillisecond);
BENCHMARK(snapshot)->Unit(benchmark::kMillisecond);
BENCHMARK(merge)->Arg(1)->Arg(21)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace pol
