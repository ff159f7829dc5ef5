// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>

#include "scene/scene.h"

namespace pol {

/// What a picture of `scene` says about where it comes from: scene (name of its file), scene_hash, settings. `samples`
/// are those that its pixels got (StokesImage::samples), which may be other than were asked for, and not all the same:
/// "spp=4..512".
std::map<std::string, std::string> picture_attributes(const Scene& scene, std::span<const std::uint32_t> samples,
                                                      const std::filesystem::path& file);

}  // namespace pol
