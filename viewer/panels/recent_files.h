// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// One line per file of Session::recent_files(), newest first; a click opens it. For a menu or a page.
void draw_recent_files(const Session& session, Wishes& wishes);

}  // namespace pol
