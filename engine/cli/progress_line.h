// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <string>

namespace pol {

/// How far a render is: one line that is rewritten in place on a terminal, else a new line whenever a tenth
/// more is done, so that logs stay short. "progress 37.5%, 2 min 10 s left".
class ProgressLine {
public:
    /// On stderr where stdout is for results that other programs read.
    explicit ProgressLine(bool quiet, std::FILE* stream = stdout);

    /// `done` from 0 to 1 after `elapsed` seconds; the time left assumes that the rest is as hard as what is done.
    void show(double done, double elapsed);

    /// The same where the time left is known better; NaN: not known yet. `doing` is what is being done.
    void show(double done, double seconds_left, const std::string& doing);

    /// Frees the line for what follows: on a terminal it disappears.
    void finish();

private:
    std::FILE* stream_;
    bool quiet_;
    bool terminal_;
    double shown_ = -1.0;
};

}  // namespace pol
