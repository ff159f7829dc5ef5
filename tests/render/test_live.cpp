// SPDX-License-Identifier: Apache-2.0
// A job that somebody watches: preview first, important tiles first, and what a status line shows; the finished picture
// is the one that nobody watched.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <thread>
#include <variant>
#include <vector>

#include "render/render_job.h"
#include "support/render_scene.h"

namespace pol {
namespace {

std::shared_ptr<const Plan> picture(const std::string& name, int samples, SampleMode mode = SampleMode::area) {
    Scene scene = test::shipped_scene(name);
    scene.render.width = 40;
    scene.render.height = 36;
    scene.render.mode = mode;
    scene.render.samples_per_pixel = samples;
    scene.render.node_budget = 60;
    return test::plan_of(scene);
}

RenderOptions live() {
    RenderOptions options;
    options.watch = Watch::live;
    return options;
}

void finish(Renderer& renderer) {
    renderer.wait();
}

TEST(LiveRender, GivesTheSameBitsAsARenderThatNobodyWatches) {
    for (const char* name : {"paper-glass-polarized", "cube-calcite"}) {
        const auto plan = picture(name, 5);
        const StokesImage reference = test::render(plan, 1, 32);
        for (const int threads : {1, 3})
            for (const int tile : {8, 32}) {
                Renderer renderer(threads, tile);
                renderer.start(plan, live());
                finish(renderer);
                const StokesImage image = renderer.snapshot();
                EXPECT_EQ(image.stokes, reference.stokes);
                EXPECT_EQ(image.residual, reference.residual);
                EXPECT_EQ(image.tail, reference.tail);
                EXPECT_EQ(image.samples, reference.samples);
                EXPECT_EQ(image.sampling_error, reference.sampling_error);
                EXPECT_EQ(renderer.progress().statistics.samples, 40U * 36U * 5U) << "the preview is not counted";
            }
    }
}

// The preview of a block, whatever its level, is sample 0 of its middle pixel, with fewer branches and a larger
// residual. This scene needs few branches; with that residual the preview is the very light of the finished pixel.
TEST(LiveRender, ThePreviewIsTheLightOfTheMiddleOfEachBlock) {
    Scene scene = test::shipped_scene("crossed-polarizers");
    scene.render.residual = preview_residual;
    scene.render.width = 40;
    scene.render.height = 36;
    const auto plan = test::plan_of(scene);
    std::mutex mutex;
    std::vector<TileSnapshot> previews;
    std::vector<Version> seen(100, 0);
    Renderer* watched = nullptr;
    Renderer renderer(1, 8, [&] {
        const std::scoped_lock lock(mutex);
        if (watched == nullptr) return;
        for (int i = 0; i < watched->film().tile_count(); ++i) {
            auto tile = watched->film().tile_if_newer(i, seen[static_cast<std::size_t>(i)]);
            if (tile && tile->preview) previews.push_back(std::move(*tile));
        }
    });
    {
        const std::scoped_lock lock(mutex);
        watched = &renderer;
    }
    renderer.start(plan, live());
    finish(renderer);
    const StokesImage image = renderer.snapshot();
    const std::scoped_lock lock(mutex);
    EXPECT_GE(previews.size(), 25U);  // 5 x 5 tiles, one per block of the first level
    const std::vector<PreviewGrid> levels = preview_levels(*plan);
    for (const TileSnapshot& tile : previews) {
        EXPECT_EQ(tile.image.samples[0], 0U);
        for (int y = tile.rect.y0; y < tile.rect.y1; ++y)
            for (int x = tile.rect.x0; x < tile.rect.x1; ++x) {
                const Stokes<double>& shown = tile.image.at(0, tile.image.pixel(x - tile.rect.x0, y - tile.rect.y0));
                const bool is_of_a_level = std::any_of(levels.begin(), levels.end(), [&](const PreviewGrid& level) {
                    const auto middle = [&](int at) { return at / level.stride * level.stride + level.stride / 2; };
                    return shown == image.at(0, image.pixel(middle(x), std::min(middle(y), 35)));
                });
                EXPECT_TRUE(is_of_a_level) << x << ", " << y;
            }
    }
}

// 4 x 2 blocks of 8 x 8 pixels, each a tile. Light only in block 2: it is bright and has two edges; block 1 has one
// edge with it; block 7 has untraced light. The others are alike and stay in the order of lines.
TEST(LiveRender, LightContrastAndDoubtMakeATileImportant) {
    Plan plan;
    plan.settings.width = 32;
    plan.settings.height = 16;
    plan.wavelengths_nm = {580.0};
    plan.brightest = {2.0};
    plan.groups.resize(1);
    const PreviewGrid grid = preview_levels(plan).front();
    ASSERT_EQ(grid.stride, 8);
    ASSERT_EQ(grid.columns, 4);
    ASSERT_EQ(grid.rows, 2);
    TileImportance importance(plan, grid);
    for (const int row : {1, 0}) {
        PreviewStrip strip;
        strip.row = row;
        strip.stokes.assign(4, {});
        strip.residual.assign(4, 0.0);
        strip.tail.assign(4, 0.0);
        if (row == 0) strip.stokes[2].s0 = 1.0;
        if (row == 1) strip.residual[3] = 0.1;
        importance.add(strip);
    }
    EXPECT_EQ(importance.order(cut_tiles(32, 16, 8)), (std::vector<int>{2, 1, 7, 0, 3, 4, 5, 6}));
}

// The order of work, not the picture, depends on where somebody looks; what is not seen comes later, not never.
TEST(LiveRender, WhatSomebodyLooksAtComesFirst) {
    const auto plan = picture("cube-glass", 4);
    RenderJob job(plan, 1, {}, std::nullopt, 8);
    ASSERT_EQ(job.tiles.size(), 25U);
    const TileRect seen{16, 8, 24, 15};  // tile 7 alone: 16 is where it begins, 24 where the next one does
    std::vector<int> order;
    std::vector<std::uint32_t> samples(job.tiles.size(), 0);
    while (job.has_work()) {
        const auto task = std::get<TileTask>(job.take(seen));
        order.push_back(task.tile);
        samples[static_cast<std::size_t>(task.tile)] += task.samples.end - task.samples.begin;
        EXPECT_FALSE(job.deliver(task, {}));
    }
    EXPECT_EQ((std::vector<int>(order.begin(), order.begin() + 5)), (std::vector<int>{7, 7, 7, 0, 1}));
    EXPECT_EQ(samples, std::vector<std::uint32_t>(25, 4));

    const StokesImage reference = test::render(plan, 1, 32);
    Renderer renderer(2, 8);
    renderer.look_at({30, 30, 1000, 1000});
    renderer.start(plan, live());
    renderer.look_at(seen);
    finish(renderer);
    EXPECT_EQ(renderer.snapshot().stokes, reference.stokes);
}

/// Delivers what a job asks for, each level of the preview in `seconds` by the clock; the strides in their order.
std::vector<int> levels_shown(double seconds) {
    const auto plan = picture("cube-glass", 1, SampleMode::point);
    RenderJob job(plan, 1, live(), std::nullopt, 8);
    std::vector<int> strides;
    auto now = RenderJob::Clock::now();
    while (job.has_work()) {
        const RenderTask task = job.take();
        const auto* row = std::get_if<PreviewTask>(&task);
        if (row == nullptr) break;
        const PreviewGrid& level = job.previews[static_cast<std::size_t>(row->level)];
        if (strides.empty() || strides.back() != level.stride) {
            strides.push_back(level.stride);
            now += std::chrono::duration_cast<RenderJob::Clock::duration>(std::chrono::duration<double>(seconds));
        }
        PreviewStrip strip;
        strip.stride = level.stride;
        strip.row = row->row;
        strip.stokes.assign(static_cast<std::size_t>(level.columns), {});
        strip.residual.assign(strip.stokes.size(), 0.0);
        strip.tail = strip.residual;
        job.deliver(*row, strip, now);
    }
    return strides;
}

// At 10 ms for a 64th of the pixels the whole picture takes 0.64 s: an eye would see a mosaic of blocks and pixels
// meanwhile. At 2 ms all of it is there in 0.13 s.
TEST(LiveRender, ASlowPictureSharpensInLevelsAndAFastOneAtOnce) {
    EXPECT_EQ(levels_shown(0.010), (std::vector<int>{8, 4})) << "10 ms for a 16th: the rest is there in 0.16 s";
    EXPECT_EQ(levels_shown(0.100), (std::vector<int>{8, 4, 2}));
    EXPECT_EQ(levels_shown(0.002), (std::vector<int>{8}));
}

TEST(LiveRender, ProgressSaysWhatAStatusLineShows) {
    const auto plan = picture("cube-calcite", 1 << 20);
    Renderer renderer(2, 8);
    EXPECT_EQ(renderer.progress().generation, 0U);
    const Generation generation = renderer.start(plan, live());
    EXPECT_EQ(renderer.film().generation(), generation);
    while (renderer.progress().film.fewest_samples < 2) ASSERT_FALSE(renderer.wait_for(0.01));
    const RenderProgress progress = renderer.progress();
    EXPECT_EQ(progress.generation, generation);
    EXPECT_FALSE(progress.finished);
    EXPECT_EQ(progress.reason, StopReason::none);
    EXPECT_LE(progress.under_way.size(), 2U);
    EXPECT_GE(progress.film.mean_samples, 2.0);
    EXPECT_GT(progress.seconds, 0.0);
    ASSERT_TRUE(progress.seconds_left);
    EXPECT_GT(*progress.seconds_left, progress.seconds);
    const StokesImage image = renderer.snapshot();
    EXPECT_GT(progress.film.error.truncation, 0.0);
    EXPECT_LE(progress.film.error.residual_max, plan->settings.residual_in_force());
    EXPECT_LE(progress.film.error.residual_mean, progress.film.error.residual_max);
    ASSERT_TRUE(progress.film.error.sampling);
    EXPECT_GT(*progress.film.error.sampling, 0.0);

    renderer.pause();
    EXPECT_TRUE(renderer.progress().paused);
    const double before = renderer.progress().seconds;
    renderer.wait_for(0.2);
    EXPECT_EQ(renderer.progress().seconds, before) << "a pause does not count";
    renderer.resume();
    EXPECT_FALSE(renderer.progress().paused);
    renderer.cancel();
    finish(renderer);
    EXPECT_EQ(renderer.progress().reason, StopReason::cancelled);
    EXPECT_EQ(renderer.progress().under_way.size(), 0U);
    EXPECT_EQ(renderer.progress().seconds_left, 0.0);
}

TEST(LiveRender, StopsWhenTimeIsUp) {
    RenderOptions options = live();
    options.stop.seconds = 0.3;
    Renderer renderer(2, 8);
    const auto begin = std::chrono::steady_clock::now();
    renderer.start(picture("cube-calcite", 1 << 20), options);
    finish(renderer);
    const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    EXPECT_GE(passed, 0.29);
    EXPECT_LT(passed, 20.0);
    EXPECT_EQ(renderer.progress().reason, StopReason::time);
    EXPECT_NEAR(renderer.progress().seconds, 0.3, 0.3);
}

TEST(LiveRender, OfOneRayPerPixelTheErrorIsTheBoundAlone) {
    const auto plan = picture("paper-glass-polarized", 1, SampleMode::point);
    Renderer renderer(2, 32);
    renderer.start(plan);
    finish(renderer);
    const RenderProgress progress = renderer.progress();
    EXPECT_EQ(progress.reason, StopReason::samples);
    EXPECT_EQ(progress.film.error.sampling, 0.0);
    EXPECT_GT(progress.film.error.truncation, 0.0);
    EXPECT_TRUE(renderer.snapshot().sampling_error.empty());
}

}  // namespace
}  // namespace pol
