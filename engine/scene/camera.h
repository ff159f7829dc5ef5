// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/source_place.h"
#include "core/vec.h"

namespace pol {

enum class Projection { perspective, orthographic };

/// Where the picture is taken from. World space, scene units.
struct Camera {
    Projection projection = Projection::perspective;
    DVec3 position{0.0, 0.0, 0.0};
    DVec3 target{0.0, 0.0, -1.0};
    DVec3 up{0.0, 1.0, 0.0};
    double horizontal_fov = 0.0;  ///< radians, perspective only
    double width = 0.0;           ///< width of the picture in scene units, orthographic only
    SourcePlace place{};
};

}  // namespace pol
