// SPDX-License-Identifier: Apache-2.0
#include "verify/convergence/anytime.h"

#include <algorithm>
#include <cmath>

#include "compare/error_metrics.h"
#include "core/number_text.h"
#include "render/renderer.h"

namespace pol::verify {

namespace {

AnytimePoint look(const Renderer& renderer, const StokesImage& reference) {
    const RenderProgress progress = renderer.progress();
    const StokesImage picture = renderer.snapshot();
    AnytimePoint point;
    point.seconds = progress.seconds;
    point.error = error_metrics(picture, reference).fro_c.whole;
    point.bound = relative_bound(picture, reference);
    if (progress.film.error.sampling) point.sampling = *progress.film.error.sampling;
    return point;
}

}  // namespace

std::vector<AnytimePoint> anytime_curve(const std::shared_ptr<const Plan>& plan, const StokesImage& reference,
                                        int threads, const KeepGoing& keep_going) {
    constexpr double first_look_s = 2e-4;
    constexpr double next_look = 1.25;  // times the last, from the beginning of the render
    constexpr int small_tile = 8;       // a picture of a few pixels grows, too
    Renderer renderer(threads, small_tile);
    std::vector<AnytimePoint> curve;
    renderer.start(plan);
    double nap = first_look_s;
    while (!renderer.wait_for(nap)) {
        renderer.pause();
        if (!keep_going(0)) return {};
        const AnytimePoint point = look(renderer, reference);
        if (curve.empty() || point.error != curve.back().error) curve.push_back(point);
        nap = std::max(first_look_s, (next_look - 1.0) * point.seconds);
        renderer.resume();
    }
    curve.push_back(look(renderer, reference));
    return curve;
}

std::string anytime_csv(const std::vector<AnytimePoint>& curve) {
    std::string text = "seconds,fro_c,bound,sampling\n";
    for (const AnytimePoint& point : curve) {
        text += number_text(point.seconds) + "," + number_text(point.error) + "," + number_text(point.bound) + ",";
        text += (std::isnan(point.sampling) ? "" : number_text(point.sampling)) + "\n";
    }
    return text;
}

}  // namespace pol::verify
