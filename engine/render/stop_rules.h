// SPDX-License-Identifier: Apache-2.0
// When a picture is good enough. The plan's settings say how many samples at most, and how much of each may stay
// untraced; these rules end it earlier.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "film/picture_error.h"
#include "render/error_goal.h"

namespace pol {

struct StopRules {
    /// Seconds of rendering; pauses and a suspended program do not count.
    std::optional<double> seconds;
    /// Largest error of the picture, relative to it: the bound of truncation and the confidence limit of sampling
    /// (sampling_limit) must each fall to its share of it (cheapest_goal). Looked at when all pixels have the same
    /// number of samples, a power of two, so that the picture does not depend on threads and clocks.
    std::optional<double> error;
};

enum class StopReason {
    none,        ///< still going, or no job
    samples,     ///< all samples of the plan are there
    time,        ///< StopRules::seconds
    error,       ///< StopRules::error is reached
    truncation,  ///< no number of samples will reach StopRules::error: a plan with finer_residual() may
    dark,        ///< StopRules::error means nothing: no sample has met any light, and there were many
    cancelled,
    memory,  ///< there is none left for what a pass brings
};

enum class ErrorPart { truncation, sampling };

/// The error when every pixel had this many samples.
struct ErrorReport {
    std::uint32_t samples = 0;
    double seconds = 0.0;  ///< of rendering since the start of the job
    PictureError error{};
};

/// Below this many samples sampling is not judged: a bright spot that most pixels miss with all of them would not show.
inline constexpr std::uint32_t fewest_samples_to_stop = 16;

/// So many samples per pixel without any light are enough.
inline constexpr std::uint32_t most_dark_samples = 4096;

/// Upper confidence limit of the sampling error of the picture, relative to it. Empty: not estimated, or too few
/// samples.
///
/// Who looks again and again, and stops at the first low estimate, stops at a lucky one (P. Armitage, C. McPherson, B.
/// Rowe, "Repeated significance tests on accumulating data", J. R. Stat. Soc. A 132, 1969). Hence the looks are few,
/// one per doubling, and each may err with its own probability, alpha / (j (j + 1)) for the j-th, which over all looks
/// is alpha = 5 % (K. Lan, D. DeMets, "Discrete sequential boundaries for clinical trials", Biometrika 70, 1983),
/// however they depend on each other. Error and estimate are two independent sums over pixels of the same mean and
/// variance: their difference has the standard deviation sqrt(2) sampling_spread sampling^2, and its normal deviate z
/// is taken from P(Z > z) <= exp(-z^2 / 2) / 2. Sums of few squares are more skewed than normal numbers: hence 2 in
/// place of sqrt(2). Where three pixels make the error (a small lamp behind a cube) the limit holds in 94.5 % of 200
/// seeds; of eight scenes at fourteen errors 99.5 % or more of the pictures end below E
/// (tests/bench/error_stop_seeds.cpp). A picture of a few pixels tells too little: halves that agree by chance look
/// like no error.
std::optional<double> sampling_limit(const ErrorReport& report);

/// Whether that part is at most its share of the goal.
bool has_fallen(ErrorPart part, const ErrorReport& report, const ErrorGoal& goal);

/// What the error rule says to a report: error (stop, reached), truncation or dark (stop, out of reach), or none (go
/// on). Truncation is not judged before the light that it is relative to is known: the first samples may have met none.
StopReason judge(const ErrorReport& report, const ErrorGoal& goal);

/// The part that stayed too large the longest: the one that was still above its share of the goal when the other was
/// not, or both. Empty if neither ever was too large, or the last report does not reach the goal.
std::optional<ErrorPart> last_to_fall(const std::vector<ErrorReport>& reports, const ErrorGoal& goal);

/// Residual (RenderSettings) that should bring truncation below its share of the goal, from the one that did not:
/// the bound falls in proportion to it, with a margin because shares of a pixel fall short of the residual by a varying
/// factor. Empty if no residual will: the light is missing for another reason (a depth limit, tails that count as
/// bounds, failed samples, a black picture of mode point).
std::optional<double> finer_residual(const ErrorReport& report, double residual, const ErrorGoal& goal);

}  // namespace pol
