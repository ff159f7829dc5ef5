// SPDX-License-Identifier: Apache-2.0
// The parts that a scene file is read by; for scene_file.cpp only. All throw YamlComplaint.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>

#include "io/files/yaml_value.h"
#include "scene/medium.h"
#include "scene/scene.h"

namespace pol {

/// Where the files that a scene names are looked for.
struct AssetFolders {
    std::filesystem::path scene;   ///< of the scene file
    std::filesystem::path assets;  ///< of the program
};

/// Absolute path of the file that `value` names: beside the scene, in assets/`kind`, or in assets. With `ends`, the
/// value is what files are called before one of these; so is the path.
std::filesystem::path find_asset(const YamlValue& value, const AssetFolders& folders, const std::string& kind,
                                 std::initializer_list<const char*> ends = {""});

/// Passes on what is wrong with a file that `value` names: at the line in that file if it has lines, else at `value`.
[[noreturn]] void fail_because_of(const YamlValue& value, Error error);

Spectrum read_spectrum(const YamlValue& value);
RefractiveIndex read_index(const YamlValue& value, const AssetFolders& folders);
Medium read_medium(const std::string& name, const YamlValue& value, const AssetFolders& folders);
/// A shape, and the step that comes before those of its object's transform: which axis of a mesh file is up.
struct UprightShape {
    Shape shape;
    DMat4 upright{1.0};
};
UprightShape read_shape(const YamlValue& value, const AssetFolders& folders);
/// The steps of `value` after `to_world`.
DMat4 read_transform(const YamlValue& value, DMat4 to_world);
Emission read_emission(const YamlValue& value, const AssetFolders& folders);
Object read_object(const YamlValue& value, const AssetFolders& folders);

}  // namespace pol
