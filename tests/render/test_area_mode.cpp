// SPDX-License-Identifier: Apache-2.0
// A pixel of mode area is the mean over its square: nothing that repeats from pixel to pixel may pull it to a side.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/render_scene.h"

namespace pol {
namespace {

constexpr int side = 16;
constexpr double covered = 0.3;

/// 16 x 16 pixels of one unit of length, seen from straight above. In every column or row of them lies a strip of
/// radiance 1 that covers 0.3 of each pixel, its middle at `place` of the pixel, 0 to 1.
Scene strips(bool columns, double place, int samples, std::uint64_t seed) {
    std::string yaml =
        "camera: {type: orthographic, position: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], width: 16}\n"
        "objects:\n";
    for (int i = 0; i < side; ++i) {
        const std::string at = std::to_string(i - 0.5 * side + place);
        const std::string wide = std::to_string(covered);
        yaml += "  - {name: strip " + std::to_string(i) + ", shape: {rectangle: {size: [" +
                (columns ? wide + ", 20" : "20, " + wide) + "]}}, transform: [{translate: [" +
                (columns ? at + ", 0, 0" : "0, " + at + ", 0") + "]}], emission: {radiance: 1}}\n";
    }
    Scene scene = test::scene_of(yaml);
    scene.render.width = scene.render.height = side;
    scene.render.mode = SampleMode::area;
    scene.render.samples_per_pixel = samples;
    scene.render.seed = seed;
    return scene;
}

// Every sample is uniform in its pixel, so that the picture's mean is 0.3, whatever the strips leave out or cover of
// the pixels' centres. The pixels are independent: the error of the mean follows from their spread; 4 standard errors.
// 20 seeds: 5120 pixels, of which a centre among 64 samples would be seen at 15 standard errors.
TEST(AreaMode, TheMeanIsWithoutBiasWhereverAnEdgeLies) {
    constexpr int seeds = 20;
    for (const bool columns : {true, false})
        for (const double place : {0.25, 0.5, 0.75})
            for (const int samples : {1, 4, 16, 64}) {
                double sum = 0.0;
                double squares = 0.0;
                for (std::uint64_t seed = 0; seed < seeds; ++seed) {
                    const StokesImage image = test::render(strips(columns, place, samples, seed));
                    for (const Stokes<double>& s : image.stokes) {
                        sum += s.s0;
                        squares += s.s0 * s.s0;
                    }
                }
                constexpr double n = seeds * side * side;
                const double mean = sum / n;
                const double error = std::sqrt((squares / n - mean * mean) / (n - 1.0));
                EXPECT_LE(std::abs(mean - covered), 4.0 * error)
                    << (columns ? "columns" : "rows") << " at " << place << ", " << samples << " samples: " << mean;
            }
}

// The difference of the halves tells the error of the mean, which here is known: of 5120 pixels the mean squares agree
// within 5 sqrt(2 x 2 / 5120) = 14 % (two chi-squared numbers; light is 0 or 1, with less spread than normal numbers).
TEST(AreaMode, TheHalvesTellTheErrorOfAnEdge) {
    constexpr int seeds = 20;
    for (const int samples : {4, 16, 64}) {
        double error = 0.0;
        double estimate = 0.0;
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
            const StokesImage image = test::render(strips(true, 0.25, samples, seed));
            for (std::size_t p = 0; p < image.pixel_count(); ++p) {
                error += std::pow(image.at(0, p).s0 - covered, 2);
                estimate += std::pow(image.sampling_error[p].s0, 2);
            }
        }
        EXPECT_NEAR(estimate / error, 1.0, 0.14) << samples;
    }
}

// What a click shows is the centre, in both modes; the strips cover every centre.
TEST(AreaMode, SampleZeroIsTheCentreAndNoneOfThePicture) {
    const Scene scene = strips(true, 0.5, 2, 0);
    const auto plan = test::plan_of(scene);
    const StokesImage image = test::render(scene);
    for (int x = 0; x < side; ++x) {
        EXPECT_EQ(explain(*plan, x, 3, 0, 0).sample_light.s0, 1.0);
        const double first = explain(*plan, x, 3, 1, 0).sample_light.s0;
        const double second = explain(*plan, x, 3, 2, 0).sample_light.s0;
        EXPECT_EQ(image.at(0, image.pixel(x, 3)).s0, 0.5 * (first + second)) << x;
    }
}

}  // namespace
}  // namespace pol
