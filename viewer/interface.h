// SPDX-License-Identifier: Apache-2.0
// The whole window as a function of the session: menus, panels, layout. Needs ImGui only.
#pragma once

#include "viewer/frame.h"
#include "viewer/panels/maps_panel.h"
#include "viewer/panels/picture_panel.h"
#include "viewer/panels/pixel_panel.h"
#include "viewer/session.h"

namespace pol {

/// Layout: menu on top, status line at the bottom; maps, view and bench on the left; pixel, paths, scene on the right;
/// the picture between them. Keeps only what belongs to widgets (open tabs, filters), never the user's data.
class Interface {
public:
    /// Builds one frame between ImGui::NewFrame() and ImGui::Render().
    void draw(Session& session, Frame& frame);

private:
    MapsPanel maps_;
    PicturePanel picture_;
    PixelPanel pixel_;
};

}  // namespace pol
