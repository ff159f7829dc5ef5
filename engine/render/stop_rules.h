// SPDX-License-Identifier: Apache-2.0
// When a picture is good enough. The plan's settings say how many samples at most, and how much of each may stay
// untraced; these rules end it earlier.
#pragma once

#include <cstddef>
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
    /// (sampling_limit) must each fall to its share of it (cheapest_goal). Looked at between rounds, in which samples
    /// go where they take most of the error away (SampleRound), so that the picture does not depend on threads and
    /// clocks.
    std::optional<double> error;
    /// Truncation gets at least this share of `error`, at most half: where no residual brings it lower (share_needed).
    double truncation_share = 0.0;
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

/// The error after a round of samples.
struct ErrorReport {
    double samples = 0.0;  ///< per pixel, mean
    double seconds = 0.0;  ///< of rendering since the start of the job
    PictureError error{};
    /// Looks at which sampling was judged, this one included; 0: not yet (is_enough_to_judge).
    int look = 0;
};

/// Whether sampling may be judged after so many samples per pixel: 16, or 65 536 in the picture. A bright spot that all
/// of them miss does not show; with 65 536 it covers less than 1/20 000 of the picture (95 %).
bool is_enough_to_judge(double samples, std::size_t pixels);

/// So many samples per pixel without any light are enough.
inline constexpr std::uint32_t most_dark_samples = 4096;

/// Upper confidence limit of the sampling error of the picture, relative to it. Empty: not estimated, or too few
/// samples.
///
/// Who looks again and again, and stops at the first low estimate, stops at a lucky one (P. Armitage, C. McPherson, B.
/// Rowe, "Repeated significance tests on accumulating data", J. R. Stat. Soc. A 132, 1969). Hence the looks are few,
/// one per quarter of the samples more, and each may err with its own probability, alpha / (j (j + 1)) for the j-th,
/// which over all looks is alpha = 5 % (K. Lan, D. DeMets, "Discrete sequential boundaries for clinical trials",
/// Biometrika 70, 1983), however they depend on each other. Error and estimate are two independent sums over pixels of
/// the same mean and variance: their difference has the standard deviation sqrt(2) sampling_spread sampling^2, and its
/// normal deviate z is taken from P(Z > z) <= exp(-z^2 / 2) / 2. Sums of few squares are more skewed than normal
/// numbers: hence 2 in place of sqrt(2), and where that is more, what the quotient of two sums of nu squares each says,
/// whose logarithm is nearly normal of the variance 4/nu (R. A. Fisher, "On a distribution yielding the error functions
/// of several well known statistics", Proc. Int. Congress of Mathematicians, Toronto 1924), with nu = 3 /
/// sampling_spread^2. Of ten scenes at sixteen errors 95 % or more of the pictures end below E
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

/// Share of the error that truncation must get if a finer residual did not bring it lower: random tails that did not
/// come to an end leave light untraced whatever the residual. Such samples are rare, and the next pixels may have more
/// of them: half as much again as `now`. Empty if it fell, or half of the error is not enough.
std::optional<double> share_needed(const ErrorReport& before, const ErrorReport& now, const ErrorGoal& goal);

}  // namespace pol
