// SPDX-License-Identifier: Apache-2.0
// Makes the picture: workers take tiles from a queue, trace one pass, and hand it to the film.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "film/film.h"
#include "plan/plan.h"

namespace pol {

/// What the workers have done in the current job.
struct RenderStatistics {
    std::uint64_t samples = 0;  ///< camera samples, each counted once for all its wavelengths
    std::uint64_t nodes = 0;    ///< rays followed
    std::uint64_t failures = 0;
    std::uint32_t most_nodes = 0;      ///< in one tree
    double worst_energy_defect = 0.0;  ///< largest |resolved + absorbed + residual + tail - 1|
};

struct RenderProgress {
    double done = 0.0;  ///< share of the samples asked for, 0..1
    bool finished = false;
    RenderStatistics statistics{};
};

/// Threads that the machine can run at once, at least 1.
int hardware_threads();

/// Thread safety: all members from the owner's thread; `wake` is called from workers.
class Renderer {
public:
    /// `wake` is called after every merged tile and at the end of a job.
    explicit Renderer(int threads, int tile_size = 32, std::function<void()> wake = {});
    /// Stops and joins.
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Starts over with a new plan; does not wait for what is running, whose results are refused from now on.
    void start(std::shared_ptr<const Plan> plan);

    /// Ends the current job; what is finished stays in the film. Workers stop within one interface of each other.
    void cancel();

    /// Stops handing out tiles until resume().
    void pause();
    void resume();

    /// Waits until the job is finished or `seconds` have passed; true if finished.
    bool wait_for(double seconds);

    [[nodiscard]] RenderProgress progress() const;

    /// Picture so far, with wavelengths, brightest and attributes of the plan.
    [[nodiscard]] StokesImage snapshot() const;

    [[nodiscard]] const Film& film() const { return film_; }

private:
    struct Job;
    struct TileTask {
        int tile = 0;
        std::uint32_t first_sample = 0;
    };
    struct Work {
        std::shared_ptr<Job> job;
        TileTask task{};
    };

    void work(const std::stop_token& shutdown);
    [[nodiscard]] Work next(const std::stop_token& shutdown);
    void give_back(const Work& work, bool delivered, const RenderStatistics& statistics);

    Film film_;
    int tile_size_;
    std::function<void()> wake_;
    mutable std::mutex mutex_;  // guards the members below; taken before the film's
    std::condition_variable_any changed_;
    std::shared_ptr<Job> job_;
    Generation generation_ = 0;
    bool paused_ = false;
    std::vector<std::jthread> workers_;
};

}  // namespace pol
