// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "viewer/panels/color_bar.h"
#include "viewer/panels/picture_overlay.h"
#include "viewer/session/session.h"
#include "viewer/session/wishes.h"
#include "viewer/shown/picture_place.h"
#include "viewer/widgets/frame.h"

namespace pol {

/// The picture with what is drawn over it, its color bar, the readout under the cursor, and the mouse in it: the wheel
/// zooms at the cursor, dragging pans, a click pins, Shift and dragging draws a region. With Alt, they move the camera
/// of a scene: dragging orbits, Shift and dragging pans it, the wheel dollies.
class PicturePanel {
public:
    void draw(const Session& session, Wishes& wishes, Frame& frame);

private:
    enum class Drag { none, pan, region, orbit_camera, pan_camera };
    [[nodiscard]] static Drag drag_meant(const Session& session);
    // They move `placed` as the user does.

    /// Pictures of one size are shown at the same place.
    void fit_if_new(const Session& session, PlacedPicture& placed);
    /// Of the item that was placed last; returns the pixel under the cursor.
    std::optional<PixelAddress> handle_mouse(const Session& session, Wishes& wishes, PlacedPicture& placed);
    void handle_wheel(const Session& session, Wishes& wishes, PlacedPicture& placed, const DVec2& at);
    void move_camera(const Session& session, Wishes& wishes, double points_per_pixel);

    std::optional<WholePicture> fitted_whole_;  // none: nothing is open
    DVec2 fitted_view_{0.0, 0.0};
    Drag drag_ = Drag::none;
    bool dollying_ = false;
    DVec2 drag_from_{0.0, 0.0};  // picture coordinates
    PictureOverlay overlay_;
    ColorBar color_bar_;
};

}  // namespace pol
