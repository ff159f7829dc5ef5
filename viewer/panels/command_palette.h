// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// Finds a command by a part of its name, while WindowState::palette_visible.
class CommandPalette {
public:
    void draw(const Session& session, Wishes& wishes);

private:
    std::string typed_;
    int chosen_ = 0;
};

}  // namespace pol
