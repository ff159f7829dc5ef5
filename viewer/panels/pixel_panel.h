// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session.h"

namespace pol {

/// The pinned pixel in numbers.
class PixelPanel {
public:
    void draw(Session& session);
};

}  // namespace pol
