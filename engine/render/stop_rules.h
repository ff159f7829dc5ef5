// SPDX-License-Identifier: Apache-2.0
// When a picture is good enough. The plan's settings say how many samples at most, and how much of each may stay
// untraced; these rules end it earlier.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "film/picture_error.h"

namespace pol {

struct StopRules {
    /// Seconds of rendering; pauses and a suspended program do not count.
    std::optional<double> seconds;
    /// Largest error of the picture, relative to it: truncation and sampling (PictureError) must each fall to half of
    /// it, so that their sum stays below whatever their signs. Looked at when all pixels have the same number of
    /// samples, so that the picture does not depend on threads and clocks.
    std::optional<double> error;
};

enum class StopReason {
    none,        ///< still going, or no job
    samples,     ///< all samples of the plan are there
    time,        ///< StopRules::seconds
    error,       ///< StopRules::error is reached
    truncation,  ///< no number of samples will reach StopRules::error: a plan with finer_residual() may
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

/// Below this many samples the halves are too small to be believed: a bright spot that every second pixel misses
/// with all of them would not show.
inline constexpr std::uint32_t fewest_samples_to_stop = 8;

/// Whether that part is at most half of `target`.
bool has_fallen(ErrorPart part, const ErrorReport& report, double target);

/// What the error rule says to a report: error (stop, reached), truncation (stop, out of reach) or none (go on).
StopReason judge(const ErrorReport& report, double target);

/// The part that stayed too large the longest: the one that was still above half of `target` when the other was not,
/// or both. Empty if neither ever was too large, or the last report does not reach the target.
std::optional<ErrorPart> last_to_fall(const std::vector<ErrorReport>& reports, double target);

/// Residual (RenderSettings) that should bring truncation below its share of the target, from the one that did not:
/// the bound falls in proportion to it, with a margin because shares of a pixel fall short of the residual by a varying
/// factor. Empty if no residual will: the light is missing for another reason (a depth limit, tails that count as
/// bounds, failed samples, a black picture).
std::optional<double> finer_residual(const ErrorReport& report, double residual, double target);

}  // namespace pol
