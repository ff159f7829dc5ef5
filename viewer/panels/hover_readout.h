// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"

namespace pol {

/// Height of draw_hover_readout() in points.
float hover_readout_height();

/// The pixel under the cursor, else the pinned one, in two lines: place, shown quantity with its bar, wavelength;
/// Stokes vector behind the polarimeter, what was not traced. Requires: a document is shown.
void draw_hover_readout(const Session& session);

}  // namespace pol
