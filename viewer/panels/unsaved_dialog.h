// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// Asks what to do with edits that no file has, before the program ends or a document is closed (Question).
void draw_unsaved_dialog(const Session& session, Wishes& wishes);

}  // namespace pol
