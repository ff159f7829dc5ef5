// SPDX-License-Identifier: Apache-2.0
#include "polariscope/render.h"

#include "io/scenes/picture_attributes.h"
#include "polariscope/inside.h"
#include "render/memory.h"
#include "render/render_to_end.h"

namespace polariscope {

using detail::Inside;
using detail::usage;

namespace {

RenderProgress outer_progress(const pol::RenderProgress& p) {
    RenderProgress progress;
    progress.done = p.done;
    progress.seconds = p.seconds;
    progress.seconds_left = p.seconds_left;
    progress.fewest_samples = p.film.fewest_samples;
    progress.truncation = p.film.error.truncation;
    progress.sampling = p.film.error.sampling;
    progress.failures = p.statistics.failures;
    return progress;
}

Error no_memory() {
    return {ErrorKind::memory,     "there is not enough memory for this picture", {}, 0, 0, "render.size",
            "render a smaller one"};
}

Result<RenderEnd> end_of(pol::StopReason reason) {
    switch (reason) {
        case pol::StopReason::samples:
            return RenderEnd::samples;
        case pol::StopReason::time:
            return RenderEnd::seconds;
        case pol::StopReason::error:
            return RenderEnd::error;
        case pol::StopReason::truncation:
            return RenderEnd::truncation;
        case pol::StopReason::dark:
            return RenderEnd::dark;
        case pol::StopReason::cancelled:
            return RenderEnd::stopped;
        case pol::StopReason::memory:
            return no_memory();
        case pol::StopReason::none:
            break;
    }
    return Error{ErrorKind::internal, "the render ended for no reason", {}, 0, 0, {}, {}};
}

}  // namespace

Result<Rendering> render(const Plan& plan, const RenderOptions& options) {
    if (options.threads < 0 || options.threads > 1024)
        return usage("options.threads", "so many threads cannot work", "1 to 1024, or 0 for all of the machine");
    if (options.seconds && !(*options.seconds > 0.0 && *options.seconds < 1e9))
        return usage("options.seconds", "is no time limit", "a positive number of seconds");
    if (options.error && !(*options.error > 0.0 && *options.error < 10.0))
        return usage("options.error", "is no error to stop at", "a share of the picture, for example 0.01");
    return detail::guarded([&]() -> Result<Rendering> {
        const detail::PlanData& data = Inside::of(plan);
        if (!pol::fits_memory(*data.plan)) return no_memory();
        pol::RenderOptions rules;
        rules.stop = {options.seconds, options.error};
        pol::Workers workers;
        if (options.threads > 0) workers.threads = options.threads;
        const auto show = [&options](const pol::RenderProgress& progress) {
            if (options.progress) options.progress(outer_progress(progress));
        };
        pol::FinishedRender done = pol::render_to_end(data.plan, rules, workers, show, options.stop);
        const Result<RenderEnd> end = end_of(done.progress.reason);
        if (!end) return end.error();
        const detail::SceneData& scene = Inside::of(data.scene);
        done.picture.attributes.merge(pol::picture_attributes(scene.scene, done.picture.samples, scene.file));
        return Rendering{Inside::pack(detail::PictureData{std::move(done.picture)}), outer_progress(done.progress),
                         end.value()};
    });
}

}  // namespace polariscope
