// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/scene.h"

namespace pol {

/// 128-bit fingerprint of everything that the picture depends on, as 32 hexadecimal digits: all values of the scene,
/// the indices themselves (not the names of their records), the texels of textures and the triangles of meshes. Not the
/// title, nor file names, nor where in the file a thing stands. Equal on all machines. Not a defence against forgery.
std::string scene_hash(const Scene& scene);

}  // namespace pol
