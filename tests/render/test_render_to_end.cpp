// SPDX-License-Identifier: Apache-2.0
// A render that is waited for, and the clock that ends one.
#include <gtest/gtest.h>

#include <chrono>
#include <stop_token>
#include <thread>

#include "support/render_scene.h"

namespace pol {
namespace {

std::shared_ptr<const Plan> small_plan(int samples) {
    Scene scene = test::shipped_scene("cube-calcite");
    scene.render.width = 40;
    scene.render.height = 36;
    scene.render.mode = SampleMode::area;
    scene.render.samples_per_pixel = samples;
    scene.render.node_budget = 60;
    return test::plan_of(scene);
}

constexpr int endless = 1 << 20;

TEST(RenderToEnd, MakesThePictureAndTellsHowFarItIs) {
    double last = 0.0;
    bool finished = false;
    const FinishedRender render =
        render_to_end(small_plan(8), {}, {.threads = 2, .tile_size = 16}, [&](const RenderProgress& progress) {
            EXPECT_FALSE(finished);
            EXPECT_GE(progress.done, last);
            last = progress.done;
            finished = progress.finished;
        });
    EXPECT_TRUE(finished);
    EXPECT_EQ(last, 1.0);
    EXPECT_EQ(render.progress.reason, StopReason::samples);
    Renderer renderer(1);
    renderer.start(small_plan(8));
    renderer.wait();
    EXPECT_EQ(render.picture.stokes, renderer.snapshot().stokes);
}

TEST(RenderToEnd, StopsWhenAskedAndKeepsWhatIsFinished) {
    std::stop_source stop;
    const FinishedRender render = render_to_end(
        small_plan(endless), {}, {.threads = 2, .tile_size = 16},
        [&](const RenderProgress& progress) {
            if (progress.film.fewest_samples > 0) stop.request_stop();
        },
        stop.get_token());
    EXPECT_EQ(render.progress.reason, StopReason::cancelled);
    EXPECT_LT(render.progress.done, 1.0);
    for (const std::uint32_t samples : render.picture.samples) EXPECT_GT(samples, 0U);
}

TEST(RenderToEnd, DoesNothingIfItIsStoppedBeforehand) {
    std::stop_source stop;
    stop.request_stop();
    const FinishedRender render = render_to_end(small_plan(endless), {}, {.threads = 2}, {}, stop.get_token());
    EXPECT_EQ(render.progress.reason, StopReason::cancelled);
    EXPECT_LT(render.progress.done, 0.01);
}

TEST(Clock, EndsAJobThatNobodyAsksAbout) {
    RenderOptions options;
    options.stop.seconds = 0.2;
    Renderer renderer(2, 16);
    renderer.start(small_plan(endless), options);
    bool finished = false;
    for (int i = 0; i < 200 && !finished; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        finished = renderer.wait_for(0.0);
    }
    EXPECT_TRUE(finished);
    EXPECT_EQ(renderer.progress().reason, StopReason::time);
}

TEST(Clock, OfTheNextJobBeginsAnew) {
    RenderOptions hour;
    hour.stop.seconds = 3600.0;
    RenderOptions moment;
    moment.stop.seconds = 0.05;
    Renderer renderer(2, 16);
    renderer.start(small_plan(endless), hour);
    EXPECT_FALSE(renderer.wait_for(0.02));
    renderer.start(small_plan(endless), moment);
    renderer.wait();
    EXPECT_EQ(renderer.progress().reason, StopReason::time);
    EXPECT_LT(renderer.progress().seconds, 1.0);
}

TEST(Clock, AQuestionCountsTheTimeAndEndsNothing) {
    using std::chrono::milliseconds;
    RenderOptions options;
    options.stop.seconds = 0.5;
    RenderJob job(small_plan(1), 1, options, std::nullopt, 16);
    const auto later = RenderJob::Clock::now() + milliseconds(800);
    EXPECT_GT(job.progress(later).seconds, 0.7);
    EXPECT_FALSE(job.progress(later).finished);
    EXPECT_EQ(job.progress(later).reason, StopReason::none);
    job.look(later);
    EXPECT_TRUE(job.finished());
    EXPECT_EQ(job.progress(later).reason, StopReason::time);
}

TEST(Clock, DoesNotCountASuspendedProgram) {
    using std::chrono::seconds;
    RenderJob job(small_plan(1), 1, {}, std::nullopt, 16);
    const auto later = RenderJob::Clock::now() + seconds(60);
    EXPECT_LT(job.progress(later).seconds, 1.0);
    job.look(later);
    EXPECT_LT(job.progress(later).seconds, 1.0);
}

}  // namespace
}  // namespace pol
