// SPDX-License-Identifier: Apache-2.0
// Files are written by one thread in the background, one after the other, while the window goes on.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/result.h"
#include "viewer/session/log.h"

namespace pol {

/// How far a file is; read by the main thread while it is written. 0 to 1.
using ExportProgress = std::atomic<double>;

/// Main thread only; `wake` is called from the writing thread.
class ExportQueue {
public:
    explicit ExportQueue(std::function<void()> wake) : wake_(std::move(wake)) {}
    /// Finishes what is queued: a snapshot that was asked for is written.
    ~ExportQueue();
    ExportQueue(const ExportQueue&) = delete;
    ExportQueue& operator=(const ExportQueue&) = delete;

    /// Writes `path` by `work`, which runs in the background and may touch only what it owns. `what` names the thing
    /// for the log ("EXR snapshot").
    void start(std::string what, std::filesystem::path path, std::function<Result<Done>(ExportProgress&)> work);

    /// Puts what has ended into the log: the path and how long it took, or the error.
    void report(Log& log);

    struct Running {
        std::string what;
        std::filesystem::path path;
        double progress = 0.0;
    };
    [[nodiscard]] std::vector<Running> running() const;
    [[nodiscard]] bool idle() const { return jobs_.empty(); }
    /// True while a queued export will write this path.
    [[nodiscard]] bool will_write(const std::filesystem::path& path) const;

private:
    struct Job {
        std::string what;
        std::filesystem::path path;
        std::function<Result<Done>(ExportProgress&)> work;
        ExportProgress progress{0.0};
        double seconds = 0.0;          // valid once `ended`
        std::optional<Error> error{};  // valid once `ended`
        std::atomic<bool> ended{false};
    };
    void write_all(const std::stop_token& stop);

    std::function<void()> wake_;
    std::deque<std::shared_ptr<Job>> jobs_;  // main thread: in the order of starting, until reported
    std::mutex mutex_;                       // guards queue_
    std::condition_variable_any added_;
    std::deque<std::shared_ptr<Job>> queue_;
    std::jthread writer_;  // started with the first job
};

}  // namespace pol
