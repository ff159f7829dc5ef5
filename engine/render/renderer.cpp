// SPDX-License-Identifier: Apache-2.0
#include "render/renderer.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>

#include "render/render_pass.h"

namespace pol {

int hardware_threads() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// One call of start(). Everything but `cancelled` is guarded by the renderer's mutex or constant.
struct Renderer::Job {
    std::shared_ptr<const Plan> plan;
    Generation generation = 0;
    std::vector<TileRect> tiles;
    std::deque<TileTask> queue;
    int busy = 0;
    std::uint64_t samples_wanted = 0;
    RenderStatistics statistics{};
    std::atomic<bool> cancelled{false};

    [[nodiscard]] bool finished() const { return busy == 0 && (queue.empty() || cancelled.load()); }
};

namespace {

std::vector<TileRect> cut_tiles(int width, int height, int size) {
    std::vector<TileRect> tiles;
    for (int y = 0; y < height; y += size)
        for (int x = 0; x < width; x += size)
            tiles.push_back({x, y, std::min(x + size, width), std::min(y + size, height)});
    return tiles;
}

/// Passes double in length, so that a picture is there early and the overhead of a pass vanishes later. The limits
/// depend on nothing but the sample number: every run sums a pixel in the same order.
std::uint32_t pass_end(std::uint32_t first_sample, std::uint32_t wanted) {
    constexpr std::uint32_t longest = 16;
    const std::uint32_t length = std::clamp(first_sample, 1U, longest);
    return std::min(wanted, first_sample + length);
}

}  // namespace

Renderer::Renderer(int threads, int tile_size, std::function<void()> wake)
    : tile_size_(tile_size), wake_(std::move(wake)) {
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

void Renderer::start(std::shared_ptr<const Plan> plan) {
    auto job = std::make_shared<Job>();
    job->plan = std::move(plan);
    const RenderSettings& settings = job->plan->settings;
    job->tiles = cut_tiles(settings.width, settings.height, tile_size_);
    for (int tile = 0; tile < static_cast<int>(job->tiles.size()); ++tile) job->queue.push_back({tile, 0});
    job->samples_wanted = static_cast<std::uint64_t>(settings.width) * static_cast<std::uint64_t>(settings.height) *
                          static_cast<std::uint64_t>(settings.samples_per_pixel);
    {
        const std::scoped_lock lock(mutex_);
        if (job_) job_->cancelled = true;
        job->generation = ++generation_;
        film_.reset({settings.width, settings.height, job->plan->group_of_wavelength,
                     static_cast<int>(job->plan->groups.size())},
                    job->generation);
        job_ = std::move(job);
        paused_ = false;
    }
    changed_.notify_all();
}

void Renderer::cancel() {
    {
        const std::scoped_lock lock(mutex_);
        if (job_) job_->cancelled = true;
    }
    changed_.notify_all();
}

void Renderer::pause() {
    const std::scoped_lock lock(mutex_);
    paused_ = true;
}

void Renderer::resume() {
    {
        const std::scoped_lock lock(mutex_);
        paused_ = false;
    }
    changed_.notify_all();
}

bool Renderer::wait_for(double seconds) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, std::chrono::duration<double>(seconds),
                             [this] { return !job_ || job_->finished(); });
}

RenderProgress Renderer::progress() const {
    const std::scoped_lock lock(mutex_);
    if (!job_) return {};
    return {static_cast<double>(job_->statistics.samples) / static_cast<double>(job_->samples_wanted), job_->finished(),
            job_->statistics};
}

StokesImage Renderer::snapshot() const {
    std::shared_ptr<const Plan> plan;
    StokesImage image;
    {
        const std::scoped_lock lock(mutex_);
        POL_EXPECTS(job_ != nullptr);
        plan = job_->plan;
        image = film_.snapshot();
    }
    image.wavelengths_nm = plan->wavelengths_nm;
    image.brightest = plan->brightest;
    image.attributes["title"] = plan->title;
    return image;
}

Renderer::Work Renderer::next(const std::stop_token& shutdown) {
    std::unique_lock lock(mutex_);
    const bool ready = changed_.wait(
        lock, shutdown, [this] { return job_ && !paused_ && !job_->cancelled.load() && !job_->queue.empty(); });
    if (!ready) return {};
    Work work{job_, job_->queue.front()};
    job_->queue.pop_front();
    ++job_->busy;
    return work;
}

void Renderer::give_back(const Work& work, bool delivered, const RenderStatistics& statistics) {
    Job& job = *work.job;
    const auto wanted = static_cast<std::uint32_t>(job.plan->settings.samples_per_pixel);
    {
        const std::scoped_lock lock(mutex_);
        --job.busy;
        if (delivered) {
            job.statistics.samples += statistics.samples;
            job.statistics.nodes += statistics.nodes;
            job.statistics.failures += statistics.failures;
            job.statistics.most_nodes = std::max(job.statistics.most_nodes, statistics.most_nodes);
            job.statistics.worst_energy_defect =
                std::max(job.statistics.worst_energy_defect, statistics.worst_energy_defect);
            const std::uint32_t end = pass_end(work.task.first_sample, wanted);
            if (end < wanted) job.queue.push_back({work.task.tile, end});
        }
    }
    changed_.notify_all();
    if (wake_) wake_();
}

void Renderer::work(const std::stop_token& shutdown) {
    std::shared_ptr<const Plan> plan;  // of the tracer below
    std::unique_ptr<PassTracer> tracer;
    while (!shutdown.stop_requested()) {
        const Work work = next(shutdown);
        if (!work.job) return;
        Job& job = *work.job;
        if (plan != job.plan) {
            tracer = make_pass_tracer(*job.plan);
            plan = job.plan;
        }
        TileBuffer buffer;
        buffer.generation = job.generation;
        buffer.rect = job.tiles[static_cast<std::size_t>(work.task.tile)];
        const std::uint32_t end =
            pass_end(work.task.first_sample, static_cast<std::uint32_t>(job.plan->settings.samples_per_pixel));
        const RenderStatistics statistics = tracer->trace(work.task.first_sample, end, job.cancelled, buffer);
        const bool delivered = !job.cancelled.load() && film_.merge(buffer);  // half a tile is no tile
        give_back(work, delivered, statistics);
    }
}

}  // namespace pol
