// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "viewer/app/frame_pacer.h"

namespace pol {
namespace {

/// A pacer at rest: its first frames are drawn, each took `cost`.
FramePacer rested(double cost) {
    FramePacer pacer;
    for (int i = 0; i < FramePacer::frames_per_input; ++i) pacer.drawn(0.1 * i, 0.1 * i + cost);
    return pacer;
}

TEST(FramePacer, SleepsWhenNothingHappens) {
    EXPECT_FALSE(rested(0.01).wait(10.0).has_value());
}

TEST(FramePacer, DrawsAtOnceAfterInputAndSettlesInThreeFrames) {
    FramePacer pacer = rested(0.01);
    pacer.input(10.0);
    for (int i = 0; i < 3; ++i) {
        const double now = 10.0 + 0.02 * i;
        EXPECT_EQ(pacer.wait(now), 0.0) << i;
        pacer.drawn(now, now + 0.01);
    }
    EXPECT_FALSE(pacer.wait(10.1).has_value());
}

TEST(FramePacer, DrawsAtMost60FramesASecond) {
    FramePacer pacer = rested(0.001);
    pacer.input(10.0);
    pacer.drawn(10.0, 10.001);
    pacer.input(10.001);
    EXPECT_NEAR(pacer.wait(10.001).value(), 1.0 / 60.0 - 0.001, 1e-12);
}

// 17 ms a frame: measured with two busy tracers on two cores.
TEST(FramePacer, LeavesTheTracerItsTimeWhileTilesArrive) {
    FramePacer pacer = rested(0.017);
    pacer.set_tracing(true);
    double now = 10.0;
    double drawn = 0.0;
    while (now < 30.0) {
        pacer.news();
        now += pacer.wait(now).value();
        pacer.drawn(now, now + 0.017);
        now += 0.017;
        drawn += 0.017;
    }
    EXPECT_LT(drawn / 20.0, 0.045);
    EXPECT_GT(drawn / 20.0, 0.03);
}

TEST(FramePacer, AnswersAnEditWithinATenthOfASecond) {
    FramePacer pacer = rested(0.017);
    pacer.set_tracing(true);
    pacer.input(10.0);
    for (int i = 0; i < 3; ++i) pacer.drawn(10.0 + 0.017 * i, 10.017 + 0.017 * i);
    pacer.news();
    EXPECT_LT(pacer.wait(10.06).value(), 0.1);
}

TEST(FramePacer, FinishesAMapAtFullSpeedWhenNothingIsTraced) {
    FramePacer pacer = rested(0.01);
    pacer.news();
    pacer.drawn(10.0, 10.01);
    pacer.news();
    EXPECT_LT(pacer.wait(10.01).value(), 1.0 / 60.0);
}

TEST(FramePacer, WakesForAnAnimation) {
    FramePacer pacer = rested(0.01);
    pacer.animate(10.0, 0.4);
    EXPECT_NEAR(pacer.wait(10.1).value(), 0.3, 1e-12);
    pacer.drawn(10.4, 10.41);
    EXPECT_FALSE(pacer.wait(10.5).has_value());
}

}  // namespace
}  // namespace pol
