// SPDX-License-Identifier: Apache-2.0
// One row per timed render, as CSV (CUTTING.md 5.4).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "compare/error_metrics.h"
#include "core/result.h"

namespace pol::verify {

inline constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

/// What was rendered, how long it took, and how wrong it is. Numbers that do not apply are `not_measured` and empty in
/// the file.
struct RunRow {
    std::string series;  ///< the knob that is turned: "residual", "samples, residual 0.01", "depth", ...
    std::string scene;
    std::string scene_hash;  ///< of the scene with its own settings: a row of another scene is not taken over
    std::string mode;        ///< point or area
    std::string kernel;
    std::string tool_version;
    std::string cpu;
    std::string wavelengths_nm;  ///< vacuum, separated by spaces
    std::string reference;       ///< where the reference comes from
    std::string timestamp;       ///< UTC
    double cores = 0;            ///< that the machine has
    double threads = 0;
    double width = 0;
    double height = 0;
    double residual_target = 0.0;
    double depth_limit = not_measured;
    double node_budget = 0;
    double samples_per_pixel = 0;
    double wavelengths = 0;
    double seed = 0;
    double repeats = 0;            ///< runs of which the times are the shortest
    double load_s = not_measured;  ///< scene file to scene, once for all runs
    double compile_s = 0.0;        ///< scene to plan
    double render_wall_s = 0.0;    ///< tracing alone; neither loading nor output
    double render_cpu_s = 0.0;     ///< user and system time of all threads
    double rays = 0;
    double nodes_mean = 0.0;  ///< rays per tree
    double nodes_max = 0;
    double reference_error = 0.0;  ///< fro_c of the reference itself, estimated
    std::array<Metric, named_metrics.size()> errors{};
    double truncation = not_measured;  ///< fro_c against a deeper render of the same samples
    double sampling = not_measured;    ///< fro_c, from the distance to the seed before
    double bound_fro = not_measured;   ///< root mean square of the bound, in the unit of fro_c
    double bound_mean = not_measured;  ///< relative to brightest
    double bound_max = not_measured;
    double bound_cover = not_measured;  ///< share of pixels whose error the bound holds
    double bound_ratio = not_measured;  ///< median of error / bound
    double spectral = not_measured;     ///< color difference from every second wavelength
    /// fro_c of rounding, on some pixels of the scene at its own settings; and how many of them are another tree, or
    /// may be, without it (rounding_error.h).
    double floating_point = not_measured;
    double topology_changes = not_measured;
    double energy_defect = 0.0;  ///< largest |resolved + absorbed + residual + tail - 1| of a sample
    double psd_violations = 0;   ///< numbers with |s| > S0 beyond the rounding of their tree
    double s0_over_max = 0.0;    ///< largest S0 over the brightest light
    double nan_count = 0;
    double failures = 0;
    double host_load = not_measured;  ///< 1-minute load average when the run began
};

/// Header and rows; numbers read back to the same bits.
std::string run_table_csv(const std::vector<RunRow>& rows);

/// Error (kind input): another header, a row with the wrong number of fields, a field that is no number; with the line.
Result<std::vector<RunRow>> parse_run_table(const std::string& text, const std::string& file_name);

}  // namespace pol::verify
