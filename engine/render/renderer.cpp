// SPDX-License-Identifier: Apache-2.0
#include "render/renderer.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

#include "core/contract.h"
#include "core/overloaded.h"
#include "render/render_pass.h"

namespace pol {

using Clock = RenderJob::Clock;

int hardware_threads() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

namespace {

FilmLayout film_layout(const Plan& plan, int tile_size) {
    FilmLayout layout;
    layout.width = plan.settings.width;
    layout.height = plan.settings.height;
    layout.group_of_wavelength = plan.group_of_wavelength;
    layout.group_count = static_cast<int>(plan.groups.size());
    layout.tile_size = tile_size;
    layout.random_samples = plan.settings.mode == SampleMode::area;
    layout.wavelengths_nm = plan.wavelengths_nm;
    layout.brightest = plan.brightest;
    layout.title = plan.title;
    return layout;
}

}  // namespace

Renderer::Renderer(int threads, int tile_size, std::function<void()> wake, std::function<void()> prepare_worker)
    : tile_size_(tile_size), wake_(std::move(wake)), prepare_worker_(std::move(prepare_worker)) {
    POL_EXPECTS(threads > 0 && tile_size > 0);
    for (int i = 0; i < threads; ++i)
        threads_.emplace_back([this](const std::stop_token& shutdown) { work(shutdown); });
    threads_.emplace_back([this](const std::stop_token& shutdown) { keep_time(shutdown); });
}

Renderer::~Renderer() {
    cancel();
    for (std::jthread& thread : threads_) thread.request_stop();
    changed_.notify_all();
    threads_.clear();
}

Generation Renderer::start(std::shared_ptr<const Plan> plan, const RenderOptions& options) {
    std::optional<ErrorGoal> goal;
    if (options.stop.error) {
        goal = cheapest_goal(*plan, *options.stop.error);
        goal->truncation_share = std::max(goal->truncation_share, options.stop.truncation_share);
    }
    Generation generation = 0;
    {
        const std::scoped_lock lock(mutex_);
        if (job_) job_->stop(StopReason::cancelled);
        generation = ++generation_;
        film_.reset(film_layout(*plan, tile_size_), generation);
        job_ = std::make_shared<RenderJob>(std::move(plan), generation, options, goal, tile_size_);
    }
    changed_.notify_all();
    clock_.notify_all();
    return generation;
}

void Renderer::cancel() {
    {
        const std::scoped_lock lock(mutex_);
        if (job_) job_->stop(StopReason::cancelled);
    }
    changed_.notify_all();
}

void Renderer::look_at(const TileRect& seen) {
    const std::scoped_lock lock(mutex_);
    seen_ = seen;
}

void Renderer::pause() {
    const std::scoped_lock lock(mutex_);
    if (!job_) return;
    job_->look(Clock::now());
    job_->pause(true);
}

void Renderer::resume() {
    {
        const std::scoped_lock lock(mutex_);
        if (!job_) return;
        job_->look(Clock::now());
        job_->pause(false);
    }
    changed_.notify_all();
    clock_.notify_all();
}

bool Renderer::wait_for(double seconds) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, std::chrono::duration<double>(seconds),
                             [this] { return !job_ || job_->finished(); });
}

void Renderer::wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !job_ || job_->finished(); });
}

RenderProgress Renderer::progress() const {
    const std::scoped_lock lock(mutex_);
    if (!job_) return {};
    RenderProgress progress = job_->progress(Clock::now());
    progress.film = film_.status();
    return progress;
}

Renderer::Work Renderer::next(const std::stop_token& shutdown) {
    std::unique_lock lock(mutex_);
    const bool ready = changed_.wait(lock, shutdown, [this] { return job_ && !job_->paused() && job_->has_work(); });
    if (!ready) return {};
    return {job_, job_->take(seen_)};
}

/// Traces one task and hands the result to the film and the job.
void Renderer::render(PassTracer& tracer, const Work& work) {
    RenderJob& job = *work.job;
    const auto drop = [&] {
        const std::scoped_lock lock(mutex_);
        job.drop(work.task);
    };
    std::visit(Overloaded{
                   [&](const PreviewTask& task) {
                       PreviewStrip strip;
                       strip.generation = job.generation;
                       strip.row = task.row;
                       tracer.preview(job.previews[static_cast<std::size_t>(task.level)], job.cancelled, strip);
                       if (job.cancelled.load() || !film_.show(strip)) return drop();
                       const std::scoped_lock lock(mutex_);
                       job.deliver(task, strip, Clock::now());
                   },
                   [&](const TileTask& task) {
                       TileBuffer buffer;
                       buffer.generation = job.generation;
                       buffer.rect = job.tiles[static_cast<std::size_t>(task.tile)];
                       buffer.pixels = task.round->pixels_of(task.samples, buffer.rect);
                       buffer.more_follow = task.more_follow;
                       const RenderStatistics statistics = tracer.trace(task.samples, job.cancelled, buffer);
                       if (job.cancelled.load() || !film_.merge(buffer)) return drop();  // half a tile is no tile
                       std::unique_lock lock(mutex_);
                       job.look(Clock::now());
                       if (!job.deliver(task, statistics)) return;
                       lock.unlock();
                       const PictureError error = film_.status().error;
                       auto strata = job.wants_strata(error) ? film_.stratify(job.generation) : nullptr;
                       const auto errors = film_.stratum_errors(job.generation);
                       lock.lock();
                       job.report(error, std::move(strata), errors);
                   },
               },
               work.task);
}

void Renderer::work(const std::stop_token& shutdown) {
    if (prepare_worker_) prepare_worker_();
    std::shared_ptr<const Plan> plan;  // of the tracer below
    std::unique_ptr<PassTracer> tracer;
    while (!shutdown.stop_requested()) {
        const Work work = next(shutdown);
        if (!work.job) return;
        try {
            if (plan != work.job->plan) {
                tracer = make_pass_tracer(*work.job->plan);
                plan = work.job->plan;
            }
            render(*tracer, work);
        } catch (const std::bad_alloc&) {
            const std::scoped_lock lock(mutex_);
            work.job->fail_for_memory(work.task);
        }
        changed_.notify_all();
        if (wake_) wake_();
    }
}

/// Looks at the clock while a job runs, often enough to tell a suspended program from a slow one (RenderJob::look).
void Renderer::keep_time(const std::stop_token& shutdown) {
    constexpr double look_every_s = 0.1;
    std::unique_lock lock(mutex_);
    const auto runs = [this] { return job_ && !job_->paused() && !job_->finished() && !job_->cancelled; };
    while (clock_.wait(lock, shutdown, runs)) {
        const std::shared_ptr<RenderJob> job = job_;
        job->look(Clock::now());
        if (job->finished()) {  // time is up, and no worker was at anything that would tell
            lock.unlock();
            changed_.notify_all();
            if (wake_) wake_();
            lock.lock();
            continue;
        }
        const std::chrono::duration<double> nap(std::clamp(job->seconds_to_limit(), 0.0, look_every_s));
        clock_.wait_for(lock, shutdown, nap, [&] { return job_ != job; });
    }
}

}  // namespace pol
