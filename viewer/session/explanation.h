// SPDX-License-Identifier: Apache-2.0
// The backward tree of the pinned pixel, found on a thread of its own while the window goes on.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "plan/plan.h"
#include "tracer/explain.h"
#include "viewer/shown/selection.h"

namespace pol {

/// Which tree: a sample of a pixel at one wavelength of a plan.
struct ExplanationRequest {
    std::shared_ptr<const Plan> plan;
    PixelAddress pixel{};
    std::uint32_t sample = 0;
    int wavelength = 0;  ///< index into Plan::wavelengths_nm
    friend bool operator==(const ExplanationRequest&, const ExplanationRequest&) = default;
};

/// True if both ask for the same branches, perhaps at another wavelength: an index into the nodes of one tree then
/// means the same branch in the other.
bool same_branches(const ExplanationRequest& a, const ExplanationRequest& b);

enum class ExplanationState : std::uint8_t {
    nothing_asked,
    running,
    ready,
    cancelled,  ///< by the user
    failed,     ///< ExplanationStatus::problem says why
};

struct ExplanationStatus {
    ExplanationState state = ExplanationState::nothing_asked;
    std::size_t branches = 0;  ///< found so far
    std::size_t budget = 0;    ///< branches that may be followed (each may open a few more) before the random tail
    std::string problem{};
};

/// Explains one pixel at a time; the newest request wins, and what older ones still bring is dropped.
///
/// Thread safety: one owner calls the members; `wake` is called from the worker.
class ExplanationJob {
public:
    /// Branches of the largest tree that is kept: some 400 MB.
    static constexpr std::size_t default_most_branches = 500'000;

    /// `wake` is called whenever an explanation is ready or has failed. Trees of more than `most_branches` are refused.
    explicit ExplanationJob(std::function<void()> wake = {}, std::size_t most_branches = default_most_branches);
    /// Cancels and joins.
    ~ExplanationJob() = default;
    ExplanationJob(const ExplanationJob&) = delete;
    ExplanationJob& operator=(const ExplanationJob&) = delete;

    /// Starts what is asked for unless it is the current request already; none: cancels and forgets.
    /// Requires: the pixel and the wavelength belong to the plan.
    void ask(const std::optional<ExplanationRequest>& request);
    /// Gives up the running request; ask() with the same request does not start it again.
    void cancel();
    /// Starts the current request once more.
    void restart();

    [[nodiscard]] const std::optional<ExplanationRequest>& request() const { return request_; }
    /// The answer to the current request, or null.
    [[nodiscard]] std::shared_ptr<const Explanation> result() const;
    [[nodiscard]] ExplanationStatus status() const;

private:
    void start();
    void work(const std::stop_token& shutdown);

    std::function<void()> wake_;
    std::size_t most_branches_;
    std::optional<ExplanationRequest> request_;  // of the owner's thread alone
    std::atomic<std::uint64_t> newest_ = 0;      // number of the newest request; older ones give up
    std::atomic<std::size_t> branches_ = 0;
    mutable std::mutex mutex_;  // guards the members below
    std::condition_variable_any changed_;
    std::optional<ExplanationRequest> waiting_;
    ExplanationState state_ = ExplanationState::nothing_asked;
    std::shared_ptr<const Explanation> result_;
    std::string problem_;
    std::jthread worker_;  // last: ends before what it uses
};

}  // namespace pol
