// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// Main menu, made from the table of commands, and the menu of facts. Returns its height in points.
float draw_menu_bar(const Session& session, Wishes& wishes);

}  // namespace pol
