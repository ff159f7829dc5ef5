// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace pol {

/// A step between numbers on an axis: 1, 2 or 5 times a power of ten, the one nearest to `rough` on a logarithmic scale
/// or nearly so. Requires: rough > 0.
inline double round_step(double rough) {
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double mantissa = rough / power;
    return power * (mantissa < 1.5 ? 1.0 : mantissa < 3.5 ? 2.0 : mantissa < 7.5 ? 5.0 : 10.0);
}

}  // namespace pol
