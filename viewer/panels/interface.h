// SPDX-License-Identifier: Apache-2.0
// The whole window as a function of the session: menus, panels, layout. Needs ImGui only.
#pragma once

#include <optional>

#include "viewer/panels/command_palette.h"
#include "viewer/panels/doctor_panel.h"
#include "viewer/panels/go_to_dialog.h"
#include "viewer/panels/histogram_panel.h"
#include "viewer/panels/log_panel.h"
#include "viewer/panels/maps_panel.h"
#include "viewer/panels/open_dialog.h"
#include "viewer/panels/paths_panel.h"
#include "viewer/panels/picture_panel.h"
#include "viewer/panels/pictures_panel.h"
#include "viewer/panels/pixel_panel.h"
#include "viewer/panels/ray_table_panel.h"
#include "viewer/panels/region_panel.h"
#include "viewer/panels/save_as_dialog.h"
#include "viewer/panels/scene_panel.h"
#include "viewer/panels/send_dialog.h"
#include "viewer/panels/space_panel.h"
#include "viewer/panels/sphere_panel.h"
#include "viewer/session/session.h"
#include "viewer/session/wishes.h"
#include "viewer/widgets/frame.h"

namespace pol {

/// Layout: menu on top, status line at the bottom; how the picture is shown on the left; what is known about a pixel on
/// the right, in one stack of tabs, or in two where the window is large; the picture between them. Keeps only what
/// belongs to widgets (open tabs, filters), never the user's data.
class Interface {
public:
    /// Builds one frame between ImGui::NewFrame() and ImGui::Render(). Returns what the user wants; it is to be done
    /// before the picture is rendered for this frame, and asks for one more frame, which shows it.
    [[nodiscard]] Wishes draw(const Session& session, Frame& frame);

private:
    /// Stacks of tabs on the right.
    enum class Stack : std::uint8_t { all, upper, lower };

    /// Each keeps the tree that it showed last, which may be large: they start anew when a document is closed.
    struct TreePanels {
        PathsPanel paths;
        RayTablePanel rays;
        SpacePanel space;
    };

    void draw_left(const Session& session, Wishes& wishes);
    void draw_tabs(const Session& session, Wishes& wishes, Stack stack);
    void draw_overlays(const Session& session, Wishes& wishes);

    PicturesPanel pictures_;
    RegionPanel region_;
    DoctorPanel doctor_;
    MapsPanel maps_;
    HistogramPanel histogram_;
    PicturePanel picture_;
    PixelPanel pixel_;
    std::optional<TreePanels> of_tree_{std::in_place};
    std::size_t documents_ = 0;       // that were open in the last frame
    std::uint64_t copies_ = 0;        // that are in the clipboard
    std::uint64_t facts_opened_ = 0;  // whose pages were brought to the front
    SpherePanel sphere_;
    ScenePanel scene_;
    LogPanel log_;
    CommandPalette palette_;
    OpenDialog open_dialog_;
    SaveAsDialog save_as_dialog_;
    GoToDialog go_to_dialog_;
    SendDialog send_dialog_;
    std::optional<Theme> theme_;  // that the style was made for, with theme_scale_
    double theme_scale_ = 0.0;
};

}  // namespace pol
