// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// The polarimeter: the train of polarizers and retarders in front of the sensor, in the order in which the light
/// meets them.
void draw_polarimeter_panel(const Session& session, Wishes& wishes);

}  // namespace pol
