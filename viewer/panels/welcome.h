// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// What stands in place of the picture while nothing is open: how to open something, and the scenes that are shipped.
void draw_welcome(const Session& session, Wishes& wishes);

}  // namespace pol
