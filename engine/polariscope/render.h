// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>

#include "polariscope/picture.h"
#include "polariscope/plan.h"
#include "polariscope/result.h"

namespace polariscope {

/// How far a render is.
struct RenderProgress {
    double done = 0.0;                   ///< share of the samples asked for, 0 to 1
    double seconds = 0.0;                ///< of rendering
    std::optional<double> seconds_left;  ///< empty until there is a clue
    std::uint32_t fewest_samples = 0;    ///< of a pixel
    double truncation = 0.0;             ///< bound of the error by light that was not traced, relative to the picture
    std::optional<double> sampling;      ///< estimate (68 %) of the error by too few samples, relative; may be unknown
    std::uint64_t failures = 0;          ///< samples whose arithmetic failed
};

enum class RenderEnd {
    samples,     ///< all samples are there
    seconds,     ///< RenderOptions::seconds
    error,       ///< RenderOptions::error is reached
    truncation,  ///< RenderOptions::error is out of reach: set a smaller residual
    dark,        ///< RenderOptions::error means nothing: no sample has met any light
    stopped,     ///< RenderOptions::stop
};

struct RenderOptions {
    int threads = 0;                ///< 1 to 1024; 0: all that the machine has. The picture does not depend on it
    std::optional<double> seconds;  ///< end after so many and keep what is finished
    /// End when the error, relative to the picture, is below this with 95 % confidence (mode area).
    std::optional<double> error;
    /// Called on the calling thread ten times a second and at the end. An exception out of it ends the render and comes
    /// back as an Error.
    std::function<void(const RenderProgress&)> progress;
    std::stop_token stop;  ///< end at once and keep what is finished; from any thread
};

struct Rendering {
    Picture picture;
    RenderProgress progress;  ///< at the end
    RenderEnd end = RenderEnd::samples;
};

/// Renders to the end; returns when all is done. Several renders may run at once. The same plan gives the same picture,
/// to the last bit, whatever the threads. Error: (usage) options out of range, (memory) the picture does not fit.
Result<Rendering> render(const Plan& plan, const RenderOptions& options = {});

}  // namespace polariscope
