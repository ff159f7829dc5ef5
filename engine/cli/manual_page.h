// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/command_tree.h"

namespace pol {

/// The manual page of the program, section 1, in man(7) macros.
std::string manual_page(const CommandEntry& program, const std::string& version);

}  // namespace pol
