// SPDX-License-Identifier: Apache-2.0
// Several doubles side by side, with the operations that formulas over `Real` use: each lane computes what a double
// does.
#pragma once

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
    typedef double Numbers __attribute__((vector_size(16), may_alias));     // NOLINT: `using` takes no attribute here
    typedef std::int64_t Mask __attribute__((vector_size(16), may_alias));  // NOLINT
};
template <>
struct LaneRegister<4> {
    typedef double Numbers __attribute__((vector_size(32), may_alias));     // NOLINT
    typedef std::int64_t Mask __attribute__((vector_size(32), may_alias));  // NOLINT
};
template <>
struct LaneRegister<8> {
    typedef double Numbers __attribute__((vector_size(64), may_alias));     // NOLINT
    typedef std::int64_t Mask __attribute__((vector_size(64), may_alias));  // NOLINT
};

/// What a comparison of lanes gives: all bits or none in each.
template <int width>
struct LaneMask {
    typename LaneRegister<width>::Mask bits;
    [[gnu::always_inline]] friend LaneMask operator&(LaneMask a, LaneMask b) { return {a.bits & b.bits}; }
    [[gnu::always_inline]] friend LaneMask operator|(LaneMask a, LaneMask b) { return {a.bits | b.bits}; }
    [[gnu::always_inline]] friend LaneMask operator!(LaneMask a) { return {~a.bits}; }
};

/// Only +, -, *, / and the square root: correctly rounded, so that the bits do not depend on the width. Functions of an
/// instruction set must be `flatten` where they use lanes wider than 2: they are passed differently between functions
/// of different sets.
template <int width_>
class Lanes {
public:
    static constexpr int width = width_;
    using Numbers = typename LaneRegister<width_>::Numbers;
    using Mask = LaneMask<width_>;

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
    [[gnu::always_inline]] friend Lanes select(const Mask& mask, const Lanes& yes, const Lanes& no) {
        return Lanes(Numbers(mask.bits ? yes.v_ : no.v_));
    }

private:
    Numbers v_;
};

/// select() of a single number, so that a formula is written once.
template <class Real>
Real select(bool yes, const Real& a, const Real& b) {
    return yes ? a : b;
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
