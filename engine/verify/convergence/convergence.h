// SPDX-License-Identifier: Apache-2.0
// Error against run time: renders a scene at many settings, times each and holds it against a reference
// (CUTTING.md 3, 4 and 5).
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "film/stokes_image.h"
#include "scene/scene.h"
#include "verify/convergence/anytime.h"
#include "verify/convergence/rounding_error.h"
#include "verify/convergence/run_table.h"

namespace pol::verify {

/// One point of a curve.
struct RunSetting {
    std::string series;
    RenderSettings settings;
};

struct ConvergenceRequest {
    Scene scene;
    std::string scene_name;
    std::filesystem::path folder;                    ///< for runs.csv and reference.exr; exists
    std::optional<std::filesystem::path> reference;  ///< instead of our own
    int threads = 1;
    int seeds = 5;
    int most_repeats = 20;         ///< of a short render, for its shortest time
    double load_s = not_measured;  ///< what reading the scene took
    std::string tool_version;
};

/// A reference that was given, held against our own deepest picture.
struct ReferenceCheck {
    double difference = 0.0;  ///< fro_c between the two
    double allowed = 0.0;     ///< of it, by the bounds of both and four times our estimate of sampling
    /// Share of pixels that both bounds allow (bound_coverage); in mode area, where sampling comes on top,
    /// not_measured.
    double covered = not_measured;

    /// One of the two pictures is wrong by more than it admits.
    [[nodiscard]] bool contradicts() const { return !(difference <= allowed) || covered < 1.0; }
};

struct ConvergenceResult {
    std::vector<RunRow> rows;  ///< in the order in which they were made
    std::string reference_id;  ///< how the reference was made, for people
    /// fro_c: estimated for our own reference. Of a given one, what it admits or what the check proves, the larger.
    double reference_error = 0.0;
    std::optional<ReferenceCheck> reference_check;  ///< of a given reference
    std::optional<RoundingError> rounding;
    std::vector<AnytimePoint> anytime;  ///< of the scene at its own settings
    bool complete = false;              ///< false: stopped early; the rows so far are in runs.csv
};

/// What a user sees while it runs. `done` of `all` timed renders; returns false to stop.
struct ConvergenceProgress {
    int done = 0;
    int all = 0;
    double seconds_left = not_measured;
    std::string doing;
};
using ConvergenceWatch = std::function<bool(const ConvergenceProgress&)>;

/// Samples of an area picture at which truncation is measured, and at which other knobs are turned: truncation is the
/// same at more, and costs as much as they do.
inline constexpr int few_convergence_samples = 4;

/// The curves that make sense for the scene: residual (point mode), residual by samples (area mode), depth, node budget
/// if there are crystals, wavelengths if there are several.
std::vector<RunSetting> convergence_settings(const Scene& scene, bool crystals);

/// Runs every setting with every seed, settings in turn so that a slow minute hits all of them, forwards and backwards.
/// Rows that runs.csv has already (same scene, threads and reference) are not made again. A render of less than 2 s is
/// repeated, up to most_repeats times and 1 s in all, and the shortest time counts. Error: scene, reference or output.
Result<ConvergenceResult> converge(const ConvergenceRequest& request, const ConvergenceWatch& watch);

}  // namespace pol::verify
