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
      tile_strata_(tiles.size(), 1U),
      last_look_(Clock::now()) {
    std::iota(order_.begin(), order_.end(), 0);
    if (options.watch == Watch::headless)
        queue_round(first_round());
    else
        queue_preview(0);
}

void RenderJob::queue_preview(int level) {
    previews_missing_ = previews[static_cast<std::size_t>(level)].rows;
    for (int row = 0; row < previews_missing_; ++row) queue_.emplace_back(PreviewTask{level, row});
}

/// All samples without a goal; up to the first look with one.
SampleRound RenderJob::first_round() const {
    SampleRound round;
    round.spans.front().end = wanted();
    if (goal_) round.spans.front().end = std::min(wanted(), plan->settings.has_halves() ? samples_to_sort : 1U);
    return round;
}

void RenderJob::queue_round(SampleRound round) {
    round_ = std::make_shared<const SampleRound>(std::move(round));
    tiles_missing_ = 0;
    for (const int tile : order_) {
        TileTask pass = pass_after(tile, 0);
        if (pass.samples.is_empty()) continue;
        ++tiles_missing_;
        queue_.emplace_back(std::move(pass));
    }
}

TileTask RenderJob::pass_after(int tile, std::uint32_t sample) const {
    const std::uint32_t strata = tile_strata_[static_cast<std::size_t>(tile)];
    TileTask pass{tile, round_->next_pass(sample, strata), round_, false};
    pass.more_follow = round_->strata && !round_->next_pass(pass.samples.end, strata).is_empty();
    return pass;
}

RenderTask RenderJob::take(const TileRect& seen) {
    POL_EXPECTS(!queue_.empty());
    const auto is_seen = [&](const RenderTask& task) {
        const auto* pass = std::get_if<TileTask>(&task);
        return pass != nullptr && meet(tiles[static_cast<std::size_t>(pass->tile)], seen);
    };
    auto next = std::find_if(queue_.begin(), queue_.end(), is_seen);
    if (next == queue_.end()) next = queue_.begin();
    busy_.push_back(std::move(*next));
    queue_.erase(next);
    return busy_.back();
}

void RenderJob::forget(const RenderTask& task) {
    const auto gone = std::erase_if(busy_, [&task](const RenderTask& other) { return is_same(task, other); });
    POL_EXPECTS(gone == 1);
}

void RenderJob::drop(const RenderTask& task) {
    forget(task);
}

void RenderJob::fail_for_memory(const RenderTask& task) {
    if (!std::exchange(awaits_report_, false)) forget(task);
    stop(StopReason::memory);
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
        queue_round(first_round());
}

bool RenderJob::deliver(const TileTask& task, const RenderStatistics& statistics) {
    forget(task);
    statistics_.samples += statistics.samples;
    statistics_.nodes += statistics.nodes;
    statistics_.failures += statistics.failures;
    statistics_.most_nodes = std::max(statistics_.most_nodes, statistics.most_nodes);
    statistics_.worst_energy_defect = std::max(statistics_.worst_energy_defect, statistics.worst_energy_defect);
    TileTask pass = pass_after(task.tile, task.samples.end);
    if (!pass.samples.is_empty()) {
        queue_.emplace_back(std::move(pass));
    } else if (--tiles_missing_ == 0) {
        if (!goal_) stop(StopReason::samples);
        awaits_report_ = goal_.has_value();
    }
    return awaits_report_;
}

bool RenderJob::wants_strata(const PictureError& error) const {
    return !round_->strata && round_->spans.front().end >= samples_to_sort && can_be_sorted(error);
}

void RenderJob::report(const PictureError& error, std::shared_ptr<const Strata> strata,
                       const std::array<double, most_strata>& errors) {
    awaits_report_ = false;
    if (cancelled) return;
    ErrorReport report;
    report.samples = round_->samples_at_end(picture_pixels()) / static_cast<double>(picture_pixels());
    report.seconds = seconds_;
    report.error = error;
    if (is_enough_to_judge(report.samples, picture_pixels()))
        report.look = reports_.empty() ? 1 : reports_.back().look + 1;
    reports_.push_back(report);
    const StopReason verdict = judge(report, *goal_);
    if (verdict != StopReason::none) return stop(verdict);
    SampleRound here = *round_;
    if (strata) {
        here.spans.assign(strata->pixels.size(), round_->spans.front());
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            tile_strata_[i] = 0;
            for (std::size_t pixel = 0; pixel < tiles[i].pixel_count(); ++pixel)
                tile_strata_[i] |= 1U << strata->of_pixel(tiles[i], pixel);
        }
        here.strata = std::move(strata);
    }
    auto next = next_round(here, errors, wanted());
    if (!next) return stop(StopReason::samples);
    queue_round(std::move(*next));
}

std::size_t RenderJob::picture_pixels() const {
    return static_cast<std::size_t>(plan->settings.width) * static_cast<std::size_t>(plan->settings.height);
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
    progress.done = static_cast<double>(statistics_.samples) / (static_cast<double>(picture_pixels()) * wanted());
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
