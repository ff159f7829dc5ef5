// SPDX-License-Identifier: Apache-2.0
// Explains the pixel of a case again and compares.
#pragma once

#include <memory>

#include "io/scenes/pixel_case_file.h"
#include "tracer/explain.h"

namespace pol {

struct PixelCaseVerdict {
    std::shared_ptr<const Plan> plan;
    Explanation explanation{};
    CoherenceMatrix<double> computed{};
    double difference = 0.0;  ///< largest |computed - expected| of an element; NaN if a number went bad
    bool holds = false;
};

/// Error: the scene cannot be compiled.
Result<PixelCaseVerdict> check(const PixelCase& pixel_case);

}  // namespace pol
