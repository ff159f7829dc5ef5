// SPDX-License-Identifier: Apache-2.0
// What `polariscope render` says about a picture: while it is made, at the end, and to --stats.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/scene_options.h"
#include "core/result.h"
#include "film/stokes_image.h"
#include "render/renderer.h"

namespace pol {

struct RenderRequest {
    SceneOptions scene;
    std::string output;
    std::optional<int> threads;
    std::optional<double> seconds;
    std::optional<double> error;
    std::string statistics;
    std::string display;  ///< HOST:PORT of a viewer; empty: none
    bool quiet = false;
};

/// How the rendering went.
struct RenderOutcome {
    RenderProgress progress{};         ///< at the end
    double seconds = 0.0;              ///< of rendering, without pauses, over all residuals that were tried
    int signal = 0;                    ///< that ended it; 0: none
    bool open_ended = false;           ///< no number of samples was asked for
    std::vector<ErrorReport> reports;  ///< of the error rule, over all residuals that were tried
};

struct RenderTiming {
    double load_s = 0.0;
    double render_cpu_s = 0.0;
    double output_s = 0.0;
};

/// One line: how an error goal is split.
std::string goal_text(const ErrorGoal& goal);

/// One line about the error after a pass, on stderr.
void print_error_report(const ErrorReport& report);

/// Times, counts and errors as JSON into request.statistics.
Result<Done> write_statistics(const RenderRequest& request, const Plan& plan, const RenderOutcome& outcome,
                              const StokesImage& image, const RenderTiming& timing, int threads,
                              double film_bytes_per_pixel);

/// Says on stdout what was made, and on stderr what is wrong with it; returns the exit code.
int conclude(const RenderRequest& request, const RenderOutcome& outcome, const StokesImage& image);

}  // namespace pol
