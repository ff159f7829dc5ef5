// SPDX-License-Identifier: Apache-2.0
// What the runs say: medians over seeds, slopes, the cheapest setting for an error, and the error taken apart.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verify/convergence/convergence.h"
#include "verify/convergence/run_table.h"

namespace pol::verify {

/// One setting of a curve: median over its seeds, with the band from the smallest to the largest.
struct CurvePoint {
    std::string setting;   ///< "residual 0.01", "16 samples", "depth 5"
    double samples = 0.0;  ///< per pixel
    double error = 0.0;    ///< fro_c
    double error_low = 0.0;
    double error_high = 0.0;
    double wall_s = 0.0;
    double cpu_s = 0.0;
    double cpu_low = 0.0;
    double cpu_high = 0.0;
    double bound = not_measured;  ///< rigorous, of fro_c by truncation
    int seeds = 0;
    double reference_error = 0.0;
    bool below_floor = false;  ///< less than three times the reference's own error: not to be plotted
};

struct Curve {
    std::string series;
    std::vector<CurvePoint> points;  ///< by time
    /// Slope of log(error) against log(cpu time), least squares over the points above the floor: -1 means ten times the
    /// time for a tenth of the error. Empty: fewer than three points.
    std::optional<double> slope;
};

/// CPU time at which a curve comes down to an error for good: between two of its points above the floor as a power law.
/// Empty: it does not, or begins below it.
std::optional<double> cost_of(const Curve& curve, double error);

/// Curves in the order in which their series first appear.
std::vector<Curve> curves(const std::vector<RunRow>& rows);

/// What is known to reach an error at least cost: its own error and the reference's together.
struct Cheapest {
    double error = 0.0;
    std::optional<CurvePoint> point;  ///< none: no setting reached it
    std::string series;
};
std::vector<Cheapest> cheapest(const std::vector<Curve>& curves, const std::vector<double>& errors);

/// Truncation, sampling, spectral and floating-point error of one setting, kept apart. fro_c each, but for the spectral
/// one, which is a difference of colors. `not_measured` where it does not apply.
struct ErrorBudget {
    std::string series;
    std::string setting;
    double truncation = not_measured;
    double truncation_bound = not_measured;
    double sampling = not_measured;
    double spectral = not_measured;
    double floating_point = not_measured;
};
std::vector<ErrorBudget> error_budgets(const std::vector<RunRow>& rows);

/// What is known of the reference's own error, as half a sentence.
std::string text_about_reference(const ConvergenceResult& result);

/// Whether the bounds were found to hold, in all pixels, of our pictures and of a given reference. False also if
/// nothing was measured.
bool bounds_hold(const ConvergenceResult& result);

/// "bounds hold in ... % of the pixels", rounded down: 100 % says all. Says so if none was measured.
std::string text_about_bounds(const ConvergenceResult& result);

/// Share of pixels, over all runs in which it was measured, whose error the bound holds; not_measured: none.
double worst_bound_coverage(const std::vector<RunRow>& rows);

}  // namespace pol::verify
