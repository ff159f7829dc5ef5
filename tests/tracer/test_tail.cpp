// SPDX-License-Identifier: Apache-2.0
// The random path that ends a tree when its node budget is used up: unbiased, and never brighter than what it stands
// for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/shipped_scenes.h"
#include "tracer/sample_task.h"
#include "tracer/trace_sample.h"

namespace pol {
namespace {

/// A crystal prism over a bright card under a dim sky: every ray splits, and the leaves differ in brightness. Its faces
/// are not parallel and its indices low, so that no light is trapped and a deep tree comes to an end.
Scene prism(int node_budget) {
    Scene scene = test::scene_of(R"(
camera: {position: [1.6, -3, 2.2], target: [0, 0, -0.1], fov: 28}
background: 0.2
render: {size: [9, 9], residual: 1e-9}
media: {crystal: {ordinary: 1.4, extraordinary: 1.25, axis: [1, 2, 3]}}
objects:
  - {name: prism, shape: {extrusion: {polygon: [[-0.7, -0.5], [0.6, -0.6], [0.4, 0.7]], height: 0.9}}, medium: crystal,
     transform: [{rotate: {axis: [1, 1, 0], angle: 17}}]}
  - {name: card, shape: {rectangle: {size: 2.4}}, transform: [{translate: [0, 0, -0.8]}], emission: {radiance: 1}}
)");
    scene.render.node_budget = node_budget;
    return scene;
}

struct Spread {
    double mean = 0.0;
    double of_mean = 0.0;  ///< standard error of the mean
};

Spread spread(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    double sum = 0.0;
    for (const double v : values) sum += v;
    const double mean = sum / n;
    double squares = 0.0;
    for (const double v : values) squares += (v - mean) * (v - mean);
    return {mean, std::sqrt(squares / (n - 1.0) / n)};
}

// Mean of 4000 random tails against a tree that is followed to its end. 5 sigma: with 4 components of 4 pixels,
// false alarms once in 1e5 changes of the random numbers. The reference is itself off by its open share, at most 1e-6.
TEST(Tail, EstimatesTheRestOfTheTreeWithoutBias) {
    const auto shallow = test::plan_of(prism(5));
    const auto deep = test::plan_of(prism(60000));
    constexpr double Stokes<double>::*components[] = {&Stokes<double>::s0, &Stokes<double>::s1, &Stokes<double>::s2,
                                                      &Stokes<double>::s3};
    for (const int x : {2, 3, 4, 5}) {
        Stokes<double> truth;
        const TraceResult reference = trace_sample(*deep, sample_task(*deep, x, 5, 0, 0), {&truth, 1});
        const double unknown = (reference.residual + 2.0 * reference.tail) * deep->brightest[0];
        std::vector<std::vector<double>> values(4);
        double tails = 0.0;
        for (std::uint32_t k = 0; k < 4000; ++k) {
            Stokes<double> light;
            const TraceResult r = trace_sample(*shallow, sample_task(*shallow, x, 5, k, 0), {&light, 1});
            tails += r.tail;
            for (std::size_t c = 0; c < 4; ++c) values[c].push_back(light.*components[c]);
        }
        EXPECT_GT(tails / 4000.0, 0.02) << "pixel " << x << " has no tail to speak of";
        for (std::size_t c = 0; c < 4; ++c) {
            const Spread s = spread(values[c]);
            EXPECT_LE(std::abs(s.mean - truth.*components[c]), 5.0 * s.of_mean + unknown)
                << "S" << c << " of pixel " << x << ": " << s.mean << " +- " << s.of_mean;
            EXPECT_LT(unknown, 1e-6);
        }
    }
}

// The tail always weighs what was open, so its light has S0 <= open x L_max; rounding of some 1000 rescalings: 1e-13.
TEST(Tail, IsNeverBrighterThanAllThatWasOpen) {
    for (const int budget : {1, 5, 40}) {
        const auto plan = test::plan_of(prism(budget));
        int tails = 0;
        for (std::uint32_t k = 0; k < 40; ++k)
            for (const int x : {2, 4, 6}) {
                const Explanation e = explain(*plan, x, 5, k, 0);
                double estimated = 0.0;
                for (const int leaf : e.tree.leaves) {
                    const RayTreeNode& node = e.tree.nodes[static_cast<std::size_t>(leaf)];
                    if (node.estimated) estimated += node.light.s0;
                }
                ASSERT_LE(estimated, e.result.tail * plan->brightest[0] * (1.0 + 1e-13)) << budget << ", sample " << k;
                if (estimated > 0.0) ++tails;
            }
        EXPECT_GT(tails, 20) << budget;
    }
}

// Samples of a pixel in point mode share ray and head, but not the tail: their mean is what the renderer stores.
TEST(Tail, OfARenderedPixelDiffersFromSampleToSample) {
    Scene scene = prism(5);
    const StokesImage one = test::render(scene);
    scene.render.seed = 1;
    const StokesImage other = test::render(scene);
    int different = 0;
    for (std::size_t p = 0; p < one.pixel_count(); ++p)
        if (!(one.at(0, p) == other.at(0, p))) ++different;
    EXPECT_GT(different, 5);
}

// From inside a glass cube (critical angle 41.8 degrees) a ray along the diagonal meets every face at 54.7 degrees:
// total reflection without end. Nothing of it is known, and it costs no more than head and tail may.
TEST(Tail, OfTrappedLightIsWorkThatHasAnEnd) {
    for (const int budget : {1, 10, 1000, 3000}) {
        Scene scene = test::scene_of(R"(
camera: {position: [0.1, -0.05, 0], target: [1.1, 0.95, 1], fov: 1e-3}
background: 1
media: {glass: 1.5}
objects: [{name: cube, shape: {box: {size: 1}}, medium: glass}]
)");
        scene.render.node_budget = budget;
        const TraceResult result = test::explain_look(scene).result;
        // Up to 6000 reflections, each of which rounds the power a dozen times by 1.1e-16.
        EXPECT_NEAR(result.residual, 1.0, 8e-12) << budget;
        EXPECT_EQ(result.tail, 0.0);
        EXPECT_EQ(result.failures, 0U);
        EXPECT_EQ(result.nodes, static_cast<std::uint32_t>(budget + std::max(budget, 4096)));
    }
}

// In a stone that light can leave, a tail after the shortest head comes to its end: what is given up is missing.
TEST(Tail, OfAStoneComesToItsEnd) {
    for (const char* name :
         {"cube-calcite", "paper-calcite-unpolarized", "paper-glass-polarized", "twinned-crystals"}) {
        Scene scene = test::shipped_scene(name);
        scene.render.width = scene.render.height = 24;
        scene.render.residual = 0.0;
        scene.render.node_budget = 1;
        const StokesImage image = test::render(scene);
        double given_up = 0.0;
        for (const double residual : image.residual) given_up += residual;
        EXPECT_EQ(given_up, 0.0) << name;
    }
}

// Partial renders: the random numbers of a wavelength follow from the matter, not from the company. Without dispersion
// several wavelengths share a tree, with it (calcite) each has its own.
TEST(Tail, OfAWavelengthIsTheSameAloneAndInEveryList) {
    for (const char* crystal :
         {"{ordinary: 1.4, extraordinary: 1.25, axis: [1, 2, 3]}", "{crystal: calcite, axis: [1, 2, 3]}"}) {
        const auto picture = [&](std::vector<double> wavelengths_nm) {
            Scene scene = test::scene_of(std::string(R"(
camera: {position: [1.6, -3, 2.2], target: [0, 0, 0], fov: 28}
background: 0.2
media: {crystal: )") + crystal + R"(}
objects:
  - {name: cube, shape: {box: {size: 1}}, medium: crystal}
)");
            scene.render.width = scene.render.height = 9;
            scene.render.residual = 1e-9;
            scene.render.node_budget = 5;
            scene.render.wavelengths_nm = std::move(wavelengths_nm);
            return test::render(scene);
        };
        const std::vector<double> all{450.0, 500.0, 550.0, 600.0};
        const StokesImage list = picture(all);
        const StokesImage upper = picture({550.0, 600.0});
        double tails = 0.0;
        for (std::size_t w = 0; w < all.size(); ++w) {
            const StokesImage alone = picture({all[w]});
            for (std::size_t p = 0; p < list.pixel_count(); ++p) {
                ASSERT_EQ(alone.at(0, p), list.at(w, p)) << crystal << ", " << all[w] << " nm, pixel " << p;
                ASSERT_EQ(alone.tail[p], list.plane_value(list.tail, w, p));
                tails += alone.tail[p];
                if (w >= 2) {
                    ASSERT_EQ(upper.at(w - 2, p), list.at(w, p));
                }
            }
        }
        EXPECT_GT(tails, 1.0) << "nothing was random";
    }
}

// Wavelengths with trees of their own have random numbers of their own: their noise averages out in a color.
TEST(Tail, OfWavelengthsWithOtherConstantsIsAnotherOne) {
    Scene scene = prism(5);
    const auto plan = test::plan_of(scene);
    std::get<UniaxialMedium>(scene.media[0].matter).ordinary = ConstantIndex{{1.41, 0.0}};
    EXPECT_NE(test::plan_of(scene)->groups[0].key, plan->groups[0].key);
}

}  // namespace
}  // namespace pol
