// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "viewer/session/session.h"

namespace pol {

/// Finds a command by a part of its name, while session.window.palette_visible.
class CommandPalette {
public:
    void draw(Session& session);

private:
    std::string typed_;
    int chosen_ = 0;
};

}  // namespace pol
