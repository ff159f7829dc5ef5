// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// Which map is shown, and how.
class MapsPanel {
public:
    void draw(const Session& session, Wishes& wishes);
};

}  // namespace pol
