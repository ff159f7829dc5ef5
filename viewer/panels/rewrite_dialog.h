// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// Asks Question::rewrite: whether the file of the current document may be written anew.
void draw_rewrite_dialog(const Session& session, Wishes& wishes);

}  // namespace pol
