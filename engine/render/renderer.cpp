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
        workers_.emplace_back([this](const std::stop_token& shutdown) { work(shutdown); });
}

Renderer::~Renderer() {
    cancel();
    for (std::jthread& worker : workers_) worker.request_stop();
    changed_.notify_all();
    workers_.clear();
}

Generation Renderer::start(std::shared_ptr<const Plan> plan, const RenderOptions& options) {
    Generation generation = 0;
    {
        const std::scoped_lock lock(mutex_);
        if (job_) job_->stop(StopReason::cancelled);
        generation = ++generation_;
        job_ = std::make_shared<RenderJob>(std::move(plan), generation, options, tile_size_);
        film_.reset(film_layout(*job_->plan, tile_size_), generation);
    }
    changed_.notify_all();
    return generation;
}

void Renderer::cancel() {
    {
        const std::scoped_lock lock(mutex_);
        if (job_) job_->stop(StopReason::cancelled);
    }
    changed_.notify_all();
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
}

bool Renderer::wait_for(double seconds) {
    constexpr double look_every_s = 0.1;
    const auto begin = Clock::now();
    std::unique_lock lock(mutex_);
    for (;;) {
        if (!job_) return true;
        const auto now = Clock::now();
        job_->look(now);
        if (job_->finished()) return true;
        const double left = seconds - std::chrono::duration<double>(now - begin).count();
        if (left <= 0.0) return false;
        const double nap = std::min({left, look_every_s, job_->seconds_to_limit()});
        changed_.wait_for(lock, std::chrono::duration<double>(nap));
    }
}

RenderProgress Renderer::progress() const {
    const std::scoped_lock lock(mutex_);
    if (!job_) return {};
    job_->look(Clock::now());
    RenderProgress progress = job_->progress();
    progress.film = film_.status();
    return progress;
}

Renderer::Work Renderer::next(const std::stop_token& shutdown) {
    std::unique_lock lock(mutex_);
    const bool ready = changed_.wait(lock, shutdown, [this] { return job_ && !job_->paused() && job_->has_work(); });
    if (!ready) return {};
    return {job_, job_->take()};
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
                       tracer.preview(job.preview, job.cancelled, strip);
                       if (job.cancelled.load() || !film_.show(strip)) return drop();
                       const std::scoped_lock lock(mutex_);
                       job.deliver(task, strip);
                   },
                   [&](const TileTask& task) {
                       TileBuffer buffer;
                       buffer.generation = job.generation;
                       buffer.rect = job.tiles[static_cast<std::size_t>(task.tile)];
                       const RenderStatistics statistics =
                           tracer.trace(task.first_sample, task.last_sample, job.cancelled, buffer);
                       if (job.cancelled.load() || !film_.merge(buffer)) return drop();  // half a tile is no tile
                       const std::scoped_lock lock(mutex_);
                       job.look(Clock::now());
                       if (job.deliver(task, statistics)) job.report(film_.status().error);
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
            work.job->drop(work.task);
            work.job->stop(StopReason::memory);
        }
        changed_.notify_all();
        if (wake_) wake_();
    }
}

}  // namespace pol
