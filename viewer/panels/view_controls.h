// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// How the map is shown: wavelength, colors, exposure, what is drawn over it. Requires: a document is shown.
void draw_view_controls(const Session& session, Wishes& wishes);

/// Ellipses over the picture.
void draw_glyph_controls(const ViewSettings& view, Wishes& wishes);

}  // namespace pol
