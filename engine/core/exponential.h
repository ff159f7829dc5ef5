// SPDX-License-Identifier: Apache-2.0
// std::exp and std::expm1, but with the same bits on every machine and side by side (core/lanes.h): what libraries give
// differs between their versions, and what Highway gives between instruction sets.
//
// x = k ln 2 + r with |r| <= ln 2 / 2, as Cody and Waite reduce it (W. J. Cody, W. Waite, "Software Manual for the
// Elementary Functions", 1980, ch. 6), then Taylor's series to r^14. Only +, -, * and exact powers of two, no branch.
#pragma once

#include "core/lanes.h"

namespace pol {
namespace detail {

/// exp(x) = 2^k (1 + r + rest)
template <class Real>
struct ReducedExponent {
    Real k{};
    Real r{};
    Real rest{};  ///< from the square on, less than a fifth of r
};

template <class Real>
ReducedExponent<Real> reduced_exponent(const Real& x) {
    // ln 2 in two parts: products of the first with whole numbers of up to 20 bits are exact.
    constexpr double ln2_high = 0x1.62e42feep-1;
    constexpr double ln2_low = 0x1.a39ef35793c76p-33;
    constexpr double per_ln2 = 0x1.71547652b82fep+0;
    const Real k = nearest_whole(x * Real(per_ln2));
    const Real high = x - k * Real(ln2_high);
    const Real low = k * Real(ln2_low);
    const Real r = high - low;
    const Real rounded_off = (high - r) - low;
    double factorial = 87178291200.0;  // 14!
    Real series(1.0 / factorial);
    for (int n = 14; n > 2; --n) {
        factorial /= n;
        series = series * r + Real(1.0 / factorial);
    }
    return {k, r, r * r * series + (rounded_off + rounded_off * r)};
}

}  // namespace detail

/// e^x to less than 1 ulp; below the normal numbers to the last of theirs.
template <class Real>
Real exponential(const Real& x) {
    constexpr double beyond = 800.0;  // e^x is infinite or zero from 746 on
    const Real above = select(x < Real(-beyond), Real(-beyond), x);
    const auto [k, r, rest] = detail::reduced_exponent(select(above > Real(beyond), Real(beyond), above));
    const Real sum = Real(1) + r;
    const Real rounded_off = r - (sum - Real(1));
    // 2^k itself may be beyond the normal numbers.
    const Real half = nearest_whole(k * Real(0.5));
    return (sum + (rounded_off + rest)) * power_of_two(half) * power_of_two(k - half);
}

/// e^x - 1 to less than 1 ulp.
template <class Real>
Real exponential_less_one(const Real& x) {
    constexpr double highest = 710.0;  // infinite from there on
    constexpr double lowest = -60.0;   // -1 but for 1e-26
    constexpr double tiny = 0x1p-54;   // the square of what is smaller does not show
    const Real above = select(x < Real(lowest), Real(lowest), x);
    const auto [k, r, rest] = detail::reduced_exponent(select(above > Real(highest), Real(highest), above));
    // Twice (power - 1/2 + power r + power rest): the errors of both sums are known (D. E. Knuth, "The Art of Computer
    // Programming" vol. 2, 4.2.2, theorem B), so that what cancels does so without a trace.
    const auto error_of_sum = [](const Real& a, const Real& b, const Real& sum) {
        const Real second = sum - a;
        return (a - (sum - second)) + (b - second);
    };
    const Real power = power_of_two(k - Real(1));
    const Real less_half = power - Real(0.5);
    const Real linear = power * r;
    const Real sum = less_half + linear;
    const Real rounded_off = error_of_sum(power, Real(-0.5), less_half) + error_of_sum(less_half, linear, sum);
    const Real result = Real(2) * (sum + (rounded_off + power * rest));
    return select((x < Real(tiny)) & (x > Real(-tiny)), x, result);
}

}  // namespace pol
