// SPDX-License-Identifier: Apache-2.0
// A 128-bit real number (113-bit significand): the reference that results in double are held against. GLM's vectors can
// hold it; boost's has a constructor that their unions do not allow. Functions are good to a few units of 1e-34.
#pragma once

#include <cmath>
#include <compare>
#include <limits>

namespace pol {

#if defined(__SIZEOF_FLOAT128__)
__extension__ typedef __float128 NativeQuad;  // NOLINT: __extension__ takes no alias declaration
#else
using NativeQuad = long double;  // the same format on arm64 and RISC-V
static_assert(std::numeric_limits<NativeQuad>::digits == 113, "this machine has no 128-bit floating-point numbers");
#endif

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

inline bool isfinite(const Quad& a) {
    return a.value - a.value == 0;
}

/// Newton from the double root: 53, 106, then all 113 bits. Numbers beyond the range of double are brought into it by
/// powers of four.
inline Quad sqrt(const Quad& a) {
    if (a.value == 0 || !isfinite(a)) return a;
    const Quad far(0x1p500);
    if (a > far) return sqrt(a / far) * Quad(0x1p250);
    if (a * far < Quad(1)) return sqrt(a * far) / Quad(0x1p250);
    NativeQuad root = static_cast<NativeQuad>(std::sqrt(static_cast<double>(a.value)));
    for (int i = 0; i < 3; ++i) root = (root + a.value / root) / 2;
    return {root};
}

inline Quad hypot(const Quad& a, const Quad& b) {
    return sqrt(a * a + b * b);
}

/// Taylor's series of exp(x / 2^k), squared k times. Requires: |x| < 10000.
inline Quad exp(const Quad& x) {
    Quad y = x;
    int halvings = 0;
    for (; abs(y) > Quad(1.0 / 64.0); ++halvings) y = y / Quad(2);
    Quad sum(1);
    Quad term(1);
    for (int i = 1; i < 20; ++i) {
        term = term * y / Quad(i);
        sum += term;
    }
    for (; halvings > 0; --halvings) sum *= sum;
    return sum;
}

/// The same angle within half a turn of zero, to 1e-34 of a radian per turn taken away. pi is the sum of three doubles.
inline Quad within_half_a_turn(const Quad& x) {
    constexpr Quad turn =
        Quad(2) * (Quad(0x1.921fb54442d18p+1) + Quad(0x1.1a62633145c07p-53) + Quad(-0x1.f1976b7ed8fbcp-109));
    return x - Quad(std::nearbyint(static_cast<double>(x / turn))) * turn;
}

/// Taylor's series of the sine.
inline Quad sin(const Quad& angle) {
    const Quad x = within_half_a_turn(angle);
    Quad sum = x;
    Quad term = x;
    for (int i = 2; i < 50; i += 2) {
        term = -term * x * x / Quad(i * (i + 1));
        sum += term;
    }
    return sum;
}

/// As sin.
inline Quad cos(const Quad& angle) {
    const Quad x = within_half_a_turn(angle);
    Quad sum(1);
    Quad term(1);
    for (int i = 1; i < 50; i += 2) {
        term = -term * x * x / Quad(i * (i + 1));
        sum += term;
    }
    return sum;
}

/// The double angle, and what is left after turning back by it: so small that its tangent's series has two terms.
inline Quad atan2(const Quad& y, const Quad& x) {
    const Quad size = abs(x) > abs(y) ? abs(x) : abs(y);
    if (size == Quad(0)) return Quad(0);
    const Quad u = x / size;
    const Quad v = y / size;
    const Quad rough(std::atan2(static_cast<double>(v), static_cast<double>(u)));
    const Quad c = cos(rough);
    const Quad s = sin(rough);
    const Quad rest = (v * c - u * s) / (u * c + v * s);
    return rough + rest - rest * rest * rest / Quad(3);
}

}  // namespace pol

template <>
class std::numeric_limits<pol::Quad> {
public:
    static constexpr bool is_specialized = true;
    static constexpr bool is_iec559 = true;
    static constexpr bool is_integer = false;
    static constexpr bool is_signed = true;
    /// 2^-112
    static constexpr pol::Quad epsilon() { return pol::Quad(0x1p-112); }
    static constexpr pol::Quad quiet_NaN() { return pol::Quad(std::numeric_limits<double>::quiet_NaN()); }
};
