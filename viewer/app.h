// SPDX-License-Identifier: Apache-2.0
// The window itself: GLFW, OpenGL, the ImGui backends, the event loop. Everything else is in Session and Interface.
#pragma once

#include <filesystem>
#include <vector>

#include "core/result.h"

namespace pol {

/// Opens the window with these files and runs until the user or SIGTERM ends it. Error (kind usage): there is no
/// display, or no OpenGL 3.3.
Result<Done> run_app(const std::vector<std::filesystem::path>& files);

}  // namespace pol
