// SPDX-License-Identifier: Apache-2.0
// A small complex type: std::complex costs 1.7-2x in hot code (it must handle Inf and NaN by Annex G) and is
// unspecified for types wider than long double.
#pragma once

#include <cmath>

#include "core/hypot.h"

namespace pol {

template <class Real>
struct Complex {
    Real re{};
    Real im{};

    constexpr Complex() = default;
    constexpr Complex(Real real) : re(real), im(Real(0)) {}  // NOLINT: a real number is a complex number
    constexpr Complex(Real real, Real imaginary) : re(real), im(imaginary) {}

    constexpr Complex& operator+=(const Complex& b) { return *this = *this + b; }
    constexpr Complex& operator-=(const Complex& b) { return *this = *this - b; }
    constexpr Complex& operator*=(const Complex& b) { return *this = *this * b; }

    friend constexpr Complex operator+(const Complex& a, const Complex& b) { return {a.re + b.re, a.im + b.im}; }
    friend constexpr Complex operator-(const Complex& a, const Complex& b) { return {a.re - b.re, a.im - b.im}; }
    friend constexpr Complex operator-(const Complex& a) { return {-a.re, -a.im}; }
    friend constexpr Complex operator*(const Complex& a, const Complex& b) {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    friend constexpr Complex operator*(const Complex& a, const Real& b) { return {a.re * b, a.im * b}; }
    friend constexpr Complex operator*(const Real& a, const Complex& b) { return {a * b.re, a * b.im}; }
    friend constexpr Complex operator/(const Complex& a, const Real& b) { return {a.re / b, a.im / b}; }
    /// Smith's scaling (R. L. Smith, CACM 5(8), 1962): no overflow where the quotient is representable.
    friend constexpr Complex operator/(const Complex& a, const Complex& b) {
        const Real abs_re = b.re < Real(0) ? -b.re : b.re;
        const Real abs_im = b.im < Real(0) ? -b.im : b.im;
        if (abs_re >= abs_im) {
            const Real ratio = b.im / b.re;
            const Real scale = b.re + b.im * ratio;
            return {(a.re + a.im * ratio) / scale, (a.im - a.re * ratio) / scale};
        }
        const Real ratio = b.re / b.im;
        const Real scale = b.re * ratio + b.im;
        return {(a.re * ratio + a.im) / scale, (a.im * ratio - a.re) / scale};
    }
    friend constexpr bool operator==(const Complex& a, const Complex& b) = default;
};

template <class Real>
constexpr Complex<Real> conj(const Complex<Real>& z) {
    return {z.re, -z.im};
}

/// |z|^2
template <class Real>
constexpr Real norm2(const Complex<Real>& z) {
    return z.re * z.re + z.im * z.im;
}

template <class Real>
Real abs(const Complex<Real>& z) {
    return hypot(z.re, z.im);
}

/// exp(i angle)
template <class Real>
Complex<Real> unit_phase(const Real& angle) {
    using std::cos;
    using std::sin;
    return {cos(angle), sin(angle)};
}

/// a/b without a branch, where |b|^2 neither overflows nor underflows. Rounding |b|^2 changes the size alone.
template <class Real>
constexpr Complex<Real> quotient(const Complex<Real>& a, const Complex<Real>& b) {
    return a * conj(b) / norm2(b);
}

/// Square root with a non-negative imaginary part: with exp(-i omega t) the wave that decays along +.
/// The branch is continuous across the positive real axis from above only; a real negative radicand gives +i.
template <class Real>
Complex<Real> sqrt_decaying(const Complex<Real>& z) {
    using std::abs;
    using std::sqrt;
    const auto forward = Real(0) <= z.re;
    if constexpr (!is_lanes<Real>)  // the short way to the same
        if (z.im == Real(0)) return forward ? Complex<Real>(sqrt(abs(z.re))) : Complex<Real>(Real(0), sqrt(abs(z.re)));
    // The larger part first; the other from the product 2 re im = Im z, so neither cancels.
    const Real larger = sqrt((hypot(z.re, z.im) + abs(z.re)) / Real(2));
    const Real smaller = select(abs(z.im) > Real(0), z.im / (Real(2) * larger), Real(0));
    const auto turned = smaller < Real(0);
    return {select(forward, select(turned, -larger, larger), smaller),
            select(forward, select(turned, -smaller, smaller), larger)};
}

}  // namespace pol
