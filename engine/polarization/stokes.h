// SPDX-License-Identifier: Apache-2.0
// Stokes vectors: four real numbers that describe a beam in a stated frame. See CONVENTIONS.md for the frame,
// the handedness and the time sign.
#pragma once

#include <array>

namespace pol {

/// Stokes vector in a right-handed frame (x, y, k) about the direction of the light, spectral radiance units.
/// s1: x minus y, s2: +45 minus -45 degrees, s3: right minus left circular as seen by the receiver.
template <class Real>
struct Stokes {
    Real s0{};
    Real s1{};
    Real s2{};
    Real s3{};

    constexpr Stokes& operator+=(const Stokes& b) {
        s0 += b.s0;
        s1 += b.s1;
        s2 += b.s2;
        s3 += b.s3;
        return *this;
    }
    friend constexpr Stokes operator+(Stokes a, const Stokes& b) { return a += b; }
    friend constexpr Stokes operator-(const Stokes& a, const Stokes& b) {
        return {a.s0 - b.s0, a.s1 - b.s1, a.s2 - b.s2, a.s3 - b.s3};
    }
    friend constexpr Stokes operator*(const Real& f, const Stokes& a) {
        return {f * a.s0, f * a.s1, f * a.s2, f * a.s3};
    }
    friend constexpr bool operator==(const Stokes& a, const Stokes& b) = default;
};

/// S0, S1, S2, S3 in this order.
inline constexpr std::array<double Stokes<double>::*, 4> stokes_components{&Stokes<double>::s0, &Stokes<double>::s1,
                                                                           &Stokes<double>::s2, &Stokes<double>::s3};

}  // namespace pol
