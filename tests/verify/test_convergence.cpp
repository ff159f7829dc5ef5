// SPDX-License-Identifier: Apache-2.0
// Error against run time: the sweep itself, on pictures of a few pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

#include "io/files/output_file.h"
#include "io/pictures/exr_file.h"
#include "support/render_scene.h"
#include "verify/convergence/convergence.h"
#include "verify/convergence/convergence_summary.h"
#include "verify/convergence/run_table.h"

namespace pol::verify {
namespace {

/// A folder of its own that goes with the test.
class Folder {
public:
    explicit Folder(const char* name) : path_(std::filesystem::temp_directory_path() / name) {
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

ConvergenceRequest small_request(const char* scene, const Folder& folder) {
    ConvergenceRequest request;
    auto loaded = load_scene(std::filesystem::path(POL_ASSETS) / "scenes" / scene);
    EXPECT_TRUE(loaded);
    request.scene = std::move(loaded).value();
    request.scene.render.width = 12;
    request.scene.render.height = 9;
    request.scene_name = scene;
    request.folder = folder.path();
    request.seeds = 2;
    request.most_repeats = 1;
    return request;
}

bool watch_on(const ConvergenceProgress& /*progress*/) {
    return true;
}

// CUTTING.md 1.2: what was not traced bounds the Frobenius error, pixel by pixel and hence in the mean square.
TEST(Convergence, TheErrorOfTruncationNeverExceedsItsBound) {
    const Folder folder("polariscope-test-converge-bound");
    const auto result = converge(small_request("paper-glass-unpolarized.yaml", folder), watch_on);
    ASSERT_TRUE(result) << to_string(result.error());
    EXPECT_TRUE(result.value().complete);
    EXPECT_EQ(worst_bound_coverage(result.value().rows), 1.0);
    int compared = 0;
    for (const RunRow& row : result.value().rows) {
        if (std::isnan(row.truncation)) continue;
        // The deeper picture is off by at most 1e-6 of a pixel itself; |C|_F has a root mean square above 0.1 here.
        EXPECT_LE(row.truncation, row.bound_fro + 1e-5) << row.series << " " << row.residual_target;
        EXPECT_EQ(row.failures, 0.0);
        EXPECT_FALSE(row.kernel.empty());
        EXPECT_EQ(row.psd_violations, 0.0);
        EXPECT_LE(row.s0_over_max, 1.0 + 1e-11);  // tree_rounding of some 1e4 branches
        // Rounding of some 1e3 branches and 40 surfaces (tree_rounding), over |C|_F of 0.1.
        EXPECT_GT(row.floating_point, 0.0);
        EXPECT_LE(row.floating_point, 1e-11);
        EXPECT_EQ(row.topology_changes, 0.0);
        ++compared;
    }
    EXPECT_EQ(compared, 12);
}

// Crystal trees end in a random tail, whose two-sided bound counts in full.
TEST(Convergence, TheBoundHoldsForEveryPixelOfACrystal) {
    const Folder folder("polariscope-test-converge-crystal");
    ConvergenceRequest request = small_request("paper-calcite-polarized.yaml", folder);
    request.scene.render.node_budget = 300;
    const auto result = converge(request, watch_on);
    ASSERT_TRUE(result) << to_string(result.error());
    EXPECT_EQ(worst_bound_coverage(result.value().rows), 1.0);
}

TEST(Convergence, ASecondStartGoesOnWhereTheFirstWasStopped) {
    const Folder folder("polariscope-test-converge-resume");
    const ConvergenceRequest request = small_request("paper-glass-unpolarized.yaml", folder);
    const auto stopped = converge(request, [](const ConvergenceProgress& progress) { return progress.done < 7; });
    ASSERT_TRUE(stopped);
    EXPECT_FALSE(stopped.value().complete);
    ASSERT_EQ(stopped.value().rows.size(), 7U);
    const auto resumed = converge(request, watch_on);
    ASSERT_TRUE(resumed);
    EXPECT_TRUE(resumed.value().complete);
    for (std::size_t i = 0; i < 7; ++i)
        EXPECT_EQ(resumed.value().rows[i].render_wall_s, stopped.value().rows[i].render_wall_s) << i;
}

TEST(Convergence, RunsOfAnotherSceneAreNotTakenOver) {
    const Folder folder("polariscope-test-converge-other");
    ConvergenceRequest request = small_request("paper-glass-unpolarized.yaml", folder);
    request.seeds = 1;
    ASSERT_TRUE(converge(request, watch_on));
    request.scene.render.height = 10;
    const auto other = converge(request, watch_on);
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().field, "-o");
    EXPECT_NE(other.error().what.find("another scene"), std::string::npos) << other.error().what;
}

// Whose hashes are of another kind says nothing about the scene.
TEST(Convergence, RunsOfAnotherVersionAreCalledSoAndNothingIsOverwritten) {
    const Folder folder("polariscope-test-converge-version");
    ConvergenceRequest request = small_request("paper-glass-unpolarized.yaml", folder);
    RunRow row;
    row.scene_hash = "0123456789abcdef0123456789abcdef";
    ASSERT_TRUE(write_file(folder.path() / "runs.csv", run_table_csv({row})));
    const auto other = converge(request, watch_on);
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().field, "-o");
    EXPECT_NE(other.error().what.find("another version"), std::string::npos) << other.error().what;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "reference.exr"));
}

/// A picture of the request's scene, finer than any run, as a file in its folder.
std::filesystem::path reference_of(const ConvergenceRequest& request, const std::function<void(StokesImage&)>& change) {
    Scene scene = request.scene;
    scene.render.residual = 1e-6;
    scene.render.samples_per_pixel = scene.render.mode == SampleMode::area ? 256 : 1;
    scene.render.seed = 99;
    StokesImage image = test::render(scene);
    change(image);
    const std::filesystem::path path = request.folder / "given.exr";
    EXPECT_TRUE(write_exr(image, path));
    return path;
}

Stokes<double>& brightest_pixel(StokesImage& image) {
    return *std::max_element(image.stokes.begin(), image.stokes.end(),
                             [](const auto& a, const auto& b) { return a.s0 < b.s0; });
}

// A bar is wide where light is missing; a reference of which nothing is missing must lie in it, pixel by pixel, and all
// four components of it.
TEST(Convergence, AReferenceOutsideTheBoundsIsSaidToBe) {
    const Folder folder("polariscope-test-converge-reference");
    ConvergenceRequest request = small_request("paper-glass-polarized.yaml", folder);
    request.seeds = 1;
    const auto checked = [&](const std::function<void(StokesImage&)>& change) {
        request.reference = reference_of(request, change);
        const auto result = converge(request, [](const ConvergenceProgress& progress) { return progress.done < 1; });
        EXPECT_TRUE(result) << to_string(result.error());
        return result.value();
    };
    const ConvergenceResult right = checked([](StokesImage&) {});
    EXPECT_FALSE(right.reference_check->contradicts());
    EXPECT_EQ(right.reference_check->covered, 1.0);
    EXPECT_NE(text_about_reference(right).find("agrees"), std::string::npos);
    std::filesystem::remove(folder.path() / "runs.csv");

    const ConvergenceResult brighter = checked([](StokesImage& image) {
        for (Stokes<double>& s : image.stokes) s = 1.5 * s;
    });
    EXPECT_TRUE(brighter.reference_check->contradicts());
    // A third of it is too much; our own picture is known to 1e-4.
    EXPECT_NEAR(brighter.reference_error, 1.0 / 3.0, 1e-3);
    EXPECT_FALSE(bounds_hold(brighter));
    EXPECT_NE(text_about_reference(brighter).find("WRONG"), std::string::npos);
    std::filesystem::remove(folder.path() / "runs.csv");

    // As bright everywhere, but of the other handedness; and a single pixel.
    EXPECT_TRUE(checked([](StokesImage& image) {
                    for (Stokes<double>& s : image.stokes) s.s3 = -s.s3;
                }).reference_check->contradicts());
    std::filesystem::remove(folder.path() / "runs.csv");
    const ConvergenceResult one = checked([](StokesImage& image) { brightest_pixel(image).s0 *= 2.0; });
    EXPECT_TRUE(one.reference_check->contradicts());
    EXPECT_DOUBLE_EQ(one.reference_check->covered, 1.0 - 1.0 / (12.0 * 9.0));
}

// In mode area sampling comes on top of the bounds: an honest reference is not accused, a brighter one is.
TEST(Convergence, AReferenceOfAnAreaPictureMayDifferByItsNoise) {
    const Folder folder("polariscope-test-converge-area-reference");
    ConvergenceRequest request = small_request("paper-glass-unpolarized.yaml", folder);
    request.scene.render.mode = SampleMode::area;
    request.seeds = 1;
    for (const double factor : {1.0, 2.0}) {
        request.reference = reference_of(request, [factor](StokesImage& image) {
            for (Stokes<double>& s : image.stokes) s = factor * s;
        });
        const auto result = converge(request, [](const ConvergenceProgress& progress) { return progress.done < 1; });
        ASSERT_TRUE(result) << to_string(result.error());
        EXPECT_EQ(result.value().reference_check->contradicts(), factor != 1.0);
        std::filesystem::remove(folder.path() / "runs.csv");
    }
}

// Runs against a file are not taken over when another picture stands under its name.
TEST(Convergence, AReferenceIsKnownByWhatItHolds) {
    const Folder folder("polariscope-test-converge-renamed");
    ConvergenceRequest request = small_request("paper-glass-unpolarized.yaml", folder);
    request.seeds = 1;
    const auto start = [&](double factor) {
        request.reference =
            reference_of(request, [factor](StokesImage& image) { brightest_pixel(image).s0 *= factor; });
        return converge(request, [](const ConvergenceProgress& progress) { return progress.done < 1; });
    };
    ASSERT_TRUE(start(1.0));
    EXPECT_TRUE(start(1.0)) << "the same picture goes on";
    const auto other = start(2.0);
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().field, "-o");
}

// Of pictures that nothing random made there is no scatter to measure; one sample per pixel of mode area scatters.
TEST(Convergence, WhereNothingScattersTheSamplingErrorIsNotMeasured) {
    for (const SampleMode mode : {SampleMode::point, SampleMode::area}) {
        const Folder folder("polariscope-test-converge-sampling");
        ConvergenceRequest request = small_request("paper-glass-unpolarized.yaml", folder);
        request.scene.render.mode = mode;
        const auto result = converge(request, watch_on);
        ASSERT_TRUE(result) << to_string(result.error());
        int known = 0;
        for (const RunRow& row : result.value().rows) {
            if (std::isnan(row.sampling)) continue;
            EXPECT_GT(row.sampling, 0.0) << row.series;
            if (row.samples_per_pixel == 1.0) ++known;
        }
        // Seed 1 against seed 0 at three residuals.
        EXPECT_EQ(known, mode == SampleMode::area ? 3 : 0);
    }
}

TEST(Convergence, BoundsOfNothingDoNotHold) {
    ConvergenceResult nothing;
    EXPECT_FALSE(bounds_hold(nothing));
    EXPECT_EQ(text_about_bounds(nothing), "bounds were not measured");
    RunRow row;
    row.bound_cover = 1.0 - 1e-6;
    nothing.rows = {row};
    EXPECT_FALSE(bounds_hold(nothing));
    EXPECT_EQ(text_about_bounds(nothing), "bounds hold in 99.99 % of the pixels") << "100.00 means all";
}

TEST(RunTable, ReadsBackToTheSameBitsAndNamesTheBadField) {
    RunRow row;
    row.series = "samples, \"quoted\"";
    row.render_wall_s = 0.1;
    row.errors[2].p99 = 1.0 / 3.0;
    const std::string csv = run_table_csv({row, row});
    const auto read = parse_run_table(csv, "runs.csv");
    ASSERT_TRUE(read);
    ASSERT_EQ(read.value().size(), 2U);
    EXPECT_EQ(read.value()[1].series, row.series);
    EXPECT_EQ(read.value()[1].errors[2].p99, 1.0 / 3.0);
    EXPECT_TRUE(std::isnan(read.value()[1].depth_limit));
    EXPECT_EQ(run_table_csv(read.value()), csv);
    const auto marked = parse_run_table("\ufeff" + csv, "runs.csv");
    ASSERT_TRUE(marked);
    EXPECT_EQ(run_table_csv(marked.value()), csv);

    std::string bad = csv;
    bad.replace(bad.rfind("0.1"), 3, "0,x");
    const auto refused = parse_run_table(bad, "runs.csv");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().place.line, 3);
}

// A straight line in the log-log plane has its slope everywhere.
TEST(Curves, FitTheSlopeOfAPowerLawAndFindTheCheapestSetting) {
    std::vector<RunRow> rows;
    for (int i = 0; i < 4; ++i) {
        RunRow row;
        row.series = "residual";
        row.residual_target = std::pow(10.0, -i);
        row.render_cpu_s = std::pow(4.0, i);
        row.errors[0].whole = std::pow(2.0, -i);
        rows.push_back(row);
    }
    const std::vector<Curve> all = curves(rows);
    ASSERT_EQ(all.size(), 1U);
    ASSERT_TRUE(all[0].slope);
    EXPECT_NEAR(*all[0].slope, -0.5, 1e-12);
    // error = t^-1/2 at 1, 4, 16 and 64 s.
    EXPECT_NEAR(cost_of(all[0], 0.2).value(), 25.0, 1e-12);
    EXPECT_NEAR(cost_of(all[0], 0.125).value(), 64.0, 1e-12);
    EXPECT_FALSE(cost_of(all[0], 0.12));
    EXPECT_FALSE(cost_of(all[0], 2.0)) << "reached by all: what less would cost is not known";
    const std::vector<Cheapest> best = cheapest(all, {0.3, 0.01});
    ASSERT_TRUE(best[0].point);
    EXPECT_EQ(best[0].point->cpu_s, 16.0);
    EXPECT_FALSE(best[1].point);
    // 1/4 is known to 0.1: it may be 0.35.
    for (RunRow& row : rows) row.reference_error = 0.1;
    EXPECT_EQ(cheapest(curves(rows), {0.3})[0].point->cpu_s, 64.0);
}

}  // namespace
}  // namespace pol::verify
