// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "scene/scene.h"

namespace pol {

/// What a picture of `scene` with that many samples per pixel says about where it comes from: scene (name of its file),
/// scene_hash, settings.
std::map<std::string, std::string> picture_attributes(const Scene& scene, int samples_per_pixel,
                                                      const std::filesystem::path& file);

}  // namespace pol
