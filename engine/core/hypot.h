// SPDX-License-Identifier: Apache-2.0
// std::hypot, but with the same bits on every machine: glibc fuses multiplications with additions on arm64 and not on
// x86-64, and what it gives differs in one case of eight.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include "core/lanes.h"

namespace pol {

/// The hypotenuse over legs x >= y > 0 whose squares neither overflow nor underflow. The root of the rounded sum of
/// squares, and one step of Newton's whose residual h^2 - x^2 - y^2 is summed so that it does not cancel (C. F. Borges,
/// "Algorithm 1014: An Improved Algorithm for hypot(x, y)", ACM TOMS 47(1), 2021, corrected, without fused operations).
template <class Real>
Real corrected_hypotenuse(const Real& x, const Real& y) {
    using std::sqrt;
    const Real two(2);
    const Real h = sqrt(x * x + y * y);
    const Real over_y = h - y;
    const Real over_x = h - x;
    const Real residual = select(h <= two * y, x * (two * over_y - x) + (over_y - two * (x - y)) * over_y,
                                 two * over_x * (x - two * y) + ((Real(4) * over_x - y) * y + over_x * over_x));
    return h - residual / (two * h);
}

/// sqrt(a^2 + b^2) to 1 ulp; no overflow or underflow on the way.
template <class Real>
requires(std::floating_point<Real> || is_lanes<Real>) Real hypot(const Real& a, const Real& b) {
    using std::abs;
    using Limits = std::numeric_limits<Real>;
    const Real abs_a = abs(a);
    const Real abs_b = abs(b);
    const auto swap = abs_a < abs_b;
    const Real x = select(swap, abs_b, abs_a);
    const Real y = select(swap, abs_a, abs_b);
    const auto large = x > Real(0x1p511);
    const auto small = y < Real(0x1p-459);
    const Real scale = select(large, Real(0x1p-600), select(small, Real(0x1p600), Real(1)));
    const Real back = select(large, Real(0x1p600), select(small, Real(0x1p-600), Real(1)));
    const Real h = corrected_hypotenuse<Real>(x * scale, y * scale) * back;
    const Real finite = select(y <= x * Real(Limits::epsilon() / 4), x, h);
    const auto a_is_infinite = abs_a > Real(Limits::max());
    const auto b_is_infinite = abs_b > Real(Limits::max());
    return select(a_is_infinite | b_is_infinite, Real(Limits::infinity()), finite);
}

}  // namespace pol
