// SPDX-License-Identifier: Apache-2.0
// Several doubles side by side, with the operations that formulas over `Real` use: each lane computes what a double
// does.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pol {

/// Registers of 2, 4 or 8 doubles as GCC and Clang know them on every machine; where the processor's are narrower, they
/// take several. (Highway's own types exist in functions of one instruction set only, so headers could not use them.)
template <int width>
struct LaneRegister;
template <>
struct LaneRegister<2> {
    typedef double Numbers __attribute__((vector_size(16), may_alias));      // NOLINT: `using` takes no attribute here
    typedef std::int64_t Mask __attribute__((vector_size(16), may_alias));   // NOLINT
    typedef std::uint64_t Bits __attribute__((vector_size(16), may_alias));  // NOLINT
};
template <>
struct LaneRegister<4> {
    typedef double Numbers __attribute__((vector_size(32), may_alias));      // NOLINT
    typedef std::int64_t Mask __attribute__((vector_size(32), may_alias));   // NOLINT
    typedef std::uint64_t Bits __attribute__((vector_size(32), may_alias));  // NOLINT
};
template <>
struct LaneRegister<8> {
    typedef double Numbers __attribute__((vector_size(64), may_alias));      // NOLINT
    typedef std::int64_t Mask __attribute__((vector_size(64), may_alias));   // NOLINT
    typedef std::uint64_t Bits __attribute__((vector_size(64), may_alias));  // NOLINT
};

/// What a comparison of lanes gives: all bits or none in each.
template <int width>
struct LaneMask {
    typename LaneRegister<width>::Mask bits;
    [[gnu::always_inline]] friend LaneMask operator&(LaneMask a, LaneMask b) { return {a.bits & b.bits}; }
    [[gnu::always_inline]] friend LaneMask operator|(LaneMask a, LaneMask b) { return {a.bits | b.bits}; }
    [[gnu::always_inline]] friend LaneMask operator!(LaneMask a) { return {~a.bits}; }
};

/// From 2^52 to 2^53 doubles are whole numbers: adding this rounds, and leaves the number in the lowest bits, negative
/// ones as two's complement.
constexpr double whole_numbers = 0x1.8p52;
/// Of the exponent of doubles.
constexpr std::uint64_t power_of_two_bias = 1023;

/// Only +, -, *, /, the square root and exact powers of two: correctly rounded, so that the bits do not depend on the
/// width. Functions of an instruction set must be `flatten` where they use lanes wider than 2: they are passed
/// differently between functions of different sets.
template <int width_>
class Lanes {
public:
    static constexpr int width = width_;
    using Numbers = typename LaneRegister<width_>::Numbers;
    using Mask = LaneMask<width_>;
    using Bits = typename LaneRegister<width_>::Bits;

    Lanes() = default;
    [[gnu::always_inline]] Lanes(double all)
        : v_(all - Numbers{}) {}  // NOLINT: a number is the same number in every lane
    [[gnu::always_inline]] explicit Lanes(const Numbers& v) : v_(v) {}

    /// Requires: `from`, `to` are aligned to the width.
    [[gnu::always_inline]] static Lanes load(const double* from) {
        return Lanes(*reinterpret_cast<const Numbers*>(from));
    }
    [[gnu::always_inline]] void store(double* to) const { *reinterpret_cast<Numbers*>(to) = v_; }

    [[gnu::always_inline]] friend Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.v_ + b.v_); }
    [[gnu::always_inline]] friend Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.v_ - b.v_); }
    [[gnu::always_inline]] friend Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.v_ * b.v_); }
    [[gnu::always_inline]] friend Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.v_ / b.v_); }
    [[gnu::always_inline]] friend Lanes operator-(const Lanes& a) { return Lanes(-a.v_); }
    [[gnu::always_inline]] Lanes& operator+=(const Lanes& b) { return *this = *this + b; }
    [[gnu::always_inline]] Lanes& operator-=(const Lanes& b) { return *this = *this - b; }
    [[gnu::always_inline]] Lanes& operator*=(const Lanes& b) { return *this = *this * b; }
    [[gnu::always_inline]] friend Mask operator<(const Lanes& a, const Lanes& b) { return {a.v_ < b.v_}; }
    [[gnu::always_inline]] friend Mask operator>(const Lanes& a, const Lanes& b) { return {a.v_ > b.v_}; }
    [[gnu::always_inline]] friend Mask operator<=(const Lanes& a, const Lanes& b) { return {a.v_ <= b.v_}; }

    [[gnu::always_inline]] friend Lanes sqrt(const Lanes& a) {
        Numbers root = a.v_;
        for (int i = 0; i < width_; ++i) root[i] = std::sqrt(root[i]);
        return Lanes(root);
    }
    [[gnu::always_inline]] friend Lanes abs(const Lanes& a) {
        return Lanes(Numbers(Bits(a.v_) & ~(Bits{} + (std::uint64_t{1} << 63U))));
    }
    [[gnu::always_inline]] friend Lanes power_of_two(const Lanes& whole) {
        return Lanes(Numbers((Bits((whole + Lanes(whole_numbers)).v_) + power_of_two_bias) << 52U));
    }
    [[gnu::always_inline]] friend Lanes select(const Mask& mask, const Lanes& yes, const Lanes& no) {
        return Lanes(Numbers(mask.bits ? yes.v_ : no.v_));
    }

private:
    Numbers v_;
};

template <class Real>
inline constexpr bool is_lanes = false;
template <int width>
inline constexpr bool is_lanes<Lanes<width>> = true;

/// select() of a single number, so that a formula is written once.
template <class Real>
Real select(bool yes, const Real& a, const Real& b) {
    return yes ? a : b;
}

/// The nearest whole number, of a tie the even one. Requires: |a| < 2^51.
template <class Real>
Real nearest_whole(const Real& a) {
    return (a + Real(whole_numbers)) - Real(whole_numbers);
}

/// 2^whole. Requires: `whole` is a whole number from -1022 to 1023.
inline double power_of_two(double whole) {
    return std::bit_cast<double>((std::bit_cast<std::uint64_t>(whole + whole_numbers) + power_of_two_bias) << 52U);
}

/// What `Real` answers to a comparison.
template <class Real>
using MaskOf = decltype(Real() < Real());

}  // namespace pol

namespace std {
/// GLM asks before it computes.
template <int width>
class numeric_limits<pol::Lanes<width>> : public numeric_limits<double> {};
}  // namespace std
