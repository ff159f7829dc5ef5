// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/command_line.h"

namespace pol {

/// `polariscope convert IN -o OUT --as FORM`: any picture that is read, in the form of another program.
void add_convert_command(ProgramCommand app, int& exit_code);

}  // namespace pol
