// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"
#include "viewer/widgets/frame.h"

namespace pol {

/// Over the picture's upper edge: why the file cannot be shown as it is now. Nothing while all is well.
void draw_problem_banner(const Session& session, const Frame& frame);

}  // namespace pol
