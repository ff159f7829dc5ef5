// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// The pinned pixel in numbers: coherence matrix with its frame, Stokes vector, measures with error bars, the ellipse,
/// curves over wavelength. Every number can be copied.
class PixelPanel {
public:
    void draw(const Session& session, Wishes& wishes);
};

}  // namespace pol
