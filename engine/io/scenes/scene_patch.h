// SPDX-License-Identifier: Apache-2.0
// A changed scene in the words of the file that it was read from.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scene/scene.h"

namespace pol {

/// `source` with `edited` in it. Only values in which `edited` differs from `before`, the scene that was read from
/// `source`, are written anew: comments, units, the order of keys and all other numbers stay as they are. `from` and
/// `to` are the files that it was read from and that it is for: if their folders differ, files that it names beside
/// `from` are named as seen from `to`, files that ship with the program as before. The result reads back to
/// `edited`, title and scene hash.
///
/// Empty if that cannot be said in this text: what changed stands in an included file or behind an alias, or a comment
/// stands in the midst of it.
std::optional<std::string> patch_scene(const std::string& source, const Scene& before, const Scene& edited,
                                       const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace pol
