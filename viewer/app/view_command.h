// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}

namespace pol {

void add_view_command(CLI::App& app, int& exit_code);

}  // namespace pol
