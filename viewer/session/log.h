// SPDX-License-Identifier: Apache-2.0
// What the window has to tell: shown in the status line and kept in the log panel.
#pragma once

#include <string>
#include <vector>

#include "viewer/shown/appearance.h"

namespace pol {

struct LogLine {
    Severity severity = Severity::note;
    std::string text;
};

/// Main thread only.
class Log {
public:
    void add(Severity severity, std::string text) {
        lines_.push_back({severity, std::move(text)});
        if (lines_.size() > longest) lines_.erase(lines_.begin());
    }
    [[nodiscard]] const std::vector<LogLine>& lines() const { return lines_; }

private:
    static constexpr std::size_t longest = 1000;
    std::vector<LogLine> lines_;
};

}  // namespace pol
