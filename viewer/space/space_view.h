// SPDX-License-Identifier: Apache-2.0
// The eye that looks at the scene in the 3-D view: turned around a point, without OpenGL.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/units.h"
#include "core/vec.h"

namespace pol {

struct SpaceLine {
    DVec3 a{};
    DVec3 b{};
};

/// A point of the 3-D view: view coordinates in logical points from the panel's top left corner, y down.
struct SpacePoint {
    DVec2 at{};
    double depth = 0.0;  ///< distance in front of the eye, scene units
};

/// Perspective view from `distance` before `target`. Angles in radians; `pitch` 0 looks along the horizon of `up`.
class SpaceView {
public:
    /// The eye that sees a ball of `radius` about `center` whole, from the side of `eye`, with `up` upwards.
    /// Requires: radius > 0; `eye` differs from `center`, `up` is not zero.
    static SpaceView around(const DVec3& center, double radius, const DVec3& eye, const DVec3& up) {
        SpaceView view;
        view.target_ = center;
        view.distance_ = 1.05 * radius / std::sin(half_angle);
        view.up_ = unit(up);
        view.zero_ = any_perpendicular(view.up_);
        const DVec3 out = unit(eye - center);
        view.pitch_ = std::asin(std::clamp(dot(out, view.up_), -1.0, 1.0));
        view.yaw_ = std::atan2(dot(out, cross(view.up_, view.zero_)), dot(out, view.zero_));
        view.pitch_ = std::clamp(view.pitch_, -most_pitch, most_pitch);
        return view;
    }

    /// Where the eye is.
    [[nodiscard]] DVec3 eye() const { return target_ + distance_ * outward(); }
    [[nodiscard]] DVec3 right() const { return unit(cross(up_, outward())); }
    [[nodiscard]] DVec3 above() const { return cross(outward(), right()); }
    [[nodiscard]] const DVec3& target() const { return target_; }
    [[nodiscard]] double distance() const { return distance_; }

    /// `size` of the panel. Empty: behind the eye, or so near that it has no place on screen.
    [[nodiscard]] std::optional<SpacePoint> project(const DVec3& p, const DVec2& size) const {
        const DVec3 from_eye = p - eye();
        const double depth = -dot(from_eye, outward());
        if (depth < nearest()) return std::nullopt;
        const double scale = points_per_slope(size) / depth;
        return SpacePoint{0.5 * size + scale * DVec2(dot(from_eye, right()), -dot(from_eye, above())), depth};
    }

    /// The part of a line that lies in front of the eye, as its two ends on screen; empty if there is none.
    [[nodiscard]] std::optional<std::pair<SpacePoint, SpacePoint>> project(const SpaceLine& line,
                                                                           const DVec2& size) const {
        const double at_a = -dot(line.a - eye(), outward()) - 1.001 * nearest();
        const double at_b = -dot(line.b - eye(), outward()) - 1.001 * nearest();
        if (at_a < 0.0 && at_b < 0.0) return std::nullopt;
        const DVec3 between = line.a + (line.b - line.a) * (at_a / (at_a - at_b));
        const auto a = project(at_a < 0.0 ? between : line.a, size);
        const auto b = project(at_b < 0.0 ? between : line.b, size);
        if (!a || !b) return std::nullopt;
        return std::pair{*a, *b};
    }

    /// Turns around the target by `drag` in points; half a turn per 600 points.
    void orbit(const DVec2& drag) {
        yaw_ -= drag.x * pi / 600.0;
        pitch_ = std::clamp(pitch_ + drag.y * pi / 600.0, -most_pitch, most_pitch);
    }
    /// Moves the target so that what lies in its plane follows the mouse.
    void pan(const DVec2& drag, const DVec2& size) {
        const double scale = distance_ / points_per_slope(size);
        target_ += scale * (-drag.x * right() + drag.y * above());
    }
    /// The eye goes nearer (factor > 1) or away.
    void zoom(double factor) { distance_ /= factor; }
    friend bool operator==(const SpaceView&, const SpaceView&) = default;

private:
    static constexpr double half_angle = 20.0 * pi / 180.0;  ///< of the field of view, along the shorter side
    static constexpr double most_pitch = 89.0 * pi / 180.0;  ///< from above, yaw would lose its meaning

    /// What is nearer to the eye than this is not shown.
    [[nodiscard]] double nearest() const { return 1e-3 * distance_; }
    [[nodiscard]] DVec3 outward() const {
        const DVec3 flat = std::cos(yaw_) * zero_ + std::sin(yaw_) * cross(up_, zero_);
        return std::cos(pitch_) * flat + std::sin(pitch_) * up_;
    }
    [[nodiscard]] static double points_per_slope(const DVec2& size) {
        return 0.5 * std::min(size.x, size.y) / std::tan(half_angle);
    }

    DVec3 target_{};
    double distance_ = 1.0;
    DVec3 up_{0.0, 1.0, 0.0};
    DVec3 zero_{0.0, 0.0, 1.0};  // where yaw is 0, perpendicular to up_
    double yaw_ = 0.0;
    double pitch_ = 0.0;
};

}  // namespace pol
