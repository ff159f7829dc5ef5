// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/command_line.h"

namespace pol {

/// Adds `polariscope interface`: what one interface does to light, as a table; or many interfaces, JSON lines in and
/// out. When the command runs it sets `exit_code` to 0 or to the ErrorKind of what went wrong, which it has then said
/// on stderr. `exit_code` must outlive `app`.
void add_interface_command(ProgramCommand app, int& exit_code);

}  // namespace pol
