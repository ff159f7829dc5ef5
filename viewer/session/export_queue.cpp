// SPDX-License-Identifier: Apache-2.0
#include "viewer/session/export_queue.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>

namespace pol {

ExportQueue::~ExportQueue() {
    writer_.request_stop();
}

void ExportQueue::start(std::string what, std::filesystem::path path,
                        std::function<Result<Done>(ExportProgress&)> work) {
    auto job = std::make_shared<Job>();
    job->what = std::move(what);
    job->path = std::move(path);
    job->work = std::move(work);
    jobs_.push_back(job);
    {
        const std::scoped_lock lock(mutex_);
        queue_.push_back(std::move(job));
    }
    added_.notify_one();
    if (!writer_.joinable()) writer_ = std::jthread([this](const std::stop_token& stop) { write_all(stop); });
}

void ExportQueue::write_all(const std::stop_token& stop) {
    for (;;) {
        std::shared_ptr<Job> job;
        {
            std::unique_lock lock(mutex_);
            if (!added_.wait(lock, stop, [this] { return !queue_.empty(); })) return;
            job = std::move(queue_.front());
            queue_.pop_front();
        }
        const auto start = std::chrono::steady_clock::now();
        try {
            const Result<Done> written = job->work(job->progress);
            if (!written) job->error = written.error();
        } catch (const std::exception& exception) {  // a picture that does not fit into memory twice
            job->error = Error{ErrorKind::output, exception.what(), {job->path.string()}};
        }
        job->work = nullptr;  // frees the picture
        job->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        job->ended.store(true, std::memory_order_release);
        if (wake_) wake_();
    }
}

void ExportQueue::report(Log& log) {
    std::erase_if(jobs_, [&](const std::shared_ptr<Job>& job) {
        if (!job->ended.load(std::memory_order_acquire)) return false;
        if (job->error)
            log.add(Severity::error, fmt::format("{}: {}", job->what, to_string(*job->error)));
        else
            log.add(Severity::note,
                    fmt::format("{} written: {} ({:.1f} s)", job->what, job->path.string(), job->seconds));
        return true;
    });
}

std::vector<ExportQueue::Running> ExportQueue::running() const {
    std::vector<Running> list;
    for (const auto& job : jobs_) list.push_back({job->what, job->path, job->progress.load()});
    return list;
}

bool ExportQueue::will_write(const std::filesystem::path& path) const {
    return std::any_of(jobs_.begin(), jobs_.end(), [&](const auto& job) { return job->path == path; });
}

}  // namespace pol
