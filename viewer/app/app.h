// SPDX-License-Identifier: Apache-2.0
// The window itself: GLFW, OpenGL, the ImGui backends, the event loop. Everything else is in Session and Interface.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "cli/picture_options.h"
#include "core/result.h"
#include "io/live/live_address.h"
#include "io/live/live_events.h"
#include "viewer/session/window_state.h"

namespace pol {

/// A scene or a picture, as the command line names it.
struct FileToOpen {
    PictureSource source;    ///< of a scene: its path alone
    bool is_picture = true;  ///< whatever its ending
    ConventionOptions from;  ///< what the numbers of a picture are to be taken for
};

struct AppOptions {
    int width = 1280;
    int height = 800;
    std::optional<Theme> theme;
    std::optional<double> ui_scale;     ///< instead of the screen's
    std::optional<LiveAddress> listen;  ///< for pictures of other programs; empty: off
    LiveRules live_rules;
    /// Where to write what the window shows at every SIGUSR1 (app_probe.h); empty: nowhere.
    std::filesystem::path probe;
};

/// Opens the window with these files and runs until the user, SIGTERM or SIGINT ends it. What cannot be opened is said
/// on stderr. Error (kind usage): there is no display, or no OpenGL 3.3; (kind input): files were named, and none of
/// them can be opened.
Result<Done> run_app(const std::vector<FileToOpen>& files, const AppOptions& options);

}  // namespace pol
