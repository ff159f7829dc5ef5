// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "viewer/panels/glyph_overlay.h"
#include "viewer/panels/placed_picture.h"
#include "viewer/session/session.h"
#include "viewer/shown/view_transform.h"

namespace pol {

/// What is drawn over the picture: a veil over pixels that are not marked, ellipses, numbers in pixels, the region,
/// pins, and the frame of the pinned pixel.
class PictureOverlay {
public:
    /// Requires: a document is shown.
    void draw(const Session& session, const PlacedPicture& placed);

private:
    /// Points from `x0` to `x1` of one row of cells, in view coordinates.
    struct VeilRun {
        float x0;
        float x1;
        float y;
    };
    void draw_veil(const Session& session, const PlacedPicture& placed);

    GlyphOverlay glyphs_;
    std::vector<VeilRun> veil_;  // of the marks, transform and viewport below
    float veil_cell_ = 1.0F;
    std::uint64_t veil_marks_ = 0;
    ViewTransform veil_transform_;
    DVec2 veil_view_{0.0, 0.0};
};

}  // namespace pol
