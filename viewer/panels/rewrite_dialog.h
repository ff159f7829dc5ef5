// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"

namespace pol {

/// Asks, while session.window.rewrite_asked, whether the file of the current document may be written anew: it cannot
/// take an edit as it is (Document::save).
void draw_rewrite_dialog(Session& session);

}  // namespace pol
