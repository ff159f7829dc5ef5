// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"

namespace pol {

/// The polarimeter: the train of polarizers and retarders in front of the sensor, in the order in which the light
/// meets them.
void draw_polarimeter_panel(Session& session);

}  // namespace pol
