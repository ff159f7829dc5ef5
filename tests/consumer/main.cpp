// SPDX-License-Identifier: Apache-2.0
// A program outside of the tree: renders a shipped scene and reads the coherence matrix of the middle of the picture.
#include <polariscope/polariscope.h>

#include <cstdio>

namespace ps = polariscope;

int main() {
    const auto small = [](const ps::Scene& scene) {
        ps::RenderSettings settings = scene.settings();
        settings.width = settings.height = 48;
        return scene.with(settings);
    };
    const auto light = ps::shipped_scene("cube-calcite")
                           .and_then(ps::load_scene)
                           .and_then(small)
                           .and_then(ps::compile)
                           .and_then([](const ps::Plan& plan) { return ps::render(plan); })
                           .and_then([](const ps::Rendering& done) { return done.picture.coherence(24, 24); });
    if (!light) {
        std::fprintf(stderr, "%s\n", to_string(light.error()).c_str());
        return 1;
    }
    const ps::Coherence& j = light.value();
    std::printf("J = [%.17g, %.17g %+.17gi; %.17g]\n", j.xx, j.xy.real(), j.xy.imag(), j.yy);
}
