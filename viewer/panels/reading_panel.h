// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"
#include "viewer/widgets/frame.h"

namespace pol {

/// Over the picture, while pictures are being read: which, how far, how long it takes yet, and a button to stop it.
void draw_reading_panel(const Session& session, Wishes& wishes, Frame& frame);

/// "Opening room.exr, 1920 x 1080, 21 bands: 43 %, 3 s left".
std::string reading_text(const PictureReading& reading);

}  // namespace pol
