// SPDX-License-Identifier: Apache-2.0
// What the picture costs per frame: bringing light to the GPU, and drawing it, at 1280 x 800 and 21 wavelengths.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "io/pictures/exr_file.h"
#include "support/egl_context.h"
#include "viewer/gl/gl.h"
#include "viewer/picture/picture_renderer.h"

namespace pol {
namespace {

StokesImage film(std::size_t wavelengths) {
    StokesImage image;
    image.width = 1280;
    image.height = 800;
    for (std::size_t w = 0; w < wavelengths; ++w) image.bands.push_back({400.0 + 15.0 * static_cast<double>(w), {}});
    image.brightest.assign(wavelengths, 1.0);
    for (std::size_t i = 0; i < wavelengths * image.pixel_count(); ++i) {
        const double turn = 1e-3 * static_cast<double>(i % 100'003);
        image.stokes.push_back({1.0, 0.6 * std::cos(turn), 0.6 * std::sin(turn), 0.3});
    }
    image.residual.assign(image.pixel_count(), 1e-3);
    return image;
}

/// A session that shows the film, and its renderer.
struct Shown {
    explicit Shown(std::size_t wavelengths) {
        const auto file =
            std::filesystem::temp_directory_path() / ("polariscope-bench-" + std::to_string(::getpid()) + ".exr");
        if (write_exr(film(wavelengths), file)) session.open(file);
        std::filesystem::remove(file);
        if (auto made = PictureRenderer::create()) renderer = std::move(made).value();
    }
    EglContext context;
    Session session;
    std::unique_ptr<PictureRenderer> renderer;
};

Shown& shown() {
    static Shown one(21);
    return one;
}

/// A polarimeter that turns changes the light of every pixel.
void turning_polarimeter(benchmark::State& state) {
    Session& session = shown().session;
    shown().renderer->upload(session);
    double axis = 0.0;
    for (auto _ : state) {
        axis += 0.01;
        session.set_polarimeter({{{PolarimeterElementKind::polarizer, true, axis, 0.0}}});
        shown().renderer->upload(session);
        glFinish();
    }
    session.set_polarimeter({});
}
BENCHMARK(turning_polarimeter)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Everything of a picture that was not shown before.
void new_picture(benchmark::State& state) {
    for (auto _ : state) {
        auto renderer = PictureRenderer::create();
        renderer.value()->upload(shown().session);
        glFinish();
    }
}
BENCHMARK(new_picture)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The whole viewport, drawn anew.
void draw_map(benchmark::State& state) {
    Session& session = shown().session;
    session.change_view().quantity = static_cast<Quantity>(state.range(0));
    session.change_transform() = {static_cast<double>(state.range(1)) / 100.0, {0.0, 0.0}};
    shown().renderer->upload(session);
    state.SetLabel(std::string(info(session.view().quantity).name));
    for (auto _ : state) {
        session.change_view().exposure = session.view().exposure == 0.0 ? 0.001 : 0.0;  // never the same view twice
        shown().renderer->render(session, 1280, 800, 1.0);
        glFinish();
    }
}
BENCHMARK(draw_map)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->ArgsProduct({benchmark::CreateDenseRange(0, static_cast<int>(Quantity::samples), 1), {100}})
    ->ArgsProduct({{static_cast<int>(Quantity::dop)}, {45, 300}});

}  // namespace
}  // namespace pol
