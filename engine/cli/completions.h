// SPDX-License-Identifier: Apache-2.0
// What completes commands, options and values where the user types them. Scenes that ship with the program are offered
// where no file here fits.
#pragma once

#include <string>

#include "cli/command_tree.h"

namespace pol {

/// For bash; needs nothing but bash.
std::string bash_completion(const CommandEntry& program);

/// For zsh, as the file _polariscope of a folder of fpath.
std::string zsh_completion(const CommandEntry& program);

}  // namespace pol
