// SPDX-License-Identifier: Apache-2.0
#include "viewer/session/explanation.h"

#include <new>

namespace pol {

bool same_branches(const ExplanationRequest& a, const ExplanationRequest& b) {
    const auto group = [](const ExplanationRequest& request) {
        return request.plan->group_of_wavelength[static_cast<std::size_t>(request.wavelength)];
    };
    return a.plan == b.plan && a.pixel == b.pixel && a.sample == b.sample && group(a) == group(b);
}

ExplanationJob::ExplanationJob(std::function<void()> wake, std::size_t most_branches)
    : wake_(std::move(wake)),
      most_branches_(most_branches),
      worker_([this](const std::stop_token& shutdown) { work(shutdown); }) {}

void ExplanationJob::ask(const std::optional<ExplanationRequest>& request) {
    if (request == request_) return;
    request_ = request;
    start();
}

void ExplanationJob::restart() {
    start();
}

void ExplanationJob::start() {
    {
        const std::lock_guard lock(mutex_);
        ++newest_;
        branches_ = 0;
        waiting_ = request_;
        state_ = request_ ? ExplanationState::running : ExplanationState::nothing_asked;
        result_.reset();
        problem_.clear();
    }
    changed_.notify_one();
}

void ExplanationJob::cancel() {
    const std::lock_guard lock(mutex_);
    if (state_ != ExplanationState::running) return;
    ++newest_;
    waiting_.reset();
    state_ = ExplanationState::cancelled;
}

std::shared_ptr<const Explanation> ExplanationJob::result() const {
    const std::lock_guard lock(mutex_);
    return result_;
}

ExplanationStatus ExplanationJob::status() const {
    const std::lock_guard lock(mutex_);
    ExplanationStatus status{state_, branches_, 0, problem_};
    if (request_) status.budget = static_cast<std::size_t>(request_->plan->settings.node_budget.value());
    return status;
}

void ExplanationJob::work(const std::stop_token& shutdown) {
    for (;;) {
        ExplanationRequest request;
        std::uint64_t number = 0;
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, shutdown, [this] { return waiting_.has_value(); })) return;
            request = *std::exchange(waiting_, std::nullopt);
            number = newest_;
        }
        std::shared_ptr<const Explanation> result;
        std::string problem;
        const auto keep_going = [&](std::size_t branches) {
            if (newest_ != number || shutdown.stop_requested()) return false;
            branches_ = branches;
            return branches <= most_branches_;
        };
        try {
            auto found = explain(*request.plan, request.pixel.x, request.pixel.y, request.sample, request.wavelength,
                                 keep_going);
            if (found)
                result = std::make_shared<const Explanation>(std::move(*found));
            else
                problem = "The tree has more than " + std::to_string(most_branches_) +
                          " branches: allow a larger residual or a smaller node budget";
        } catch (const std::bad_alloc&) {
            problem = "The tree does not fit into memory: allow a larger residual or a smaller node budget";
        }
        {
            const std::lock_guard lock(mutex_);
            if (newest_ != number || shutdown.stop_requested()) continue;
            state_ = result ? ExplanationState::ready : ExplanationState::failed;
            if (result) branches_ = result->tree.nodes.size();
            result_ = std::move(result);
            problem_ = std::move(problem);
        }
        if (wake_) wake_();
    }
}

}  // namespace pol
