// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "viewer/widgets/theme.h"

namespace pol {

/// A path as people type it: "~/" is the home folder, as in a shell.
std::filesystem::path typed_path(const std::string& typed);

/// A line over the window with a line for a path and a button; true while it is open. `focus` gives the line the
/// keyboard. `wanted` becomes true by Enter or the button, which says `button`. After true: end_path_page().
bool begin_path_page(const char* title, bool& visible, std::string& typed, const char* hint, const char* button,
                     bool focus, bool& wanted);
/// `complaint` in its color, if there is one; closes by Esc or if `visible` says so.
void end_path_page(bool& visible, const std::string& complaint, const ImVec4& color);

}  // namespace pol
