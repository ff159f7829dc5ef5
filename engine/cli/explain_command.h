// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/command_line.h"

namespace pol {

/// Adds `polariscope explain`: one pixel's coherence matrix and the backward tree that made it.
void add_explain_command(ProgramCommand app, int& exit_code);

}  // namespace pol
