// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/command_line.h"

namespace pol {

void add_converge_command(ProgramCommand app, int& exit_code);

}  // namespace pol
