// SPDX-License-Identifier: Apache-2.0
// What one frame of the interface needs from whoever shows it, and what it asks of it in return.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "core/vec.h"

namespace pol {

/// Rectangle in window coordinates (shown/view_transform.h), logical points.
struct ViewRect {
    DVec2 origin{0.0, 0.0};
    DVec2 size{0.0, 0.0};
};

struct Frame {
    /// Texture that shows the picture's viewport (an ImTextureID); 0 without GL: a plain rectangle is drawn instead.
    std::uintptr_t picture_texture = 0;
    /// The same for the reference beside it, or under the wipe.
    std::uintptr_t reference_texture = 0;
    double ui_scale = 1.0;  ///< of fonts and widgets on high-density screens
    /// Out: where the picture's viewport lies; the texture is rendered for this rectangle after the interface is built
    /// and before it is shown, so that both belong to the same frame.
    ViewRect viewport{};
    /// Out: where the reference lies, of the same size; empty: it is not shown. A wipe has both in one place.
    ViewRect reference_viewport{};
    /// Out: draw the next frame after so many seconds even if nothing happens. Panels that move something call again().
    double redraw_in = std::numeric_limits<double>::infinity();

    void again(double seconds) { redraw_in = std::min(redraw_in, seconds); }
};

}  // namespace pol
