// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}

namespace pol {

/// Adds `polariscope render`: a scene in, a Stokes EXR out.
void add_render_command(CLI::App& app, int& exit_code);

}  // namespace pol
