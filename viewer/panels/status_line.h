// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// Progress, error figures, and the last message.
void draw_status_line(const Session& session, Wishes& wishes);

}  // namespace pol
