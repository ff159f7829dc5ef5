// SPDX-License-Identifier: Apache-2.0
// When to draw the next frame: at once for the user, seldom for tiles that arrive, not at all when nothing changes.
#pragma once

#include <algorithm>
#include <optional>

namespace pol {

/// Times are seconds of one steady clock. The swap interval is no brake on software rasterizers, so this is.
class FramePacer {
public:
    static constexpr double shortest_frame = 1.0 / 60.0;
    /// After input, widgets need two more frames to settle (a tooltip's size, a popup's place).
    static constexpr int frames_per_input = 3;
    /// Share of the time that drawing may take while only tiles arrive: the rest is the tracer's.
    static constexpr double idle_share = 0.04;
    /// For so long after input tiles count as its answer, and drawing may take this share.
    static constexpr double answer_time = 0.5;
    static constexpr double answer_share = 0.33;

    /// The user did something, or the window has to be painted again.
    void input(double now) {
        owed_ = frames_per_input;
        last_input_ = now;
    }
    /// There is something new to show.
    void news() { news_ = true; }
    /// While nothing is being traced, nobody needs the time that drawing leaves.
    void set_tracing(bool tracing) { tracing_ = tracing; }
    /// Something on screen moves: draw again after `seconds`.
    void animate(double now, double seconds) { animation_ = now + seconds; }

    /// Seconds until the next frame is due, 0 if it is now; nothing: no frame is needed.
    [[nodiscard]] std::optional<double> wait(double now) const {
        std::optional<double> due;
        const auto at = [&due](double time) { due = due ? std::min(*due, time) : time; };
        if (owed_ > 0) at(last_start_ + shortest_frame);
        if (animation_) at(std::max(*animation_, last_start_ + shortest_frame));
        if (news_) {
            const double share = now - last_input_ < answer_time ? answer_share : idle_share;
            at(last_start_ + (tracing_ ? std::max(shortest_frame, cost_ / share) : shortest_frame));
        }
        if (!due) return std::nullopt;
        return std::max(0.0, *due - now);
    }

    /// A frame was drawn from `start` to `end`.
    void drawn(double start, double end) {
        constexpr double smoothing = 0.2;
        cost_ += (cost_ == 0.0 ? 1.0 : smoothing) * (end - start - cost_);
        last_start_ = start;
        owed_ = std::max(0, owed_ - 1);
        news_ = false;
        animation_.reset();
    }

private:
    int owed_ = frames_per_input;
    bool news_ = false;
    bool tracing_ = false;
    std::optional<double> animation_;
    double last_input_ = 0.0;
    double last_start_ = -1.0;
    double cost_ = 0.0;  // of a frame, smoothed
};

}  // namespace pol
