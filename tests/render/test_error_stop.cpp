// SPDX-License-Identifier: Apache-2.0
// The error rule: what it promises is held against a much deeper render with other random numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "support/render_scene.h"

namespace pol {
namespace {

Scene small(const std::string& name, int size, int node_budget) {
    Scene scene = test::shipped_scene(name);
    scene.render.width = scene.render.height = size;
    scene.render.mode = SampleMode::area;
    scene.render.samples_per_pixel = 1 << 20;
    scene.render.node_budget = node_budget;
    return scene;
}

struct Stopped {
    StokesImage image;
    RenderProgress progress;
    double residual = 0.0;
};

/// Renders until the rule ends it, with finer residuals as it asks for them.
Stopped render_to(Scene scene, double error, int threads = 2, int tile_size = 16) {
    Renderer renderer(threads, tile_size);
    RenderOptions options;
    options.stop.error = error;
    for (;;) {
        renderer.start(test::plan_of(scene), options);
        renderer.wait();
        const RenderProgress progress = renderer.progress();
        if (progress.reason != StopReason::truncation)
            return {renderer.snapshot(), progress, scene.render.residual_in_force()};
        const auto finer = finer_residual(progress.reports.back(), scene.render.residual_in_force(), *progress.goal);
        if (!finer) throw std::runtime_error("no residual is fine enough");
        scene.render.residual = *finer;
    }
}

struct Comparison {
    double error = 0.0;   ///< fro_c against the reference
    double spread = 0.0;  ///< relative standard deviation of error^2 / estimate^2, an upper estimate
};

Comparison compare(const StokesImage& image, const StokesImage& reference) {
    double error = 0.0;
    double light = 0.0;
    double half = 0.0;
    double half_square = 0.0;
    for (std::size_t p = 0; p < image.pixel_count(); ++p) {
        error += frobenius_square(image.at(0, p) - reference.at(0, p));
        light += frobenius_square(reference.at(0, p));
        const double h = frobenius_square(image.sampling_error[p]);
        half += h;
        half_square += h * h;
    }
    // Pixels are independent: the variance of a sum of squares is at most the sum of their squares; twice, since the
    // error itself is as random as its estimate.
    return {std::sqrt(error / light), std::sqrt(2.0 * half_square) / half};
}

void expect_an_honest_stop(Scene scene, double target, int reference_samples) {
    const Stopped stopped = render_to(scene, target);
    EXPECT_EQ(stopped.progress.reason, StopReason::error);
    const PictureError& estimate = stopped.progress.film.error;
    ASSERT_TRUE(estimate.sampling);
    const ErrorGoal& goal = stopped.progress.goal.value();
    EXPECT_DOUBLE_EQ(goal.truncation() + goal.sampling(), target);
    EXPECT_LE(estimate.truncation, goal.truncation());
    EXPECT_LE(sampling_limit(stopped.progress.reports.back()).value(), goal.sampling());

    scene.render.residual = 0.1 * stopped.residual;
    scene.render.samples_per_pixel = reference_samples;
    scene.render.seed = 77;
    ASSERT_GE(reference_samples, 16.0 * stopped.progress.film.mean_samples) << "its own error must not count";
    const StokesImage reference = test::render(test::plan_of(scene), 2);
    const Comparison found = compare(stopped.image, reference);
    // Four standard deviations of the ratio of the roots; 5 % for the error of the reference, which has 16 times the
    // samples of the mean pixel, and of the others pixels with less error: (1/16)^(3/2) of its mean square error with
    // quasi-random samples, 1/16 with random ones.
    const double tolerance = 1.05 + 4.0 * 0.5 * found.spread;
    ASSERT_LT(tolerance, 1.5) << "too few pixels to judge";
    EXPECT_LE(found.error, *estimate.sampling * tolerance + estimate.truncation);
    EXPECT_GE(found.error + estimate.truncation, *estimate.sampling / tolerance);
    EXPECT_LE(found.error, goal.truncation() + goal.sampling() * tolerance);
}

TEST(ErrorStop, GlassIsAsGoodAsItSays) {
    expect_an_honest_stop(small("paper-glass-polarized", 48, 1000), 0.1, 1024);
}

// Most pixels of a larger picture have four samples, those at edges a hundred times as many.
TEST(ErrorStop, GlassInStrataIsAsGoodAsItSays) {
    expect_an_honest_stop(small("bench/g1", 96, 1000), 0.02, 1024);
}

// Every ray splits in calcite, and one random path stands for most branches: noise of another kind than that of edges.
TEST(ErrorStop, CalciteIsAsGoodAsItSays) {
    expect_an_honest_stop(small("paper-calcite-unpolarized", 32, 20), 0.2, 1024);
}

/// True if each pixel is, to the bit, that of the picture in which all pixels have as many samples. Says how many
/// different numbers there are.
void expect_pixels_of_plain_pictures(const StokesImage& image, Scene scene, std::size_t fewest_numbers) {
    const std::set<std::uint32_t> numbers(image.samples.begin(), image.samples.end());
    EXPECT_GE(numbers.size(), fewest_numbers);
    for (const std::uint32_t samples : numbers) {
        scene.render.samples_per_pixel = static_cast<int>(samples);
        const StokesImage plain = test::render(scene);
        for (std::size_t p = 0; p < image.pixel_count(); ++p) {
            if (image.samples[p] != samples) continue;
            ASSERT_EQ(image.at(0, p), plain.at(0, p)) << "pixel " << p << " with " << samples << " samples";
            ASSERT_EQ(image.sampling_error[p], plain.sampling_error[p]);
            ASSERT_EQ(image.residual[p], plain.residual[p]);
        }
    }
}

TEST(ErrorStop, APixelIsTheOneOfAPictureWithAsManySamples) {
    const Scene scene = small("paper-glass-polarized", 96, 1000);
    const Stopped one = render_to(scene, 0.04, 1);
    const Stopped three = render_to(scene, 0.04, 3, 7);
    EXPECT_EQ(one.image.stokes, three.image.stokes);
    EXPECT_EQ(one.image.sampling_error, three.image.sampling_error);
    EXPECT_EQ(one.image.samples, three.image.samples);
    Scene plain = scene;
    plain.render.residual = one.residual;
    expect_pixels_of_plain_pictures(one.image, plain, 3);
}

// Calcite is followed one branch at a time, glass several side by side: the same pixels are listed to both.
TEST(ErrorStop, APixelOfACrystalIsTheOneOfAPictureWithAsManySamples) {
    const Scene scene = small("paper-calcite-unpolarized", 64, 12);
    const Stopped stopped = render_to(scene, 0.1, 2, 7);
    Scene plain = scene;
    plain.render.residual = stopped.residual;
    expect_pixels_of_plain_pictures(stopped.image, plain, 2);
}

// No pixel gets more than were asked for, and where they do not suffice all have them in the end.
TEST(ErrorStop, WhereSamplesEndFirstEveryPixelHasThem) {
    Scene scene = small("paper-glass-polarized", 24, 1000);
    scene.render.samples_per_pixel = 11;
    const Stopped stopped = render_to(scene, 0.01);
    EXPECT_EQ(stopped.progress.reason, StopReason::samples);
    for (const std::uint32_t samples : stopped.image.samples) ASSERT_EQ(samples, 11U);
    Scene plain = scene;
    plain.render.residual = stopped.residual;
    EXPECT_EQ(test::render(plain).stokes, stopped.image.stokes);
}

// Whoever stops at a low estimate stops at a lucky one. A rainbow's caustic lies on a few pixels, which make nearly all
// of the error: the estimate of it is as wrong as it can be. 57 of 60 seeds must be below E; with the estimate alone
// against E/2, looked at after every quarter of the samples, 6 in 60 were not.
TEST(ErrorStop, ALuckyEstimateDoesNotEndIt) {
    constexpr double target = 0.1;
    constexpr int seeds = 60;
    Scene scene = small("water-drop", 16, 1000);
    Scene deep = scene;
    deep.render.residual = 1e-5;
    deep.render.samples_per_pixel = 1 << 14;
    deep.render.seed = 77;
    const StokesImage reference = test::render(test::plan_of(deep), 2);
    int below = 0;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        scene.render.seed = seed;
        const Stopped stopped = render_to(scene, target);
        EXPECT_EQ(stopped.progress.reason, StopReason::error);
        if (compare(stopped.image, reference).error <= target) ++below;
    }
    EXPECT_GE(below, 57);
}

/// A cube of glass that a lamp of a tenth of its size lights from behind.
Scene small_lamp(const char* emission) {
    Scene scene = test::scene_of(std::string(R"(
camera: {position: [1.6, -3, 2.2], target: [0, 0, 0], fov: 28}
media: {glass: 1.5}
objects:
  - {name: cube, shape: {box: {size: 1}}, medium: glass}
  - {name: lamp, )") + emission + "}\n");
    scene.render.width = scene.render.height = 16;
    scene.render.mode = SampleMode::area;
    scene.render.samples_per_pixel = 1 << 20;
    return scene;
}

// The first samples of all 256 pixels miss the lamp: a black picture says nothing of the error, neither that it is out
// of reach nor that it is small.
TEST(ErrorStop, ABlackBeginningIsNoVerdict) {
    Scene scene = small_lamp(
        "shape: {sphere: {radius: 0.03}}, transform: [{translate: [0.2, 0.9, 0.3]}], emission: {radiance: 1}");
    const auto begins_black = [&] {
        Scene first = scene;
        first.render.samples_per_pixel = 1;
        const StokesImage image = test::render(first);
        return std::all_of(image.stokes.begin(), image.stokes.end(),
                           [](const Stokes<double>& s) { return s.s0 == 0.0; });
    };
    while (!begins_black()) ASSERT_LT(++scene.render.seed, 100U);
    const Stopped stopped = render_to(scene, 0.4);
    EXPECT_EQ(stopped.progress.reason, StopReason::error);
    EXPECT_LE(stopped.progress.film.error.truncation, stopped.progress.goal->truncation());
}

// A lamp that shines the other way: nothing will ever be there to be relative to.
TEST(ErrorStop, ThePictureThatStaysBlackEnds) {
    Scene scene = small_lamp(
        "shape: {disk: {radius: 0.1}}, transform: [{translate: [0, 0, -2]}, {rotate: {axis: "
        "[1, 0, 0], angle: 180}}], emission: {radiance: 1}");
    scene.render.width = scene.render.height = 4;
    const Stopped stopped = render_to(scene, 0.1);
    EXPECT_EQ(stopped.progress.reason, StopReason::dark);
    EXPECT_EQ(stopped.progress.film.fewest_samples, most_dark_samples);
    for (const Stokes<double>& s : stopped.image.stokes) ASSERT_EQ(s.s0, 0.0);
}

ErrorReport report(double samples, double truncation, std::optional<double> sampling) {
    ErrorReport report;
    report.samples = samples;
    report.look = samples >= 16.0 ? 1 : 0;
    report.error.random_samples = true;
    report.error.truncation = truncation;
    report.error.sampling = sampling;
    return report;
}

// In glass a branch loses nine tenths of its weight at every face: ten times less residual costs one more branch of 4
// to
// 10. In a picture that is cut by depth no residual changes anything, and mode point has no sampling to pay for.
TEST(ErrorStop, TruncationTakesTheShareThatCostsLeast) {
    Scene scene = small("paper-glass-polarized", 40, 1000);
    const double glass = cheapest_goal(*test::plan_of(scene), 0.1).truncation_share;
    EXPECT_GE(glass, 0.01);
    EXPECT_LT(glass, 0.15);
    scene.render.depth = 9;
    EXPECT_EQ(cheapest_goal(*test::plan_of(scene), 0.1).truncation_share, 0.5);
    scene.render.depth.reset();
    scene.render.mode = SampleMode::point;
    EXPECT_EQ(cheapest_goal(*test::plan_of(scene), 0.1).truncation_share, 1.0);
}

constexpr ErrorGoal half{0.1, 0.5};

TEST(ErrorStop, EachPartMayTakeItsShare) {
    EXPECT_EQ(judge(report(16, 0.04, 0.05), half), StopReason::error);
    EXPECT_EQ(judge(report(16, 0.06, 0.01), half), StopReason::truncation);
    EXPECT_EQ(judge(report(16, 0.04, 0.06), half), StopReason::none);
    EXPECT_EQ(judge(report(8, 0.04, 0.05), half), StopReason::none) << "too few samples to believe";
    EXPECT_EQ(judge(report(1, 0.04, std::nullopt), half), StopReason::none);
    EXPECT_EQ(judge(report(16, 0.9, 0.4), half), StopReason::none) << "the light is not known that it is relative to";
    EXPECT_EQ(judge(report(2048, std::numeric_limits<double>::infinity(), std::nullopt), half), StopReason::none);
    EXPECT_EQ(judge(report(4096, std::numeric_limits<double>::infinity(), std::nullopt), half), StopReason::dark);
    const ErrorGoal mostly_sampling{0.1, 0.1};
    EXPECT_EQ(judge(report(16, 0.009, 0.089), mostly_sampling), StopReason::error);
    EXPECT_EQ(judge(report(16, 0.011, 0.01), mostly_sampling), StopReason::truncation);
    EXPECT_EQ(judge(report(16, 0.009, 0.091), mostly_sampling), StopReason::none);
    ErrorReport point = report(1, 0.04, 0.0);
    point.error.random_samples = false;
    EXPECT_EQ(judge(point, half), StopReason::error);
    point.error.sampling.reset();
    EXPECT_EQ(judge(point, half), StopReason::error) << "random paths are within the bound";
}

// z = sqrt(2 ln 20) at the first look, where 2.5 % may be wrong, and sqrt(2 ln 60) at the second, where it is a third
// of that. Many pixels: 1 + 2 z spread. One with all of the error, its variance known to 100 %: exp(2 z / sqrt(3)).
TEST(ErrorStop, ALimitIsWiderWhereFewPixelsTellItAndAtEveryLook) {
    ErrorReport one = report(16, 0.0, 0.1);
    EXPECT_DOUBLE_EQ(sampling_limit(one).value(), 0.1) << "spread over endless pixels";
    const double first = std::sqrt(2.0 * std::log(20.0));
    const double second = std::sqrt(2.0 * std::log(60.0));
    one.error.sampling_spread = 0.1;
    EXPECT_NEAR(sampling_limit(one).value(), 0.1 * std::sqrt(1.0 + 0.2 * first), 1e-12);
    one.look = 2;
    EXPECT_NEAR(sampling_limit(one).value(), 0.1 * std::sqrt(1.0 + 0.2 * second), 1e-12);
    one.error.sampling_spread = 1.0;
    EXPECT_NEAR(sampling_limit(one).value(), 0.1 * std::exp(second / std::sqrt(3.0)), 1e-12);
    one.look = 0;
    EXPECT_FALSE(sampling_limit(one));
}

// What 65 536 samples all miss is seen by less than 1 of 20 000 of them: (1 - 1/20000)^65536 = 3.8 %.
TEST(ErrorStop, SamplesOfTheWholePictureCountAgainstWhatAllOfThemMiss) {
    EXPECT_FALSE(is_enough_to_judge(15.9, 256));
    EXPECT_TRUE(is_enough_to_judge(16.0, 1));
    EXPECT_FALSE(is_enough_to_judge(4.0, 16000));
    EXPECT_TRUE(is_enough_to_judge(4.0, 16384));
    EXPECT_LT(std::pow(1.0 - 1.0 / 20000.0, 65536.0), 0.05);
}

TEST(ErrorStop, ThePartThatStayedTooLargeTheLongestFellLast) {
    const ErrorReport both = report(16, 0.09, 0.2);
    const ErrorReport truncated = report(16, 0.09, 0.01);
    const ErrorReport noisy = report(16, 0.01, 0.2);
    const ErrorReport good = report(32, 0.01, 0.01);
    EXPECT_EQ(last_to_fall({both, noisy, good}, half), ErrorPart::sampling);
    EXPECT_EQ(last_to_fall({both, truncated, good}, half), ErrorPart::truncation);
    EXPECT_EQ(last_to_fall({both, good}, half), ErrorPart::sampling);
    EXPECT_EQ(last_to_fall({good}, half), std::nullopt);
    EXPECT_EQ(last_to_fall({both, noisy}, half), std::nullopt);
}

// Half as much again as what does not fall, if half of the error is enough for it.
TEST(ErrorStop, WhatNoResidualBringsLowerGetsTheShareThatItNeeds) {
    const ErrorGoal goal{0.03, 0.01};
    EXPECT_DOUBLE_EQ(share_needed(report(4, 0.004, 0.1), report(4, 0.004, 0.1), goal).value(), 0.2);
    EXPECT_FALSE(share_needed(report(4, 0.004, 0.1), report(4, 0.003, 0.1), goal)) << "it falls";
    EXPECT_FALSE(share_needed(report(4, 0.012, 0.1), report(4, 0.012, 0.1), goal)) << "0.018 of 0.03";
}

TEST(ErrorStop, AFinerResidualIsInProportionAndHasAnEnd) {
    EXPECT_DOUBLE_EQ(*finer_residual(report(1, 0.5, 0.1), 1e-3, half), 0.5e-4);
    EXPECT_FALSE(finer_residual(report(1, 0.5, 0.1), 0.0, half)) << "the depth alone cuts";
    EXPECT_FALSE(finer_residual(report(1, 1.0, 0.1), 1e-9, half));
    EXPECT_FALSE(finer_residual(report(1, std::numeric_limits<double>::infinity(), 0.0), 1e-3, half)) << "black";
}

}  // namespace
}  // namespace pol
