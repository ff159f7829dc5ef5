// SPDX-License-Identifier: Apache-2.0
#include "scene/place.h"

#include <cmath>
#include <string>
#include <utility>

namespace pol {

Error at_place(Error error, const Scene& scene, const SourcePlace& place) {
    if (!error.place.file.empty()) return error;
    const auto file = static_cast<std::size_t>(place.file);
    if (file < scene.files.size()) error.place = {scene.files[file], place.line, place.column};
    return error;
}

Error at_object(Error error, const Scene& scene, int object) {
    error.field = "objects[" + std::to_string(object) + "]" + (error.field.empty() ? "" : ".") + error.field;
    return at_place(std::move(error), scene, scene.objects[static_cast<std::size_t>(object)].place);
}

DVec3 direction_to_world(const DMat4& to_world, const DVec3& direction) {
    const DMat3 m(to_world);
    const double size2 = length2(m[0]);
    const double same = 1e-12 * size2;  // far above rounding, far below what turns an axis
    const bool stretches = std::abs(length2(m[1]) - size2) > same || std::abs(length2(m[2]) - size2) > same ||
                           std::abs(dot(m[0], m[1])) > same || std::abs(dot(m[1], m[2])) > same ||
                           std::abs(dot(m[2], m[0])) > same;
    if (!stretches) return unit(m * direction);
    const DVec3 x = unit(m[0]);
    const DVec3 y = unit(m[1] - dot(m[1], x) * x);
    const DVec3 z = cross(x, y);
    const DVec3 d = unit(direction);
    return unit(d.x * x + d.y * y + (dot(m[2], z) < 0.0 ? -d.z : d.z) * z);
}

}  // namespace pol
