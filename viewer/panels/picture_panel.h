// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/frame.h"
#include "viewer/session.h"

namespace pol {

/// The picture with what is drawn over it, and the mouse in it.
class PicturePanel {
public:
    void draw(Session& session, Frame& frame);

private:
    std::uint64_t fitted_layout_ = 0;
};

}  // namespace pol
