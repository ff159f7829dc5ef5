// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session.h"

namespace pol {

/// Keys and mouse on one sheet, made from commands(), while session.window.help_visible.
void draw_help_sheet(Session& session);

}  // namespace pol
