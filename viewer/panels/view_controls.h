// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"

namespace pol {

/// How the map is shown: wavelength, colors, exposure, what is drawn over it. Requires: a document is shown.
void draw_view_controls(Session& session);

/// Ellipses over the picture.
void draw_glyph_controls(ViewSettings& view);

}  // namespace pol
