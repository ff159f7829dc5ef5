// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/command_line.h"

namespace pol {

/// Adds `polariscope check`: invariants of a scene, the sanity of a picture, or what its subcommands check. When the
/// command runs it sets `exit_code`; `exit_code` must outlive `app`.
void add_check_command(ProgramCommand app, int& exit_code);

/// Adds `facts` to the command `check`.
void add_check_facts_command(ProgramCommand check, int& exit_code);

/// Adds `stiff` to the command `check`: error and condition of every degenerate case, as a table, JSON, plots and a
/// page.
void add_check_stiff_command(ProgramCommand check, int& exit_code);

/// Adds `all` to the command `check`: everything, as one page.
void add_check_all_command(ProgramCommand check, int& exit_code);

}  // namespace pol
