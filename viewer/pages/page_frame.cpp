// SPDX-License-Identifier: Apache-2.0
#include "viewer/pages/page_frame.h"

#include <cmath>

#include "viewer/pages/pixel_page.h"

namespace pol {

std::optional<CameraRay> camera_axes(const Document& document, PixelAddress pixel) {
    if (!document.has_scene()) return std::nullopt;
    return document.plan()->camera.ray(pixel.x + 0.5, pixel.y + 0.5);
}

double frame_angle(const PageSettings& settings, const std::optional<CameraRay>& axes, std::string& trouble) {
    switch (settings.frame) {
        case FrameChoice::camera:
            return 0.0;
        case FrameChoice::own_angle:
            return settings.own_angle;
        case FrameChoice::scene_x:
        case FrameChoice::scene_y:
        case FrameChoice::scene_z:
            break;
    }
    if (!axes) {
        trouble = "A picture has no scene axes: camera frame";
        return 0.0;
    }
    const int axis = static_cast<int>(settings.frame) - static_cast<int>(FrameChoice::scene_x);
    const double along_x = axes->x[axis];
    const double along_y = axes->y[axis];
    constexpr double seen_end_on = 1e-9;
    if (std::hypot(along_x, along_y) < seen_end_on) {
        trouble = "That axis points along the ray: camera frame";
        return 0.0;
    }
    return std::atan2(along_y, along_x);
}

StokesComponents known_in_frame(StokesComponents known, double angle) {
    return angle == 0.0 || known.has(StokesComponents::linear()) ? known : known.without(1).without(2);
}

double shown_angle(const Session& session) {
    std::string trouble;
    return frame_angle(session.page(), camera_axes(*session.current(), *session.selection().pinned()), trouble);
}

PageAxes page_axes(const Session& session) {
    const double angle = shown_angle(session);
    return {session.view().convention.x_sign() * DVec2(std::cos(angle), -std::sin(angle)),
            {-std::sin(angle), -std::cos(angle)}};
}

}  // namespace pol
