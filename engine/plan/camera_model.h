// SPDX-License-Identifier: Apache-2.0
// Camera rays and the frame in which a pixel's coherence matrix is written.
#pragma once

#include <cmath>

#include "core/vec.h"
#include "scene/camera.h"

namespace pol {

/// A backward ray and its polarization frame: x = unit(direction x image up), with image up perpendicular to the
/// camera's axis (not the user's `up`, about which frames would spin in a picture taken from above), and y such that
/// (x, y, -direction) is right-handed: image right and image up, seen by the receiver; the light travels along
/// -direction. Mitsuba 3's Stokes integrator has the same frame.
template <class Real>
struct CameraRayOf {
    Vec3<Real> origin{};
    Vec3<Real> direction{};
    Vec3<Real> x{};
    Vec3<Real> y{};
};
using CameraRay = CameraRayOf<double>;

/// Rays through a picture of width x height square pixels, row 0 at the top.
class CameraModel {
public:
    CameraModel() = default;

    /// Requires: position != target, up not parallel to the view direction, positive size (checked by scene/check).
    CameraModel(const Camera& camera, int width, int height)
        : projection_(camera.projection), origin_(camera.position) {
        forward_ = unit(camera.target - camera.position);
        right_ = unit(cross(forward_, unit(camera.up)));
        above_ = cross(right_, forward_);
        const double picture_width =
            projection_ == Projection::perspective ? 2.0 * std::tan(0.5 * camera.horizontal_fov) : camera.width;
        pixel_ = picture_width / static_cast<double>(width);
        center_x_ = 0.5 * static_cast<double>(width);
        center_y_ = 0.5 * static_cast<double>(height);
    }

    /// Ray through picture coordinates (x, y) in pixels from the top left corner; (0.5, 0.5) is the centre of the first
    /// pixel.
    template <class Real>
    [[nodiscard]] CameraRayOf<Real> ray(const Real& x, const Real& y) const {
        const Vec3<Real> above(above_);
        const Vec3<Real> offset = Vec3<Real>(right_) * ((x - Real(center_x_)) * Real(pixel_)) +
                                  above * ((Real(center_y_) - y) * Real(pixel_));
        CameraRayOf<Real> ray;
        if (projection_ == Projection::perspective) {
            ray.origin = Vec3<Real>(origin_);
            ray.direction = unit(Vec3<Real>(forward_) + offset);
        } else {
            ray.origin = Vec3<Real>(origin_) + offset;
            ray.direction = Vec3<Real>(forward_);
        }
        ray.x = unit(cross(ray.direction, above));
        ray.y = cross(ray.x, ray.direction);
        return ray;
    }

private:
    Projection projection_ = Projection::perspective;
    DVec3 origin_{};
    DVec3 forward_{};
    DVec3 right_{};
    DVec3 above_{};
    double pixel_ = 0.0;
    double center_x_ = 0.0;
    double center_y_ = 0.0;
};

}  // namespace pol
