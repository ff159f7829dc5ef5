// SPDX-License-Identifier: Apache-2.0
#include "viewer/camera_moves.h"

#include <algorithm>
#include <cmath>

#include "core/contract.h"
#include "core/units.h"

namespace pol {

namespace {

/// Least angle between the line of sight and `up`: nearer, the picture's up is not well defined.
constexpr double pole_rad = radians(1.0);

/// v turned by `angle` about the unit vector `axis` (Rodrigues).
DVec3 turned(const DVec3& v, const DVec3& axis, double angle) {
    return v * std::cos(angle) + cross(axis, v) * std::sin(angle) + axis * (dot(axis, v) * (1.0 - std::cos(angle)));
}

}  // namespace

Camera orbited(const Camera& camera, double right_rad, double up_rad) {
    const DVec3 up = unit(camera.up);
    const DVec3 away = camera.position - camera.target;
    const double from_up = std::acos(std::clamp(dot(unit(away), up), -1.0, 1.0));
    const double wanted = std::clamp(from_up - up_rad, pole_rad, pi - pole_rad);
    const DVec3 right = unit(cross(up, away));
    Camera moved = camera;
    moved.position = camera.target + turned(turned(away, right, wanted - from_up), up, right_rad);
    return moved;
}

Camera panned(const Camera& camera, double right, double up) {
    const DVec3 sight = camera.target - camera.position;
    const DVec3 forward = unit(sight);
    const DVec3 image_right = unit(cross(forward, unit(camera.up)));
    const DVec3 image_up = cross(image_right, forward);
    const double width = camera.projection == Projection::perspective
                             ? 2.0 * std::sqrt(length2(sight)) * std::tan(0.5 * camera.horizontal_fov)
                             : camera.width;
    const DVec3 shift = image_right * (right * width) + image_up * (up * width);
    Camera moved = camera;
    moved.position += shift;
    moved.target += shift;
    return moved;
}

Camera dollied(const Camera& camera, double factor) {
    POL_EXPECTS(factor > 0.0);
    Camera moved = camera;
    if (camera.projection == Projection::orthographic)
        moved.width /= factor;
    else
        moved.position = camera.target + (camera.position - camera.target) / factor;
    return moved;
}

}  // namespace pol
