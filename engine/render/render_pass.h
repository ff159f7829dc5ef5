// SPDX-License-Identifier: Apache-2.0
// One pass over one tile with the kernel that the plan needs.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "film/tile.h"
#include "plan/plan.h"
#include "render/preview.h"
#include "render/render_progress.h"
#include "render/sample_round.h"

namespace pol {

/// A worker's tracer; keeps its memory between tiles. Not for sharing between threads.
class PassTracer {
public:
    virtual ~PassTracer() = default;
    /// Traces samples of the pixels of the buffer into it. Returns early, with a buffer of no use, once `cancelled` is
    /// set.
    virtual RenderStatistics trace(const SampleSpan& samples, const std::atomic<bool>& cancelled,
                                   TileBuffer& buffer) = 0;
    /// Traces strip.row of the preview, a sample per block. Returns early, like trace().
    virtual void preview(const PreviewGrid& grid, const std::atomic<bool>& cancelled, PreviewStrip& strip) = 0;
};

/// Whether branches are followed side by side where the plan allows it (why_not_in_lanes()): the same bits, faster.
enum class Follow { side_by_side, one_by_one };

/// With the kernel for the plan. The plan must outlive it.
std::unique_ptr<PassTracer> make_pass_tracer(const Plan& plan, Follow follow = Follow::side_by_side);

}  // namespace pol
