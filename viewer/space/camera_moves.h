// SPDX-License-Identifier: Apache-2.0
// How the mouse moves a scene's camera. Each returns the moved camera; `up`, projection and field of view stay.
#pragma once

#include <cmath>

#include "core/vec.h"
#include "scene/camera.h"
#include "viewer/space/space_view.h"

namespace pol {

/// Turns around the target, at the same distance, by `drag` in points, as the 3-D view does; stays a degree away from
/// looking along `up`. Requires: the camera is one that renders (position != target, up not along the view).
inline Camera orbited(Camera camera, const DVec2& drag) {
    constexpr double any_radius = 1.0;
    SpaceView view = SpaceView::around(camera.target, any_radius, camera.position, camera.up);
    view.orbit(drag);
    const double distance = glm::length(camera.position - camera.target);
    camera.position = camera.target + distance * unit(view.eye() - view.target());
    return camera;
}

/// Moves position and target across the view, so that what lies at the target's distance follows `drag`, in pixels of
/// a picture `picture_width` pixels wide. Requires: as orbited(), picture_width > 0.
inline Camera panned(Camera camera, const DVec2& drag, int picture_width) {
    const DVec3 to_target = camera.target - camera.position;
    const DVec3 right = unit(cross(to_target, camera.up));
    const DVec3 above = unit(cross(right, to_target));
    const double width = camera.projection == Projection::perspective
                             ? 2.0 * std::tan(0.5 * camera.horizontal_fov) * glm::length(to_target)
                             : camera.width;
    const DVec3 shift = (width / picture_width) * (-drag.x * right + drag.y * above);
    camera.position += shift;
    camera.target += shift;
    return camera;
}

/// Goes nearer to the target (factor > 1) or away from it. An orthographic camera, for which distance shows nothing,
/// takes a narrower or wider picture instead. Requires: factor > 0.
inline Camera dollied(Camera camera, double factor) {
    if (camera.projection == Projection::orthographic)
        camera.width /= factor;
    else
        camera.position = camera.target + (camera.position - camera.target) / factor;
    return camera;
}

}  // namespace pol
