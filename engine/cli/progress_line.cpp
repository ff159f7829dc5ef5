// SPDX-License-Identifier: Apache-2.0
#include "cli/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "report/number_words.h"

namespace pol {

namespace {

constexpr const char* erase_line = "\r\033[K";

/// Below a second the rest is done before it is read.
std::string time_left(double done, double seconds) {
    if (done <= 0.0 || done >= 1.0 || std::isnan(seconds)) return {};
    return fmt::format(", {} left", seconds < 1.0 ? "less than 1 s" : duration_text(seconds));
}

}  // namespace

ProgressLine::ProgressLine(bool quiet, std::FILE* stream)
    : stream_(stream), quiet_(quiet), terminal_(isatty(fileno(stream)) == 1) {}

void ProgressLine::show(double done, double elapsed) {
    show(done, elapsed / done - elapsed, {});
}

void ProgressLine::show(double done, double seconds_left, const std::string& doing) {
    if (quiet_ || (!terminal_ && done < shown_ + 0.1)) return;
    shown_ = done;
    const std::string line =
        fmt::format("{}progress {:.1f}%{}{}{}{}", terminal_ ? erase_line : "", 100.0 * done,
                    time_left(done, seconds_left), doing.empty() ? "" : ": ", doing, terminal_ ? "" : "\n");
    // Where this fails, on a full disk, the work goes on; run_program sees it at the end.
    static_cast<void>(std::fputs(line.c_str(), stream_));
    static_cast<void>(std::fflush(stream_));
}

void ProgressLine::finish() {
    if (!quiet_ && terminal_) static_cast<void>(std::fputs(erase_line, stream_));
}

}  // namespace pol
