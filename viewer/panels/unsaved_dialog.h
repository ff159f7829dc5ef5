// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"

namespace pol {

/// Asks once what to do with edits that no file has, before the program ends (session.window.quit) or a document is
/// closed (session.window.close_asked). Without such edits the answer is known.
void draw_unsaved_dialog(Session& session);

}  // namespace pol
