// SPDX-License-Identifier: Apache-2.0
// What is to be done for one picture, in which order, and what of it is done.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "film/film.h"
#include "plan/plan.h"
#include "render/preview.h"
#include "render/render_progress.h"
#include "render/sample_round.h"
#include "render/stop_rules.h"

namespace pol {

/// One row of preview blocks.
struct PreviewTask {
    int level = 0;  ///< index into RenderJob::previews
    int row = 0;
};

/// Samples of those pixels of a tile that get them in this round.
struct TileTask {
    int tile = 0;
    SampleSpan samples{};
    std::shared_ptr<const SampleRound> round;
    bool more_follow = false;  ///< TileBuffer::more_follow
};

using RenderTask = std::variant<PreviewTask, TileTask>;

/// One call of Renderer::start(). Thread safety: none but for `cancelled`, which may be read at any time, and what is
/// constant; Renderer locks the rest.
class RenderJob {
public:
    using Clock = std::chrono::steady_clock;

    /// `goal` is that of options.stop.error.
    RenderJob(std::shared_ptr<const Plan> plan, Generation generation, const RenderOptions& options,
              const std::optional<ErrorGoal>& goal, int tile_size);

    const std::shared_ptr<const Plan> plan;
    const Generation generation;
    const std::vector<TileRect> tiles;
    const std::vector<PreviewGrid> previews;
    std::atomic<bool> cancelled{false};

    /// Nothing is under way, and nothing will be.
    [[nodiscard]] bool finished() const {
        return busy_.empty() && !awaits_report_ && (queue_.empty() || cancelled.load());
    }
    [[nodiscard]] bool has_work() const { return !cancelled.load() && !queue_.empty(); }

    /// The next task; of passes those first that somebody sees, of tiles that meet `seen`. Requires: has_work().
    RenderTask take(const TileRect& seen = {});
    /// The task ends without a result.
    void drop(const RenderTask& task);
    /// There is no memory for the task, or for the report after it.
    void fail_for_memory(const RenderTask& task);
    /// A row of the preview is in the film. After the last of a level comes the next one, if it pays, or the tiles.
    void deliver(const PreviewTask& task, const PreviewStrip& strip, Clock::time_point now);
    /// A pass is in the film. True if it was the last of a round, and the error rule wants to know the error: then
    /// report() must follow before the job goes on.
    [[nodiscard]] bool deliver(const TileTask& task, const RenderStatistics& statistics);
    /// Whether the film's pixels are to be sorted into strata for the next report. While that is awaited nothing that
    /// this reads changes: no lock is needed.
    [[nodiscard]] bool wants_strata(const PictureError& error) const;
    /// `strata`: null if not wanted, or sorted before. `errors`: what each adds to the error of the picture.
    void report(const PictureError& error, std::shared_ptr<const Strata> strata,
                const std::array<double, most_strata>& errors);

    void stop(StopReason reason);
    /// Counts the time since the last look, unless the job was paused or the program suspended; applies the time limit.
    void look(Clock::time_point now);
    void pause(bool paused) { paused_ = paused; }
    [[nodiscard]] bool paused() const { return paused_; }

    /// All but what the film knows.
    [[nodiscard]] RenderProgress progress(Clock::time_point now) const;
    /// At the last look.
    [[nodiscard]] double seconds_to_limit() const;

private:
    [[nodiscard]] double seconds_at(Clock::time_point now) const;
    void queue_preview(int level);
    [[nodiscard]] SampleRound first_round() const;
    void queue_round(SampleRound round);
    [[nodiscard]] TileTask pass_after(int tile, std::uint32_t sample) const;
    [[nodiscard]] std::size_t picture_pixels() const;
    void forget(const RenderTask& task);
    [[nodiscard]] std::uint32_t wanted() const { return static_cast<std::uint32_t>(plan->settings.samples_per_pixel); }

    StopRules rules_;
    std::optional<ErrorGoal> goal_;
    std::deque<RenderTask> queue_;
    std::vector<RenderTask> busy_;
    std::vector<int> order_;  // of the tiles
    TileImportance importance_;
    int previews_missing_ = 0;  // rows of the level under way
    Clock::time_point level_began_;
    std::shared_ptr<const SampleRound> round_;
    std::vector<std::uint32_t> tile_strata_;  // by tile: the strata of its pixels, a bit for each
    int tiles_missing_ = 0;                   // that have passes left in the round
    bool awaits_report_ = false;
    RenderStatistics statistics_{};
    std::vector<ErrorReport> reports_;
    StopReason reason_ = StopReason::none;
    double seconds_ = 0.0;
    Clock::time_point last_look_;
    bool paused_ = false;
};

}  // namespace pol
