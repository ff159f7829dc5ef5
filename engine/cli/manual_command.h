// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}

namespace pol {

/// Adds the command that prints the manual page and the completions of `app`, with all commands it has by then.
void add_manual_command(CLI::App& app);

}  // namespace pol
