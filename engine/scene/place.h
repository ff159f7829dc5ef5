// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "core/result.h"
#include "core/source_place.h"
#include "scene/scene.h"

namespace pol {

/// Where in the user's files `place` is, for messages; all unknown if the thing was made by a program.
inline Place place_in(const Scene& scene, const SourcePlace& place) {
    const auto index = static_cast<std::size_t>(place.file);
    if (place.line <= 0 || place.file < 0 || index >= scene.files.size()) return {};
    return {scene.files[index], place.line, place.column};
}

}  // namespace pol
