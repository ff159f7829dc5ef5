// SPDX-License-Identifier: Apache-2.0
#include "render/render_job.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/contract.h"
#include "core/overloaded.h"

namespace pol {

namespace {

/// Passes double in length, so that a picture is there early and the overhead of a pass vanishes later. The limits
/// depend on nothing but the sample number: every run sums a pixel in the same order.
std::uint32_t pass_end(std::uint32_t first_sample, std::uint32_t wanted) {
    constexpr std::uint32_t longest = 16;
    const std::uint32_t length = std::clamp(first_sample, 1U, longest);
    return std::min(wanted, first_sample + length);
}

/// Samples at which the error is looked at after `samples`, at the end of a pass: whoever looks more often stops at
/// luckier moments (sampling_limit).
std::uint32_t next_look(std::uint32_t samples, std::uint32_t wanted) {
    return samples < wanted / 2 ? 2 * samples : wanted;
}

bool is_same(const RenderTask& a, const RenderTask& b) {
    return std::visit(
        Overloaded{
            [](const PreviewTask& x, const PreviewTask& y) { return x.level == y.level && x.row == y.row; },
            [](const TileTask& x, const TileTask& y) { return x.tile == y.tile; },
            [](const auto&, const auto&) { return false; },
        },
        a, b);
}

}  // namespace

RenderJob::RenderJob(std::shared_ptr<const Plan> the_plan, Generation number, const RenderOptions& options,
                     const std::optional<ErrorGoal>& goal, int tile_size)
    : plan(std::move(the_plan)),
      generation(number),
      tiles(cut_tiles(plan->settings.width, plan->settings.height, tile_size)),
      previews(preview_levels(*plan)),
      rules_(options.stop),
      goal_(goal),
      order_(tiles.size()),
      importance_(*plan, previews.front()),
      level_began_(Clock::now()),
      last_look_(Clock::now()) {
    std::iota(order_.begin(), order_.end(), 0);
    if (goal_) next_report_ = 1;
    if (options.watch == Watch::headless)
        queue_passes(0);
    else
        queue_preview(0);
}

void RenderJob::queue_preview(int level) {
    previews_missing_ = previews[static_cast<std::size_t>(level)].rows;
    for (int row = 0; row < previews_missing_; ++row) queue_.emplace_back(PreviewTask{level, row});
}

void RenderJob::queue_passes(std::uint32_t first_sample) {
    for (const int tile : order_) queue_.emplace_back(TileTask{tile, first_sample, pass_end(first_sample, wanted())});
}

RenderTask RenderJob::take() {
    POL_EXPECTS(!queue_.empty());
    busy_.push_back(queue_.front());
    queue_.pop_front();
    return busy_.back();
}

void RenderJob::forget(const RenderTask& task) {
    const auto found =
        std::find_if(busy_.begin(), busy_.end(), [&task](const RenderTask& other) { return is_same(task, other); });
    POL_EXPECTS(found != busy_.end());
    busy_.erase(found);
}

void RenderJob::drop(const RenderTask& task) {
    forget(task);
}

void RenderJob::deliver(const PreviewTask& task, const PreviewStrip& strip, Clock::time_point now) {
    forget(task);
    if (task.level == 0) importance_.add(strip);
    if (--previews_missing_ > 0) return;
    if (task.level == 0) order_ = importance_.order(tiles);
    const double seconds = std::chrono::duration<double>(now - level_began_).count();
    level_began_ = now;
    const int next = task.level + 1;
    if (next < static_cast<int>(previews.size()) &&
        next_level_pays(previews[static_cast<std::size_t>(task.level)], seconds))
        queue_preview(next);
    else
        queue_passes(0);
}

bool RenderJob::deliver(const TileTask& task, const RenderStatistics& statistics) {
    forget(task);
    statistics_.samples += statistics.samples;
    statistics_.nodes += statistics.nodes;
    statistics_.failures += statistics.failures;
    statistics_.most_nodes = std::max(statistics_.most_nodes, statistics.most_nodes);
    statistics_.worst_energy_defect = std::max(statistics_.worst_energy_defect, statistics.worst_energy_defect);
    if (task.last_sample == next_report_) return ++tiles_arrived_ == static_cast<int>(tiles.size());
    if (task.last_sample < wanted())
        queue_.emplace_back(TileTask{task.tile, task.last_sample, pass_end(task.last_sample, wanted())});
    else if (queue_.empty() && busy_.empty())
        stop(StopReason::samples);
    return false;
}

void RenderJob::report(const PictureError& error) {
    const std::uint32_t samples = next_report_;
    reports_.push_back({samples, seconds_, error});
    const StopReason verdict = judge(reports_.back(), *goal_);
    if (verdict != StopReason::none) return stop(verdict);
    if (samples == wanted()) return stop(StopReason::samples);
    next_report_ = next_look(samples, wanted());
    tiles_arrived_ = 0;
    queue_passes(samples);
}

void RenderJob::stop(StopReason reason) {
    if (reason_ != StopReason::none) return;
    reason_ = reason;
    queue_.clear();
    if (reason == StopReason::cancelled || reason == StopReason::time || reason == StopReason::memory) cancelled = true;
}

double RenderJob::seconds_at(Clock::time_point now) const {
    // Only a suspended program (Ctrl-Z, a sleeping computer) looks this late.
    constexpr double longest_gap_s = 1.0;
    const double passed = std::chrono::duration<double>(now - last_look_).count();
    return paused_ || finished() || passed > longest_gap_s ? seconds_ : seconds_ + passed;
}

void RenderJob::look(Clock::time_point now) {
    seconds_ = seconds_at(now);
    last_look_ = now;
    if (!finished() && !paused_ && seconds_to_limit() <= 0.0) stop(StopReason::time);
}

double RenderJob::seconds_to_limit() const {
    return rules_.seconds ? *rules_.seconds - seconds_ : std::numeric_limits<double>::infinity();
}

RenderProgress RenderJob::progress(Clock::time_point now) const {
    const double seconds = seconds_at(now);
    RenderProgress progress;
    progress.generation = generation;
    const RenderSettings& settings = plan->settings;
    const double samples_wanted = static_cast<double>(settings.width) * static_cast<double>(settings.height) *
                                  static_cast<double>(settings.samples_per_pixel);
    progress.done = static_cast<double>(statistics_.samples) / samples_wanted;
    progress.finished = finished();
    progress.reason = reason_;
    progress.paused = paused_;
    progress.statistics = statistics_;
    progress.seconds = seconds;
    for (const RenderTask& task : busy_)
        if (const auto* at = std::get_if<TileTask>(&task))
            progress.under_way.push_back(tiles[static_cast<std::size_t>(at->tile)]);
    progress.goal = goal_;
    progress.reports = reports_;

    double left = rules_.seconds ? *rules_.seconds - seconds : std::numeric_limits<double>::infinity();
    if (progress.done > 0.0) left = std::min(left, seconds / progress.done - seconds);
    if (!reports_.empty() && goal_ && sampling_limit(reports_.back())) {
        // Halves of quasi-random samples: the error falls like N^-0.75 (CUTTING.md 4).
        const double factor = std::pow(*sampling_limit(reports_.back()) / goal_->sampling(), 4.0 / 3.0);
        left = std::min(left, std::max(0.0, reports_.back().seconds * factor - seconds));
    }
    if (progress.finished)
        progress.seconds_left = 0.0;
    else if (std::isfinite(left))
        progress.seconds_left = left;
    return progress;
}

}  // namespace pol
