// SPDX-License-Identifier: Apache-2.0
// Does `--error E` keep its word? Stops pictures of several scenes at several errors with many seeds, and counts how
// many are farther from a much longer render than E. Minutes of work: no test runs it.
// Usage: polariscope_error_stop_seeds [SEEDS]     exit code 1: less than 95 % of a row's seeds are below E
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "polarization/coherence_matrix.h"
#include "support/render_scene.h"

namespace pol {
namespace {

struct Case {
    const char* name;
    Scene scene;
    std::vector<double> errors;
    int reference_samples;
};

Scene area(Scene scene, int size, int node_budget) {
    scene.render.width = scene.render.height = size;
    scene.render.mode = SampleMode::area;
    scene.render.node_budget = node_budget;
    return scene;
}

/// A few caustics of a small lamp make most of the light.
Scene cube_and_small_lamp() {
    return test::scene_of(R"(
camera: {position: [1.6, -3, 2.2], target: [0, 0, 0], fov: 28}
media: {glass: 1.5}
objects:
  - {name: cube, shape: {box: {size: 1}}, medium: glass}
  - {name: lamp, shape: {sphere: {radius: 0.1}}, transform: [{translate: [0.2, 0.9, 0.3]}], emission: {radiance: 1}}
)");
}

std::vector<Case> cases() {
    return {
        {"water-drop", area(test::shipped_scene("water-drop"), 24, 1000), {0.1, 0.2}, 1 << 13},
        {"cube, small lamp", area(cube_and_small_lamp(), 16, 1000), {0.2, 0.4}, 1 << 13},
        {"cube-glass", area(test::shipped_scene("cube-glass"), 24, 1000), {0.1, 0.2}, 1 << 12},
        {"metal-spheres", area(test::shipped_scene("metal-spheres"), 16, 200), {0.1, 0.2}, 1 << 12},
        {"crossed-polarizers", area(test::shipped_scene("crossed-polarizers"), 16, 1000), {0.1, 0.2}, 1 << 12},
        {"paper-glass-polarized", area(test::shipped_scene("paper-glass-polarized"), 16, 1000), {0.2}, 1 << 12},
        {"cube-calcite", area(test::shipped_scene("cube-calcite"), 16, 30), {0.2}, 1 << 11},
        {"g1", area(test::shipped_scene("bench/g1"), 96, 1000), {0.015, 0.03}, 1 << 10},
        {"glass-ball", area(test::shipped_scene("bench/glass-ball"), 64, 1000), {0.015, 0.03}, 1 << 11},
        {"glan-air", area(test::shipped_scene("glan-air"), 16, 100), {0.1, 0.2}, 1 << 11},
    };
}

struct Stopped {
    StokesImage image;
    ErrorReport report;
};

/// Renders until the error rule ends it, as the program does.
std::optional<Stopped> render_to(Scene scene, double error) {
    scene.render.samples_per_pixel = 1 << 20;
    Renderer renderer(hardware_threads(), 8);
    RenderOptions options;
    options.stop.error = error;
    for (;;) {
        renderer.start(test::plan_of(scene), options);
        renderer.wait();
        const RenderProgress progress = renderer.progress();
        if (progress.reason == StopReason::error) return Stopped{renderer.snapshot(), progress.reports.back()};
        if (progress.reason != StopReason::truncation) return std::nullopt;
        const auto finer = finer_residual(progress.reports.back(), scene.render.residual_in_force(), *progress.goal);
        if (!finer) return std::nullopt;
        scene.render.residual = *finer;
    }
}

bool run(const Case& one, int seeds) {
    Scene deep = one.scene;
    deep.render.residual = 1e-5;
    deep.render.samples_per_pixel = one.reference_samples;
    deep.render.seed = 0x5eed;
    const StokesImage reference = test::render(test::plan_of(deep), hardware_threads(), 8);
    double light = 0.0;
    for (const Stokes<double>& s : reference.stokes) light += frobenius_square(s);
    bool good = true;
    for (const double target : one.errors) {
        int below = 0;
        int within = 0;  // below the limit of sampling and the bound of truncation
        int unreached = 0;
        double samples = 0.0;
        double errors = 0.0;
        double estimates = 0.0;
        for (int seed = 0; seed < seeds; ++seed) {
            Scene scene = one.scene;
            scene.render.seed = static_cast<std::uint64_t>(seed);
            const auto stopped = render_to(scene, target);
            if (!stopped) {
                ++unreached;
                continue;
            }
            double error = 0.0;
            for (std::size_t p = 0; p < reference.stokes.size(); ++p)
                error += frobenius_square(stopped->image.stokes[p] - reference.stokes[p]);
            if (std::sqrt(error / light) <= target) ++below;
            if (std::sqrt(error / light) <= *sampling_limit(stopped->report) + stopped->report.error.truncation)
                ++within;
            samples += stopped->report.samples;
            errors += error / light;
            estimates += std::pow(*stopped->report.error.sampling, 2);
        }
        const int reached = seeds - unreached;
        const bool kept = unreached == 0 && below >= 0.95 * seeds;
        good = good && kept;
        std::printf(
            "%-22s E %-5g below E: %5.1f %%, below limit + bound: %5.1f %% of %d seeds%s, samples %.0f, "
            "rms(true)/rms(estimate) %.2f  %s\n",
            one.name, target, reached > 0 ? 100.0 * below / reached : 0.0, reached > 0 ? 100.0 * within / reached : 0.0,
            seeds, unreached > 0 ? (" (" + std::to_string(unreached) + " not reached)").c_str() : "",
            reached > 0 ? samples / reached : 0.0, reached > 0 ? std::sqrt(errors / estimates) : 0.0,
            kept ? "" : "FAIL");
        std::fflush(stdout);
    }
    return good;
}

}  // namespace
}  // namespace pol

int main(int argc, char** argv) {
    const int seeds = argc > 1 ? std::atoi(argv[1]) : 200;
    bool good = true;
    for (const pol::Case& one : pol::cases()) good = pol::run(one, seeds) && good;
    return good ? 0 : 1;
}
