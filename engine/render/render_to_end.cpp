// SPDX-License-Identifier: Apache-2.0
#include "render/render_to_end.h"

#include <utility>

namespace pol {

FinishedRender render_to_end(std::shared_ptr<const Plan> plan, const RenderOptions& options, const Workers& workers,
                             const std::function<void(const RenderProgress&)>& show, const std::stop_token& stop) {
    constexpr double show_every_s = 0.1;
    Renderer renderer(workers.threads, workers.tile_size);
    renderer.start(std::move(plan), options);
    const std::stop_callback on_stop(stop, [&renderer] { renderer.cancel(); });
    while (!renderer.wait_for(show_every_s))
        if (show) show(renderer.progress());
    FinishedRender finished{renderer.snapshot(), renderer.progress()};
    if (show) show(finished.progress);
    return finished;
}

}  // namespace pol
