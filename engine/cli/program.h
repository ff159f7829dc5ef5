// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/command_line.h"

#include <span>

namespace pol {

/// Adds a subcommand that leaves its exit code in `exit_code` when it has run.
using AddCommand = void (*)(ProgramCommand app, int& exit_code);

/// The program: parses the command line, runs the subcommand, returns the exit code. `more` are commands from outside
/// the engine (the window).
int run_program(int argc, char** argv, std::span<const AddCommand> more);

}  // namespace pol
