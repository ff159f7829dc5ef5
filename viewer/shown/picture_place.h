// SPDX-License-Identifier: Apache-2.0
// A picture may be a part of a larger one, and is shown where it lies in it: the zoom and pan of the window are those
// of the whole picture, so that pictures of one size lie over each other.
#pragma once

#include <algorithm>

#include "core/vec.h"
#include "film/stokes_image.h"
#include "viewer/shown/selection.h"
#include "viewer/shown/view_transform.h"

namespace pol {

/// Where the pixels that a picture has begin, in pixels of the whole one.
inline PixelAddress corner_of(const StokesImage& picture) {
    return {picture.left, picture.top};
}

/// Whether the picture has a pixel, counted from its own corner.
inline bool has_pixel(const StokesImage& picture, const PixelAddress& pixel) {
    return pixel.x >= 0 && pixel.y >= 0 && pixel.x < picture.width && pixel.y < picture.height;
}

/// A rectangle in pixels of the whole picture.
struct WholePicture {
    DVec2 low{0.0, 0.0};
    DVec2 size{0.0, 0.0};
    friend bool operator==(const WholePicture&, const WholePicture&) = default;
};

/// What is to be seen when all is: the whole picture, and whatever lies outside it (overscan).
inline WholePicture whole_of(const StokesImage& picture) {
    const DVec2 low(picture.left, picture.top);
    const DVec2 high = low + DVec2(picture.width, picture.height);
    if (picture.whole_width == 0 || picture.whole_height == 0) return {low, high - low};
    const DVec2 first = glm::min(low, DVec2(0.0));
    return {first, glm::max(high, DVec2(picture.whole_width, picture.whole_height)) - first};
}

/// Zoom and pan of a part of the picture whose corner lies at `corner`, if those of the whole are `whole`.
inline ViewTransform of_part(ViewTransform whole, const PixelAddress& corner) {
    whole.offset += whole.scale * DVec2(corner.x, corner.y);
    return whole;
}

/// The pixels of the whole picture of which anything lies in a viewport of that size.
inline TileRect pixels_in(const ViewTransform& whole, const DVec2& view) {
    constexpr double largest = 1e9;
    const DVec2 low = glm::clamp(glm::floor(whole.picture_from_view({0.0, 0.0})), -largest, largest);
    const DVec2 high = glm::clamp(glm::ceil(whole.picture_from_view(view)), -largest, largest);
    return {static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(high.x), static_cast<int>(high.y)};
}

/// The other way round.
inline ViewTransform of_whole(ViewTransform part, const PixelAddress& corner) {
    part.offset -= part.scale * DVec2(corner.x, corner.y);
    return part;
}

/// As ViewTransform::fit and center, of all that whole_of() has.
inline void fit(ViewTransform& transform, const WholePicture& whole, const DVec2& view) {
    transform.fit(whole.size, view);
    transform.offset -= transform.scale * whole.low;
}
inline void center(ViewTransform& transform, const WholePicture& whole, const DVec2& view) {
    transform.center(whole.size, view);
    transform.offset -= transform.scale * whole.low;
}

}  // namespace pol
