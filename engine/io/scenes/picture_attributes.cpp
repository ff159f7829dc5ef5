// SPDX-License-Identifier: Apache-2.0
#include "io/scenes/picture_attributes.h"

#include <fmt/format.h>

#include "io/scenes/scene_hash.h"

namespace pol {

std::map<std::string, std::string> picture_attributes(const Scene& scene, int samples_per_pixel,
                                                      const std::filesystem::path& file) {
    const RenderSettings& s = scene.render;
    return {{"scene", file.filename().string()},
            {"scene_hash", scene_hash(scene)},
            {"settings", fmt::format("mode={} spp={} residual={} depth={} node_budget={} seed={}{}",
                                     s.mode == SampleMode::area ? "area" : "point", samples_per_pixel, s.residual,
                                     s.depth ? std::to_string(*s.depth) : "none", s.node_budget, s.seed,
                                     s.unpolarized ? " unpolarized" : "")}};
}

}  // namespace pol
