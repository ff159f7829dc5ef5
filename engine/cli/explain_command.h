// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}

namespace pol {

/// Adds `polariscope explain`: one pixel's coherence matrix and the backward tree that made it.
void add_explain_command(CLI::App& app, int& exit_code);

}  // namespace pol
