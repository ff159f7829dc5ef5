// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// For panels that show the tree: says why there is none (yet), with a button to cancel or to start again. True if
/// there is one.
bool draw_tree_state(const Session& session, Wishes& wishes);

/// Which sample of the pixel is explained. Draws nothing if there is one only.
void draw_sample_choice(const Session& session, Wishes& wishes);

}  // namespace pol
