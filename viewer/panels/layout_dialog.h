// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// While Question::layout is asked: a picture can be read in several ways, and only the user knows which is right.
void draw_layout_dialog(const Session& session, Wishes& wishes);

}  // namespace pol
