// SPDX-License-Identifier: Apache-2.0
// What a test sees of the running window: its panels as text, where the widgets lie, how long frames took.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viewer/session/session.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

/// Writes panels.txt (ImGui's text log of one frame) and, last, window.json (widgets, transform, frame times) into a
/// folder. Main thread only.
class AppProbe {
public:
    explicit AppProbe(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// The next frame that leaves nothing to do is written: it shows what has become of all input.
    void ask() { asked_ = true; }
    [[nodiscard]] bool asked() const { return asked_; }

    /// Around a frame that may be written, between ImGui::NewFrame() and ImGui::Render().
    void begin();
    void end(const Session& session, const ViewRect& viewport, bool is_final);

    /// A frame was drawn; `latency_s` since the first input that it answers, 0 if there was none.
    void note_frame(double cost_s, double latency_s);

private:
    std::filesystem::path folder_;
    bool asked_ = false;
    WidgetMap widgets_;
    std::vector<double> costs_s_;      // of all frames since the last report
    std::vector<double> latencies_s_;  // of those that answer input
};

}  // namespace pol
