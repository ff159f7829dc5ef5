// SPDX-License-Identifier: Apache-2.0
// From scene text to Stokes vectors, through the same loader, compiler and renderer as the program.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "io/scenes/scene_file.h"
#include "plan/compile.h"
#include "render/render_to_end.h"
#include "tracer/explain.h"

namespace pol::test {

/// The scene written in `yaml`. Throws (failing the test) with the loader's message if there is none.
inline Scene scene_of(const std::string& yaml) {
    auto scene = parse_scene(yaml, "test.yaml", POL_TESTS_DIR);
    if (!scene) throw std::runtime_error(to_string(scene.error()));
    return std::move(scene).value();
}

/// A scene of assets/scenes, without its ending: "cube-glass", "bench/g1".
inline Scene shipped_scene(const std::string& name) {
    auto scene = load_scene(std::string(POL_ASSETS) + "/scenes/" + name + ".yaml");
    if (!scene) throw std::runtime_error(to_string(scene.error()));
    return std::move(scene).value();
}

inline std::shared_ptr<const Plan> plan_of(const Scene& scene) {
    auto plan = compile(scene);
    if (!plan) throw std::runtime_error(to_string(plan.error()));
    return std::move(plan).value();
}

/// The finished picture.
inline StokesImage render(const std::shared_ptr<const Plan>& plan, int threads = 1, int tile_size = 32) {
    return render_to_end(plan, {}, {threads, tile_size}).picture;
}

inline StokesImage render(const Scene& scene) {
    return render(plan_of(scene));
}

/// A one-pixel picture of the scene: the ray from the camera to its target, at the scene's first wavelength.
inline Stokes<double> look(Scene scene) {
    scene.render.width = scene.render.height = 1;
    return render(scene).at(0, 0);
}
inline Stokes<double> look(const std::string& yaml) {
    return look(scene_of(yaml));
}

/// The tree of that ray.
inline Explanation explain_look(Scene scene) {
    scene.render.width = scene.render.height = 1;
    return explain(*plan_of(scene), 0, 0, 0, 0);
}

}  // namespace pol::test
