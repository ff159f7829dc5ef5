// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// A pixel to type, "x,y" in the whole picture, while WindowState::go_to_visible.
class GoToDialog {
public:
    void draw(const Session& session, Wishes& wishes);

private:
    std::string typed_;
    bool wished_ = false;    // in the last frame: to go there
    std::string complaint_;  // why that is no pixel
};

}  // namespace pol
