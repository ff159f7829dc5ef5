// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// An address to type that the picture on screen is sent to, while WindowState::send_visible.
class SendDialog {
public:
    void draw(const Session& session, Wishes& wishes);

private:
    std::string typed_;
    std::string complaint_;  // why nothing was sent
    bool wanted_ = false;    // in the last frame
};

}  // namespace pol
