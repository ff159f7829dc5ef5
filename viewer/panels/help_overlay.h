// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"

namespace pol {

/// Keys and mouse at a glance, made from commands(), while session.window.help_visible.
void draw_help_overlay(Session& session);

}  // namespace pol
