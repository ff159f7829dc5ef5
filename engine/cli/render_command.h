// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/command_line.h"

namespace pol {

/// Adds `polariscope render`: a scene in, a Stokes EXR out.
void add_render_command(ProgramCommand app, int& exit_code);

}  // namespace pol
