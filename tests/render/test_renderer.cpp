// SPDX-License-Identifier: Apache-2.0
// The renderer as a machine: same bits whatever the threads do, and obedience to start, cancel, pause and resume.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "support/render_scene.h"

namespace pol {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A shipped scene, 40 x 36 pixels (no whole number of tiles), some samples a pixel.
std::shared_ptr<const Plan> plan_of_scene(const std::string& name, int samples, int node_budget = 60) {
    Scene scene = test::shipped_scene(name);
    scene.render.width = 40;
    scene.render.height = 36;
    scene.render.mode = SampleMode::area;
    scene.render.samples_per_pixel = samples;
    scene.render.node_budget = node_budget;
    return test::plan_of(scene);
}

/// A picture that takes minutes.
std::shared_ptr<const Plan> endless_picture() {
    return plan_of_scene("cube-calcite", 1 << 20, 1000);
}

void expect_same_bits(const StokesImage& a, const StokesImage& b) {
    EXPECT_EQ(a.stokes, b.stokes);
    EXPECT_EQ(a.residual, b.residual);
    EXPECT_EQ(a.tail, b.tail);
    EXPECT_EQ(a.samples, b.samples);
    EXPECT_EQ(a.failures, b.failures);
}

TEST(Renderer, GivesTheSameBitsForAnyThreadsAndTiles) {
    for (const char* name : {"paper-glass-polarized", "twinned-crystals", "metal-spheres", "crossed-polarizers"}) {
        const auto plan = plan_of_scene(name, 3);
        const StokesImage reference = test::render(plan, 1, 16);
        for (const int threads : {1, 2, 7})
            for (const int tile : {16, 64}) {
                SCOPED_TRACE(std::string(name) + ", threads " + std::to_string(threads) + ", tile " +
                             std::to_string(tile));
                expect_same_bits(test::render(plan, threads, tile), reference);
            }
    }
}

TEST(Renderer, GivesTheSameBitsAfterRestartsInATightLoop) {
    const auto plan = plan_of_scene("paper-glass-polarized", 2);
    const auto other = plan_of_scene("cube-calcite", 2);
    const StokesImage reference = test::render(plan, 1, 16);
    for (const int threads : {2, 7}) {
        Renderer renderer(threads, 16);
        for (int i = 0; i < 50; ++i) {
            renderer.start(other);
            renderer.start(plan);
            if (i % 3 == 0) renderer.wait_for(0.001);
            if (i % 7 == 0) renderer.cancel();
        }
        renderer.start(plan);
        renderer.wait();
        expect_same_bits(renderer.snapshot(), reference);
        const RenderProgress progress = renderer.progress();
        EXPECT_TRUE(progress.finished);
        EXPECT_EQ(progress.done, 1.0);
        EXPECT_EQ(progress.statistics.samples, 40U * 36U * 2U);
    }
}

// The requirement is 50 ms on a free machine; the bound here only tells stopping from going on (the job takes minutes).
TEST(Renderer, StopsSoonWhenCancelled) {
    Renderer renderer(2, 64);
    double slowest = 0.0;
    for (int i = 0; i < 5; ++i) {
        renderer.start(endless_picture());
        EXPECT_FALSE(renderer.wait_for(0.02));
        const auto start = Clock::now();
        renderer.cancel();
        ASSERT_TRUE(renderer.wait_for(20.0));
        slowest = std::max(slowest, seconds_since(start));
        EXPECT_LT(renderer.progress().done, 1.0);
        EXPECT_TRUE(renderer.progress().finished);
    }
    RecordProperty("slowest_cancel_ms", static_cast<int>(slowest * 1e3 + 0.5));
}

TEST(Renderer, StopsSoonInsideOneEndlessTree) {
    Scene scene = test::shipped_scene("cube-calcite");
    scene.render.width = scene.render.height = 1;
    scene.render.node_budget = 1 << 30;
    scene.render.residual = 0.0;
    Renderer renderer(1);
    renderer.start(test::plan_of(scene));
    EXPECT_FALSE(renderer.wait_for(0.02));
    renderer.cancel();
    EXPECT_TRUE(renderer.wait_for(20.0));
    EXPECT_EQ(renderer.snapshot().samples[0], 0U);
}

// What `--time` does: when time is up, what is finished stays, and it is the mean of whole passes.
TEST(Renderer, KeepsWholePassesWhenTimeIsUp) {
    const StokesImage first = test::render(plan_of_scene("paper-glass-polarized", 1, 200));
    Renderer renderer(2, 16);
    renderer.start(plan_of_scene("paper-glass-polarized", 4096, 200));
    while (renderer.progress().statistics.samples < 40U * 36U) renderer.wait_for(0.005);
    renderer.cancel();
    ASSERT_TRUE(renderer.wait_for(20.0));
    const StokesImage image = renderer.snapshot();
    std::uint64_t samples = 0;
    for (std::size_t p = 0; p < image.pixel_count(); ++p) {
        samples += image.samples[p];
        if (image.samples[p] == 1) {
            ASSERT_EQ(image.at(0, p), first.at(0, p));
        }
    }
    EXPECT_EQ(samples, renderer.progress().statistics.samples);
    EXPECT_LT(renderer.progress().done, 1.0);
}

TEST(Renderer, ASnapshotInTheMiddleHoldsWholeTilesAndSaysWhatIsMissing) {
    Renderer renderer(1, 16);
    renderer.start(plan_of_scene("cube-calcite", 1, 3000));  // long enough that this thread sees it on its way
    bool partial = false;
    while (!renderer.wait_for(0.0005)) {
        const StokesImage image = renderer.snapshot();
        for (int y = 0; y < 36; ++y)
            for (int x = 0; x < 40; ++x) {
                const std::size_t p = image.pixel(x, y);
                const std::size_t corner = image.pixel(x / 16 * 16, y / 16 * 16);
                ASSERT_EQ(image.samples[p], image.samples[corner]) << x << "," << y;
                if (image.samples[p] > 0) continue;
                partial = true;
                ASSERT_EQ(image.residual[p], 1.0);
                ASSERT_EQ(image.at(0, p), Stokes<double>{});
            }
    }
    EXPECT_TRUE(partial);
    EXPECT_EQ(renderer.snapshot().brightest.size(), 1U);
}

TEST(Renderer, RestsWhilePausedAndGoesOnToTheSameBits) {
    constexpr int samples = 512;  // about a second of work: this thread is in time to pause it
    const auto plan = plan_of_scene("paper-glass-polarized", samples, 200);
    Renderer renderer(2, 16);
    renderer.start(plan);
    renderer.pause();
    const RenderProgress before = renderer.progress();
    const bool finished = renderer.wait_for(0.3);
    // Each of two workers may finish the pass it is at: 16 x 16 pixels and, if this thread was slow to pause them, up
    // to 16 samples. Without a pause 0.3 s make some 100 000 samples more.
    constexpr std::uint64_t under_way = 2U * 256U * 16U;
    EXPECT_LE(renderer.progress().statistics.samples, before.statistics.samples + under_way);
    const bool could_finish = before.statistics.samples + under_way >= 40U * 36U * samples;
    EXPECT_TRUE(!finished || could_finish);
    renderer.resume();
    renderer.wait();
    expect_same_bits(renderer.snapshot(), test::render(plan));
}

TEST(Renderer, StartsAnewFromAPause) {
    Renderer renderer(2, 16);
    renderer.start(endless_picture());
    renderer.pause();
    renderer.start(plan_of_scene("cube-glass", 1));
    EXPECT_TRUE(renderer.wait_for(20.0));
    EXPECT_EQ(renderer.progress().done, 1.0);
}

TEST(Renderer, WakesItsOwnerAfterEveryTile) {
    std::atomic<int> calls{0};
    Renderer renderer(2, 16, [&calls] { ++calls; });
    renderer.start(plan_of_scene("cube-glass", 3));  // passes: samples 0, 1, 2
    ASSERT_TRUE(renderer.wait_for(20.0));
    for (int i = 0; i < 200 && calls.load() < 27; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_EQ(calls.load(), 3 * 3 * 3);  // 3 x 3 tiles
}

TEST(Renderer, DiesQuietlyInTheMiddleOfAJob) {
    for (int i = 0; i < 10; ++i) {
        Renderer renderer(3, 16);
        renderer.start(endless_picture());
        if (i % 2 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

TEST(Renderer, WithoutAJobHasNothingToWaitFor) {
    Renderer renderer(1);
    EXPECT_TRUE(renderer.wait_for(0.0));
    EXPECT_EQ(renderer.progress().done, 0.0);
    renderer.cancel();
}

}  // namespace
}  // namespace pol
