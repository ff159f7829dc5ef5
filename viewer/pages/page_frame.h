// SPDX-License-Identifier: Apache-2.0
// The frame in which the page of a pixel writes its light.
#pragma once

#include <optional>
#include <string>

#include "film/band.h"
#include "viewer/session/session.h"

namespace pol {

/// Axes of the pixel's centre in the scene, or none for a picture without one.
std::optional<CameraRay> camera_axes(const Document& document, PixelAddress pixel);

/// Angle from the camera's x to the x asked for, radians; 0, and the reason in `trouble`, if there is none.
double frame_angle(const PageSettings& settings, const std::optional<CameraRay>& axes, std::string& trouble);

/// The angle of the frame on screen; 0 where there is no such frame. Requires: a pixel is pinned.
double shown_angle(const Session& session);

/// Those that are known in a frame turned by `angle`, which mixes S1 and S2.
StokesComponents known_in_frame(StokesComponents known, double angle);

}  // namespace pol
