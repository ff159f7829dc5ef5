// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/command_line.h"

namespace pol {

/// Adds `polariscope plan`: what a scene needs and what is left out.
void add_plan_command(ProgramCommand app, int& exit_code);

}  // namespace pol
