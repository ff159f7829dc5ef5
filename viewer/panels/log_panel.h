// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "viewer/session/session.h"

namespace pol {

/// All messages, while session.window.log_visible; follows the newest.
class LogPanel {
public:
    void draw(Session& session);

private:
    std::size_t lines_seen_ = 0;
};

}  // namespace pol
