// SPDX-License-Identifier: Apache-2.0
#include "cli/check_command.h"

#include <CLI/CLI.hpp>

namespace pol {

void add_check_command(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand("check", "Prove the physics of this program");
    command->require_subcommand(1);
    command->footer("Example:\n  polariscope check facts T9 T11");
    add_check_facts_command(*command, exit_code);
}

}  // namespace pol
