// SPDX-License-Identifier: Apache-2.0
#include "verify/degenerate/one_ray.h"

#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <utility>

#include "plan/compile.h"
#include "render/render_to_end.h"

namespace pol::verify {

OneRay look(const Scene& scene) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const OneRay refused{{nan, nan, nan, nan}, nan};
    const auto plan = compile(scene);
    if (!plan) return refused;
    const auto [picture, progress] = render_to_end(plan.value(), {}, {.threads = 1});
    if (progress.statistics.failures > 0) return refused;
    return {picture.at(0, 0), picture.plane_value(picture.residual, 0, 0) + picture.plane_value(picture.tail, 0, 0)};
}

Camera camera_at(const DVec3& from, const DVec3& direction, const DVec3& up) {
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.position = from;
    camera.target = from + direction;
    camera.up = up;
    camera.width = 1.0;
    return camera;
}

Scene empty_scene(const Camera& camera, double residual) {
    Scene scene;
    scene.camera = camera;
    scene.render.width = 1;
    scene.render.height = 1;
    scene.render.residual = residual;
    scene.render.node_budget = RenderSettings::whole_tree;
    return scene;
}

Medium glass_medium(const std::string& name, double n) {
    return {name, IsotropicMedium{ConstantIndex{{n, 0.0}}, ConstantSpectrum{0.0}}};
}

Object solid(const std::string& name, Shape shape, const DVec3& center, const std::string& medium) {
    return {name, std::move(shape), glm::translate(DMat4(1.0), center), FilledWith{medium}, {}};
}

Object lamp_sheet(const DVec3& center, double size, EmittedState state) {
    return {"lamp",
            RectangleShape{{size, size}},
            glm::translate(DMat4(1.0), center),
            Emission{Spectrum{ConstantSpectrum{1.0}}, std::move(state), true},
            {}};
}

}  // namespace pol::verify
