// SPDX-License-Identifier: Apache-2.0
// What a render is asked for besides its plan, and how far it is.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "film/film.h"
#include "render/stop_rules.h"

namespace pol {

/// Whether somebody looks at the picture while it is made.
enum class Watch {
    headless,  ///< tiles in the order of lines, no preview
    live,      ///< first a coarse preview, then the tiles that matter most; the finished picture is the same to the bit
};

struct RenderOptions {
    Watch watch = Watch::headless;
    StopRules stop{};
};

/// What the workers have done in the current job, without the preview.
struct RenderStatistics {
    std::uint64_t samples = 0;  ///< camera samples, each counted once for all its wavelengths
    std::uint64_t nodes = 0;    ///< rays followed
    std::uint64_t failures = 0;
    std::uint32_t most_nodes = 0;      ///< in one tree
    double worst_energy_defect = 0.0;  ///< largest |resolved + absorbed + residual + tail - 1|
};

struct RenderProgress {
    Generation generation = 0;  ///< of the job; 0: none was started
    double done = 0.0;          ///< share of the samples asked for, 0..1
    bool finished = false;
    StopReason reason = StopReason::none;
    bool paused = false;
    RenderStatistics statistics{};
    double seconds = 0.0;                  ///< of rendering; pauses and a suspended program do not count
    std::optional<double> seconds_left{};  ///< by the rule that is expected to end the job; empty until there is a clue
    FilmStatus film{};                     ///< samples per pixel, bound, sampling estimate
    std::vector<TileRect> under_way{};     ///< tiles that workers are at
    std::optional<ErrorGoal> goal{};       ///< of the error rule
    std::vector<ErrorReport> reports{};    ///< of the error rule, in the order of samples
};

}  // namespace pol
