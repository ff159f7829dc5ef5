// SPDX-License-Identifier: Apache-2.0
// Scenes as YAML files. The format: assets/scenes/README.md.
#pragma once

#include <filesystem>
#include <string>

#include "core/result.h"
#include "scene/scene.h"

namespace pol {

/// Reads a scene with its includes, textures, meshes and index records, and checks it (scene/check.h). The result is
/// complete or an error of kind input with file, line, column, key path and hint. Paths in the result are absolute.
Result<Scene> load_scene(const std::filesystem::path& path);

/// The same for text in memory. `file_name` is what messages call it; files it names are looked for in `base_dir`, then
/// in the assets that ship with the program.
Result<Scene> parse_scene(const std::string& text, const std::string& file_name, const std::filesystem::path& base_dir);

/// The text of a scene file, for parse_scene(). Error (kind input): there is no such file, or it is no text to read.
Result<std::string> read_scene_text(const std::filesystem::path& path);

/// YAML that loads back to the same values, bit for bit. Transforms become one matrix, includes are gone, an index
/// record is named if reading it gives the same index, else written out.
std::string save_scene(const Scene& scene);

/// The same for a file in `folder` (absolute): its meshes and textures are named as seen from there, and what ships
/// with the program by its name in the assets, so that the file can go to another place together with them.
std::string save_scene(Scene scene, const std::filesystem::path& folder);

}  // namespace pol
