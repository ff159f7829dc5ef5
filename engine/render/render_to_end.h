// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <stop_token>

#include "film/stokes_image.h"
#include "plan/plan.h"
#include "render/render_progress.h"
#include "render/renderer.h"

namespace pol {

/// Who works; the picture does not depend on it.
struct Workers {
    int threads = hardware_threads();
    int tile_size = 32;
};

struct FinishedRender {
    StokesImage picture;
    RenderProgress progress;  ///< at the end; its reason says why it ended
};

/// Renders until the samples are there, a rule of options.stop ends it, or `stop` is requested: then the picture holds
/// the tiles that were finished. `show` is called on this thread, ten times a second and at the end.
FinishedRender render_to_end(std::shared_ptr<const Plan> plan, const RenderOptions& options = {},
                             const Workers& workers = {}, const std::function<void(const RenderProgress&)>& show = {},
                             const std::stop_token& stop = {});

}  // namespace pol
