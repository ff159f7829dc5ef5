// SPDX-License-Identifier: Apache-2.0
// Three coordinate systems, named in every function:
//   picture  pixels of the picture, (0, 0) the top left corner of the top left pixel, y down; pixel (x, y) covers
//            [x, x + 1) x [y, y + 1)
//   view     logical points of the picture's viewport in the window, (0, 0) its top left corner, y down
//   window   logical points of the window; view + the viewport's origin
#pragma once

#include <algorithm>
#include <cmath>

#include "core/vec.h"

namespace pol {

/// Zoom and pan of the picture. `scale` is in points per pixel.
struct ViewTransform {
    double scale = 1.0;
    DVec2 offset{0.0, 0.0};  ///< view coordinates of the picture's top left corner
    bool fitted = false;     ///< fit() was the last word: to be fitted again when the view changes its size

    static constexpr double min_scale = 1.0 / 64.0;
    static constexpr double max_scale = 256.0;

    friend bool operator==(const ViewTransform&, const ViewTransform&) = default;

    [[nodiscard]] DVec2 view_from_picture(const DVec2& p) const { return offset + scale * p; }
    [[nodiscard]] DVec2 picture_from_view(const DVec2& v) const { return (v - offset) / scale; }

    /// Zooms by `factor`; the picture point under `anchor` (view coordinates) stays there.
    void zoom_at(const DVec2& anchor, double factor) {
        const DVec2 fixed = picture_from_view(anchor);
        scale = std::clamp(scale * factor, min_scale, max_scale);
        offset = anchor - scale * fixed;
        fitted = false;
    }

    /// Moves the picture by `by` (points).
    void pan(const DVec2& by) {
        offset += by;
        fitted = false;
    }

    /// The whole picture, centred, as large as `view` allows.
    void fit(const DVec2& picture, const DVec2& view) {
        scale = std::clamp(std::min(view.x / picture.x, view.y / picture.y), min_scale, max_scale);
        center(picture, view);
        fitted = true;
    }

    void center(const DVec2& picture, const DVec2& view) {
        offset = {std::floor(0.5 * (view.x - scale * picture.x)), std::floor(0.5 * (view.y - scale * picture.y))};
        fitted = false;
    }
};

}  // namespace pol
