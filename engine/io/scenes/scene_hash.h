// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/scene.h"

namespace pol {

/// 128-bit fingerprint of everything that the picture depends on: all values of the scene, the indices themselves (not
/// the names of their records), the texels of textures and the triangles of meshes. Not the title, nor file names, nor
/// where in the file a thing stands. A mark of how it was made, then 32 hexadecimal digits. Equal on all machines. Not
/// a defence against forgery.
std::string scene_hash(const Scene& scene);

/// False if `hash` was made in another way, by another version of this program: then it does not tell whether two
/// scenes are the same.
bool is_comparable_hash(const std::string& hash);

}  // namespace pol
