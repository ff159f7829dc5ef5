// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// The fact that the current document shows: its sentence and source, and every reading with what is expected, what is
/// measured in the scene as it is now, and the verdict. Requires: the current document has a fact.
void draw_fact_panel(const Session& session, Wishes& wishes);

}  // namespace pol
