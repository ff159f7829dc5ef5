// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/command_line.h"

namespace pol {

/// Adds `polariscope send`: a picture in, to a viewer that runs.
void add_send_command(ProgramCommand app, int& exit_code);

}  // namespace pol
