// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"

namespace pol {

/// Which map is shown, and how.
class MapsPanel {
public:
    void draw(Session& session);
};

}  // namespace pol
