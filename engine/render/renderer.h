// SPDX-License-Identifier: Apache-2.0
// Makes the picture: workers take tiles from a queue, trace one pass, and hand it to the film.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "film/film.h"
#include "plan/plan.h"
#include "render/render_job.h"
#include "render/render_progress.h"

namespace pol {

class PassTracer;

/// Threads that the machine can run at once, at least 1.
int hardware_threads();

/// Thread safety: snapshot(), film(), progress() and cancel() from any thread, the other members from the owner's;
/// `wake` is called from threads of the renderer. One of them keeps the time limit; the time of a suspended program
/// does not count.
class Renderer {
public:
    /// `wake` is called after every tile or row of the preview that is in the film, and at the end of a job. Smaller
    /// tiles show something new sooner; the picture does not depend on them. `prepare_worker`
    /// is the first thing that every worker does.
    explicit Renderer(int threads, int tile_size = 32, std::function<void()> wake = {},
                      std::function<void()> prepare_worker = {});
    /// Stops and joins.
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Starts over with a new plan; does not wait for what is running, whose results are refused from now on. Returns
    /// the generation that the film then has.
    Generation start(std::shared_ptr<const Plan> plan, const RenderOptions& options = {});

    /// Ends the current job; what is finished stays in the film. Workers stop within one interface of each other.
    void cancel();

    /// From now on passes over the part of the picture that somebody looks at come first, in this and later jobs: what
    /// else there is to do in a round waits. The finished picture does not depend on it.
    void look_at(const TileRect& seen);

    /// Stops handing out tiles until resume().
    void pause();
    void resume();

    /// Waits until the job is finished or `seconds` have passed; true if finished, or if there is none.
    bool wait_for(double seconds);
    /// Waits until the job is finished. One that is paused is not.
    void wait();

    [[nodiscard]] RenderProgress progress() const;

    /// Picture so far, with wavelengths, brightest and title of the plan. Does not hold up the workers.
    [[nodiscard]] StokesImage snapshot() const { return film_.snapshot(); }

    [[nodiscard]] const Film& film() const { return film_; }

private:
    struct Work {
        std::shared_ptr<RenderJob> job;
        RenderTask task{};
    };

    void work(const std::stop_token& shutdown);
    [[nodiscard]] Work next(const std::stop_token& shutdown);
    void render(PassTracer& tracer, const Work& work);
    void keep_time(const std::stop_token& shutdown);

    Film film_;
    int tile_size_;
    std::function<void()> wake_;
    std::function<void()> prepare_worker_;
    mutable std::mutex mutex_;  // guards the members below; taken before the film's
    std::condition_variable_any changed_;
    std::condition_variable_any clock_;  // a job begins or goes on
    std::shared_ptr<RenderJob> job_;
    TileRect seen_{};
    Generation generation_ = 0;
    std::vector<std::jthread> threads_;  // the workers, and who keeps the time
};

}  // namespace pol
