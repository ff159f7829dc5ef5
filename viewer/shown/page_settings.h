// SPDX-License-Identifier: Apache-2.0
// How the inspector writes the light of a pixel.
#pragma once

#include <cstdint>

namespace pol {

/// What x is in the frame that the light is written in; y is across it and k along the light.
enum class FrameChoice : std::uint8_t { camera, scene_x, scene_y, scene_z, own_angle };

struct PageSettings {
    FrameChoice frame = FrameChoice::camera;
    double own_angle = 0.0;  ///< radians from the camera's x towards its y, as the receiver sees it
    friend bool operator==(const PageSettings&, const PageSettings&) = default;
};

}  // namespace pol
