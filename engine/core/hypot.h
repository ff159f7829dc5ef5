// SPDX-License-Identifier: Apache-2.0
// std::hypot, but with the same bits on every machine: glibc fuses multiplications with additions on arm64 and not on
// x86-64, and what it gives differs in one case of eight.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

namespace pol {

/// The hypotenuse over legs x >= y > 0 whose squares neither overflow nor underflow. The root of the rounded sum of
/// squares, and one step of Newton's whose residual h^2 - x^2 - y^2 is summed so that it does not cancel (C. F. Borges,
/// "Algorithm 1014: An Improved Algorithm for hypot(x, y)", ACM TOMS 47(1), 2021, corrected, without fused operations).
template <std::floating_point Real>
Real corrected_hypotenuse(Real x, Real y) {
    const Real h = std::sqrt(x * x + y * y);
    Real residual;
    if (h <= 2 * y) {
        const Real delta = h - y;
        residual = x * (2 * delta - x) + (delta - 2 * (x - y)) * delta;
    } else {
        const Real delta = h - x;
        residual = 2 * delta * (x - 2 * y) + ((4 * delta - y) * y + delta * delta);
    }
    return h - residual / (2 * h);
}

/// sqrt(a^2 + b^2) to 1 ulp; no overflow or underflow on the way.
template <std::floating_point Real>
Real hypot(Real a, Real b) {
    a = std::abs(a);
    b = std::abs(b);
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    if (a == infinity || b == infinity) return infinity;
    if (std::isnan(a) || std::isnan(b)) return a + b;
    const Real x = std::max(a, b);
    const Real y = std::min(a, b);
    if (y <= x * (std::numeric_limits<Real>::epsilon() / 4)) return x;
    constexpr Real scale = 0x1p600;
    if (x > Real(0x1p511)) return corrected_hypotenuse(x / scale, y / scale) * scale;
    if (y < Real(0x1p-459)) return corrected_hypotenuse(x * scale, y * scale) / scale;
    return corrected_hypotenuse(x, y);
}

}  // namespace pol
