// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// All messages, while WindowState::log_visible; follows the newest.
class LogPanel {
public:
    void draw(const Session& session, Wishes& wishes);

private:
    std::size_t lines_seen_ = 0;
};

}  // namespace pol
