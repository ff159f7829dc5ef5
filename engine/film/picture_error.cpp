// SPDX-License-Identifier: Apache-2.0
#include "film/picture_error.h"

#include <cmath>

namespace pol {

namespace {

/// Root of error / light; an error without light is infinite, nothing wrong with nothing is 0.
double relative_rms(double error, double light) {
    return error > 0.0 ? std::sqrt(error / light) : 0.0;
}

}  // namespace

PictureError picture_error(const ErrorSums& sums, bool random_samples) {
    PictureError error;
    error.random_samples = random_samples;
    if (sums.count > 0.0) error.residual_mean = sums.residual / sums.count;
    error.residual_max = sums.residual_max;
    error.truncation = relative_rms(sums.missing, sums.light);
    if (!random_samples && !sums.has_tail) error.sampling = 0.0;
    // Halves that are black agree, and say nothing of the light that both have missed.
    if (random_samples && !sums.has_single && sums.light > 0.0)
        error.sampling = relative_rms(sums.half_error, sums.light);
    if (sums.half_error > 0.0) error.sampling_spread = std::sqrt(sums.half_error_square) / sums.half_error;
    return error;
}

}  // namespace pol
