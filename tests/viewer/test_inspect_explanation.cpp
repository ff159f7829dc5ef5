// SPDX-License-Identifier: Apache-2.0
// The tree of the pinned pixel comes from another thread: it is the tree that explain() finds, or none.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <thread>

#include "support/sanitizers.h"
#include "support/shipped_scenes.h"
#include "viewer/session/session.h"

namespace pol {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Waits until the job has come to an end of whatever kind.
ExplanationStatus ended(const ExplanationJob& job) {
    const auto start = Clock::now();
    while (job.status().state == ExplanationState::running && seconds_since(start) < 30.0)
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    return job.status();
}

/// A scene whose trees never end, cut after so many branches only.
std::shared_ptr<const Plan> endless_plan(int node_budget) {
    Scene scene = test::shipped_scene("cube-calcite");
    scene.render.residual = 0.0;
    scene.render.node_budget = node_budget;
    return test::plan_of(scene);
}

constexpr PixelAddress through_the_cube{256, 240};

TEST(ExplanationJob, FindsTheTreeThatExplainFinds) {
    ExplanationJob job;
    for (const char* name : {"paper-glass-unpolarized", "paper-calcite-polarized", "crossed-polarizers"}) {
        const auto plan = test::plan_of(test::shipped_scene(name));
        const ExplanationRequest request{plan, {plan->settings.width / 2, plan->settings.height / 2}, 0, 0};
        job.ask(request);
        ASSERT_EQ(ended(job).state, ExplanationState::ready) << name;
        const Explanation expected = explain(*plan, request.pixel.x, request.pixel.y, 0, 0);
        const auto found = job.result();
        ASSERT_EQ(found->sample_light, expected.sample_light) << name;
        ASSERT_EQ(found->tree.leaves, expected.tree.leaves) << name;
        ASSERT_EQ(job.status().branches, expected.tree.nodes.size()) << name;
        ASSERT_TRUE(found->exact()) << name;
    }
}

TEST(ExplanationJob, TheNewestRequestWins) {
    const auto plan = endless_plan(3000);
    std::atomic<int> woken = 0;
    ExplanationJob job([&] { ++woken; });
    for (int i = 0; i < 100; ++i) {
        const PixelAddress pixel{100 + i, 240};
        job.ask(ExplanationRequest{plan, pixel, 0, 0});
        if (i % 7 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        const auto result = job.result();
        ASSERT_TRUE(result == nullptr || result->x == pixel.x);
    }
    ASSERT_EQ(ended(job).state, ExplanationState::ready);
    EXPECT_EQ(job.result()->x, 199);
    EXPECT_GE(woken, 1);
    EXPECT_LE(woken, 100);
    job.ask(std::nullopt);
    EXPECT_EQ(job.status().state, ExplanationState::nothing_asked);
    EXPECT_EQ(job.result(), nullptr);
}

TEST(ExplanationJob, CanBeCancelledAndStartedAgain) {
    const auto plan = endless_plan(100'000);
    ExplanationJob job;
    const ExplanationRequest request{plan, through_the_cube, 0, 0};
    job.ask(request);
    while (job.status().branches < 1000) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(job.status().budget, 100'000U);
    job.cancel();
    EXPECT_EQ(job.status().state, ExplanationState::cancelled);
    job.ask(request);  // as every frame does
    EXPECT_EQ(job.status().state, ExplanationState::cancelled);
    EXPECT_EQ(job.result(), nullptr);
    // The worker is free for something else at once.
    const auto start = Clock::now();
    job.ask(ExplanationRequest{endless_plan(100), through_the_cube, 0, 0});
    ASSERT_EQ(ended(job).state, ExplanationState::ready);
    EXPECT_LT(seconds_since(start), 1.0 * test::slowdown);
    job.cancel();  // too late: nothing is running
    EXPECT_EQ(job.status().state, ExplanationState::ready);
    job.restart();
    EXPECT_EQ(ended(job).state, ExplanationState::ready);
}

TEST(ExplanationJob, RefusesATreeThatWouldEatTheMemory) {
    constexpr std::size_t most_branches = 20'000;
    ExplanationJob job({}, most_branches);
    job.ask(ExplanationRequest{endless_plan(100'000'000), through_the_cube, 0, 0});
    const ExplanationStatus status = ended(job);
    ASSERT_EQ(status.state, ExplanationState::failed);
    EXPECT_NE(status.problem.find("more than 20000 branches"), std::string::npos) << status.problem;
    EXPECT_NE(status.problem.find("smaller node budget"), std::string::npos) << status.problem;
    EXPECT_EQ(job.result(), nullptr);
    EXPECT_LT(status.branches, most_branches + 2000) << "it stops soon after";
    EXPECT_LE(sizeof(RayTreeNode) * ExplanationJob::default_most_branches, std::size_t{400'000'000});
}

TEST(ExplanationJob, EndsWithItsOwner) {
    const auto start = Clock::now();
    for (int i = 0; i < 20; ++i) {
        ExplanationJob job;
        job.ask(ExplanationRequest{endless_plan(100'000'000), through_the_cube, 0, 0});
        if (i % 2 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_LT(seconds_since(start), 5.0);
}

/// Runs frames until the explanation is there.
std::shared_ptr<const Explanation> explained(Session& session) {
    const auto start = Clock::now();
    do {
        session.update();
        if (auto found = session.explanation()) return found;
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    } while (seconds_since(start) < 30.0);
    return nullptr;
}

TEST(SessionExplanation, FollowsPinSampleAndWavelength) {
    Session session;
    ASSERT_TRUE(session.open(std::string(POL_ASSETS) + "/scenes/paper-glass-unpolarized.yaml"));
    EXPECT_EQ(session.explanation(), nullptr);
    session.pin({256, 300});
    EXPECT_EQ(session.explanation(), nullptr) << "an update starts it";
    auto found = explained(session);
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->y, 300);
    session.select_branch(3);
    session.update();
    EXPECT_EQ(session.selection().node, 3);

    session.nudge(0, 1);
    EXPECT_EQ(session.explanation(), nullptr) << "of the pixel before";
    found = explained(session);
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->y, 301);
    EXPECT_FALSE(session.selection().node) << "an index into another tree";

    Scene scene = session.current()->scene();
    scene.render.wavelengths_nm = {450.0, 550.0};
    scene.render.mode = SampleMode::area;
    scene.render.samples_per_pixel = 4;
    ASSERT_TRUE(session.current()->edit(scene, "wavelengths"));
    EXPECT_EQ(session.explanation(), nullptr) << "of the plan before";
    session.change_view().band = 1;
    session.select_sample(3);
    found = explained(session);
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->wavelength, 1);
    EXPECT_EQ(found->sample, 3U);
    const Explanation expected = explain(*session.current()->plan(), 256, 301, 3, 1);
    EXPECT_EQ(found->sample_light, expected.sample_light);

    session.select_sample(100);
    EXPECT_EQ(explained(session)->sample, 4U) << "the last there is";
    session.unpin();
    session.update();
    EXPECT_EQ(session.explanation(), nullptr);
    EXPECT_EQ(session.explanation_status().state, ExplanationState::nothing_asked);
}

// The paper's scenes, click to tree, with two workers rendering at the same time: 100 ms are allowed. The limit of the
// test leaves room for a busy machine.
TEST(SessionExplanation, TakesNoTimeForThePapersScenes) {
    for (const char* name : {"paper-glass-unpolarized", "paper-calcite-unpolarized", "paper-calcite-polarized"}) {
        Session session;
        ASSERT_TRUE(session.open(std::string(POL_ASSETS) + "/scenes/" + name + ".yaml"));
        double worst = 0.0;
        std::size_t largest = 0;
        for (int i = 0; i < 12; ++i) {
            const auto start = Clock::now();
            session.pin({170 + 15 * i, 290 - 4 * i});
            const auto found = explained(session);
            ASSERT_NE(found, nullptr);
            worst = std::max(worst, seconds_since(start));
            largest = std::max(largest, found->tree.nodes.size());
        }
        std::printf("%s: click to tree %.1f ms at most, %zu branches at most\n", name, 1e3 * worst, largest);
        EXPECT_LT(worst, 1.0) << name;
    }
}

}  // namespace
}  // namespace pol
