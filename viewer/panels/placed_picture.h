// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/shown/view_transform.h"
#include "viewer/widgets/frame.h"

namespace pol {

/// Where the picture lies in the frame that is being drawn. The mouse may just have moved it: what is drawn over it
/// goes by this, not by Session::transform(), and lags behind by no frame.
struct PlacedPicture {
    ViewRect viewport;
    ViewTransform transform;

    [[nodiscard]] DVec2 window_from_picture(const DVec2& p) const {
        return viewport.origin + transform.view_from_picture(p);
    }
};

}  // namespace pol
