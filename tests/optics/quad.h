// SPDX-License-Identifier: Apache-2.0
// A 128-bit real number (113-bit significand) that GLM's vectors can hold: boost's has a constructor that their unions
// do not allow.
#pragma once

#include <compare>
#include <limits>

namespace pol::test {

__extension__ typedef __float128 NativeQuad;

struct Quad {
    NativeQuad value;

    Quad() = default;
    constexpr Quad(NativeQuad v) : value(v) {}  // NOLINT: a number is a number
    constexpr explicit Quad(int v) : value(static_cast<NativeQuad>(v)) {}
    constexpr explicit Quad(double v) : value(static_cast<NativeQuad>(v)) {}
    explicit operator double() const { return static_cast<double>(value); }

    friend constexpr Quad operator+(const Quad& a, const Quad& b) { return {a.value + b.value}; }
    friend constexpr Quad operator-(const Quad& a, const Quad& b) { return {a.value - b.value}; }
    friend constexpr Quad operator*(const Quad& a, const Quad& b) { return {a.value * b.value}; }
    friend constexpr Quad operator/(const Quad& a, const Quad& b) { return {a.value / b.value}; }
    friend constexpr Quad operator-(const Quad& a) { return {-a.value}; }
    constexpr Quad& operator+=(const Quad& b) { return *this = *this + b; }
    constexpr Quad& operator-=(const Quad& b) { return *this = *this - b; }
    constexpr Quad& operator*=(const Quad& b) { return *this = *this * b; }
    constexpr Quad& operator/=(const Quad& b) { return *this = *this / b; }
    friend constexpr bool operator==(const Quad& a, const Quad& b) { return a.value == b.value; }
    friend constexpr bool operator<(const Quad& a, const Quad& b) { return a.value < b.value; }
    friend constexpr bool operator>(const Quad& a, const Quad& b) { return a.value > b.value; }
    friend constexpr bool operator<=(const Quad& a, const Quad& b) { return a.value <= b.value; }
    friend constexpr bool operator>=(const Quad& a, const Quad& b) { return a.value >= b.value; }
};

inline Quad abs(const Quad& a) {
    return a.value < 0 ? -a : a;
}

/// Newton from the double root: 53, 106, then all 113 bits.
inline Quad sqrt(const Quad& a) {
    if (a.value == 0) return a;
    NativeQuad root = static_cast<NativeQuad>(__builtin_sqrt(static_cast<double>(a.value)));
    for (int i = 0; i < 3; ++i) root = (root + a.value / root) / 2;
    return {root};
}

inline Quad hypot(const Quad& a, const Quad& b) {
    return sqrt(a * a + b * b);
}

}  // namespace pol::test

template <>
class std::numeric_limits<pol::test::Quad> {
public:
    static constexpr bool is_specialized = true;
    static constexpr bool is_iec559 = true;
    static constexpr bool is_integer = false;
    static constexpr bool is_signed = true;
    /// 2^-112
    static constexpr pol::test::Quad epsilon() {
        pol::test::Quad e(1);
        for (int i = 0; i < 112; ++i) e = e / pol::test::Quad(2);
        return e;
    }
};
