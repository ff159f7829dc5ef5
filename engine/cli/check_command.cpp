// SPDX-License-Identifier: Apache-2.0
#include "cli/check_command.h"

#include <CLI/CLI.hpp>

namespace pol {

void add_check_command(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand("check", "Prove the physics and the numbers of this program");
    command->require_subcommand(1);
    command->footer("Example:\n  polariscope check facts T9 T11\n  polariscope check stiff -o stiff");
    add_check_facts_command(*command, exit_code);
    add_check_stiff_command(*command, exit_code);
}

}  // namespace pol
