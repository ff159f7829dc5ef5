// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}

namespace pol {

/// Adds `polariscope plan`: what a scene needs and what is left out.
void add_plan_command(CLI::App& app, int& exit_code);

}  // namespace pol
