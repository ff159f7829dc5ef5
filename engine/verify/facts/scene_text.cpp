// SPDX-License-Identifier: Apache-2.0
#include "verify/facts/scene_text.h"

#include <fmt/format.h>

#include <cmath>

#include "verify/facts/literal_calcite.h"

namespace pol::verify {

std::string text(double value) {
    return fmt::format("{:.17g}", value);
}

std::string text(const DVec3& v) {
    return fmt::format("[{}, {}, {}]", text(v.x), text(v.y), text(v.z));
}

std::string picture(std::string_view settings) {
    return fmt::format("render: {{size: [{0}, {0}]{1}{2}}}\n", picture_side, settings.empty() ? "" : ", ", settings);
}

DVec3 downward(double i) {
    return {std::sin(i), 0.0, -std::cos(i)};
}

DVec3 upward(double i) {
    return {std::sin(i), 0.0, std::cos(i)};
}

std::string camera_seeing_s_as_x(const DVec3& from, const DVec3& target, double width) {
    const DVec3 d = unit(target - from);
    return fmt::format("camera: {{type: orthographic, position: {}, target: {}, up: {}, width: {}}}\n", text(from),
                       text(target), text(DVec3(-d.z, 0.0, d.x)), text(width));
}

std::string camera_along(const DVec3& direction, double distance, double width) {
    return camera_seeing_s_as_x(-direction * distance, DVec3(0.0), width);
}

std::string camera_in_plane(const DVec3& direction, const DVec3& target, double width) {
    return fmt::format("camera: {{type: orthographic, position: {}, target: {}, up: [0, 0, 1], width: {}}}\n",
                       text(target - direction * 10.0), text(target), text(width));
}

std::string placed(const DVec3& center, const DVec3& normal, const DVec3& x) {
    const DVec3 y = cross(normal, x);
    std::string rows;
    for (int i = 0; i < 3; ++i)
        rows += fmt::format("{}[{}, {}, {}, {}]", i == 0 ? "" : ", ", text(x[i]), text(y[i]), text(normal[i]),
                            text(center[i]));
    return "transform: [{matrix: [" + rows + "]}]";
}

std::string lamp(std::string_view name, const DVec3& center, const DVec3& normal, double size,
                 std::string_view emission) {
    return fmt::format("  - {{name: {}, shape: {{rectangle: {{size: {}}}}}, {}, emission: {{{}}}}}\n", name, text(size),
                       placed(center, normal, DVec3(0.0, -1.0, 0.0)), emission);
}

std::string lamp_in_plane(const DVec3& center, const DVec3& normal, double size) {
    return fmt::format("  - {{name: lamp, shape: {{rectangle: {{size: {}}}}}, {}, emission: {{radiance: 1}}}}\n",
                       text(size), placed(center, normal, {0.0, 0.0, 1.0}));
}

std::string polarized(std::string_view stokes) {
    return fmt::format("radiance: 1, polarization: {{stokes: {}}}", stokes);
}

std::string box(std::string_view name, const DVec3& size, const DVec3& center, std::string_view medium) {
    return fmt::format("  - {{name: {}, shape: {{box: {{size: {}}}}}, transform: [{{translate: {}}}], medium: {}}}\n",
                       name, text(size), text(center), medium);
}

std::string calcite(const DVec3& axis) {
    return fmt::format("{{ordinary: {}, extraordinary: {}, axis: {}}}", calcite_n_o, calcite_n_e, text(axis));
}

std::string extruded(std::string_view name, const std::vector<DVec2>& polygon, std::string_view medium) {
    std::string corners;
    for (const DVec2& p : polygon)
        corners += fmt::format("{}[{}, {}]", corners.empty() ? "" : ", ", text(p.x), text(p.y));
    return fmt::format("  - {{name: {}, shape: {{extrusion: {{polygon: [{}], height: 2}}}}, medium: {}}}\n", name,
                       corners, medium);
}

std::string deep_block(std::string_view medium) {
    return box("block", {40.0, 40.0, 4.0}, {0.0, 0.0, -2.0}, medium) +
           "  - {name: bottom, shape: {rectangle: {size: 39}}, transform: [{translate: [0, 0, -2]}], absorber: on}\n";
}

std::string plate(std::string_view name, std::string_view medium, double top, double turn) {
    return fmt::format(
        "  - {{name: {}, shape: {{box: {{size: [4, 4, 1]}}}}, transform: [{{rotate: {{axis: [0, 0, 1], angle: "
        "{}}}}}, {{translate: [0, 0, {}]}}], medium: {}}}\n",
        name, text(turn), text(top - 0.5), medium);
}

}  // namespace pol::verify
