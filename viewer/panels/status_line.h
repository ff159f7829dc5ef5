// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"

namespace pol {

/// Progress, error figures, and the last message.
void draw_status_line(Session& session);

}  // namespace pol
