// SPDX-License-Identifier: Apache-2.0
// Moving the camera with the mouse.
#pragma once

#include "scene/camera.h"

namespace pol {

/// Turns about the target: by `right_rad` about the user's `up`, so that the camera goes to the right, and by `up_rad`
/// towards `up`, which it never reaches.
Camera orbited(const Camera& camera, double right_rad, double up_rad);

/// Moves camera and target by that share of the picture's width, measured at the target, to the right and up: what lies
/// at the target moves to the left and down.
Camera panned(const Camera& camera, double right, double up);

/// The target is seen `factor` times as near: the distance is divided by it, or the width of an orthographic picture.
/// Requires: factor > 0.
Camera dollied(const Camera& camera, double factor);

}  // namespace pol
