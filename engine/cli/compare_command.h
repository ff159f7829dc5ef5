// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/command_line.h"

namespace pol {

/// Adds `polariscope compare`: two pictures of one view held against each other. When the command runs it sets
/// `exit_code`; `exit_code` must outlive `app`.
void add_compare_command(ProgramCommand app, int& exit_code);

}  // namespace pol
