// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "film/stokes_image.h"
#include "plan/plan.h"
#include "tracer/ray_tree.h"
#include "verify/convergence/run_table.h"

namespace pol::verify {

/// What somebody who looks at a render has at one moment. Errors as fro_c, light that no tile has brought yet is
/// missing.
struct AnytimePoint {
    double seconds = 0.0;            ///< of rendering, without the time for looking
    double error = 0.0;              ///< of the picture against the reference
    double bound = 0.0;              ///< rigorous, of what was not traced (relative_bound)
    double sampling = not_measured;  ///< estimated from two independent halves; area pictures of several samples
};

/// One render from the first tile to its end, looked at ever more seldom: the reader sees what waiting buys. The
/// workers rest while an error is worked out. Empty once `keep_going` has said no. Requires: the reference has the
/// plan's size and wavelengths.
std::vector<AnytimePoint> anytime_curve(const std::shared_ptr<const Plan>& plan, const StokesImage& reference,
                                        int threads, const KeepGoing& keep_going);

/// One line per point: seconds, error, bound, sampling.
std::string anytime_csv(const std::vector<AnytimePoint>& curve);

}  // namespace pol::verify
