// SPDX-License-Identifier: Apache-2.0
// A number that counts: how many rounded operations stand, one after the other, between an input and this result.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/hypot.h"

namespace pol::verify {

/// A double and the length of the longest chain of rounded operations that led to it. Inputs and constants have length
/// 0; negation, absolute value and comparison do not round.
struct Chain {
    double value;
    int length;

    Chain() = default;
    constexpr explicit Chain(int v) : value(v), length(0) {}
    constexpr explicit Chain(double v, int links = 0) : value(v), length(links) {}
    explicit operator double() const { return value; }

    static constexpr Chain link(double v, const Chain& a, const Chain& b) {
        return Chain(v, std::max(a.length, b.length) + 1);
    }
    friend constexpr Chain operator+(const Chain& a, const Chain& b) { return link(a.value + b.value, a, b); }
    friend constexpr Chain operator-(const Chain& a, const Chain& b) { return link(a.value - b.value, a, b); }
    friend constexpr Chain operator*(const Chain& a, const Chain& b) { return link(a.value * b.value, a, b); }
    friend constexpr Chain operator/(const Chain& a, const Chain& b) { return link(a.value / b.value, a, b); }
    friend constexpr Chain operator-(const Chain& a) { return Chain(-a.value, a.length); }
    constexpr Chain& operator+=(const Chain& b) { return *this = *this + b; }
    constexpr Chain& operator-=(const Chain& b) { return *this = *this - b; }
    constexpr Chain& operator*=(const Chain& b) { return *this = *this * b; }
    constexpr Chain& operator/=(const Chain& b) { return *this = *this / b; }
    friend constexpr bool operator==(const Chain& a, const Chain& b) { return a.value == b.value; }
    friend constexpr bool operator<(const Chain& a, const Chain& b) { return a.value < b.value; }
    friend constexpr bool operator>(const Chain& a, const Chain& b) { return a.value > b.value; }
    friend constexpr bool operator<=(const Chain& a, const Chain& b) { return a.value <= b.value; }
    friend constexpr bool operator>=(const Chain& a, const Chain& b) { return a.value >= b.value; }
};

inline Chain abs(const Chain& a) {
    return Chain(std::abs(a.value), a.length);
}
inline bool isfinite(const Chain& a) {
    return std::isfinite(a.value);
}
inline Chain sqrt(const Chain& a) {
    return Chain::link(std::sqrt(a.value), a, a);
}
inline Chain exp(const Chain& a) {
    return Chain::link(std::exp(a.value), a, a);
}
inline Chain sin(const Chain& a) {
    return Chain::link(std::sin(a.value), a, a);
}
inline Chain cos(const Chain& a) {
    return Chain::link(std::cos(a.value), a, a);
}
inline Chain hypot(const Chain& a, const Chain& b) {
    return Chain::link(pol::hypot(a.value, b.value), a, b);
}
inline Chain atan2(const Chain& a, const Chain& b) {
    return Chain::link(std::atan2(a.value, b.value), a, b);
}

}  // namespace pol::verify

template <>
class std::numeric_limits<pol::verify::Chain> {
public:
    static constexpr bool is_specialized = true;
    static constexpr bool is_iec559 = true;
    static constexpr bool is_integer = false;
    static constexpr bool is_signed = true;
    static constexpr pol::verify::Chain epsilon() { return pol::verify::Chain(std::numeric_limits<double>::epsilon()); }
    static constexpr pol::verify::Chain quiet_NaN() {
        return pol::verify::Chain(std::numeric_limits<double>::quiet_NaN());
    }
};
