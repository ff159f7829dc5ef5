// SPDX-License-Identifier: Apache-2.0
// Jones calculus: fully polarized fields and what acts on them. Fields vary as exp(i(k.r - omega t)).
#pragma once

#include <concepts>

#include "core/complex.h"

namespace pol {

/// Complex field amplitudes along x and y of a stated frame; |x|^2 + |y|^2 is the power.
template <class Real>
struct JonesVector {
    Complex<Real> x{};
    Complex<Real> y{};
    friend constexpr bool operator==(const JonesVector&, const JonesVector&) = default;
};

/// 2x2 complex matrix between two stated frames, [row][column]: out_i = sum_j m[i][j] in_j. The only one in the house.
template <class Real>
struct JonesMatrix {
    Complex<Real> m[2][2]{};

    static constexpr JonesMatrix identity() { return {{{Real(1), Real(0)}, {Real(0), Real(1)}}}; }

    template <std::integral Index>
    constexpr auto& operator[](Index row) {
        return m[row];
    }
    template <std::integral Index>
    constexpr const auto& operator[](Index row) const {
        return m[row];
    }
    constexpr auto* begin() { return m; }
    constexpr auto* end() { return m + 2; }
    constexpr const auto* begin() const { return m; }
    constexpr const auto* end() const { return m + 2; }

    friend constexpr JonesMatrix operator*(const JonesMatrix& a, const JonesMatrix& b) {
        return {{{a[0][0] * b[0][0] + a[0][1] * b[1][0], a[0][0] * b[0][1] + a[0][1] * b[1][1]},
                 {a[1][0] * b[0][0] + a[1][1] * b[1][0], a[1][0] * b[0][1] + a[1][1] * b[1][1]}}};
    }
    friend constexpr JonesVector<Real> operator*(const JonesMatrix& a, const JonesVector<Real>& v) {
        return {a[0][0] * v.x + a[0][1] * v.y, a[1][0] * v.x + a[1][1] * v.y};
    }
    friend constexpr bool operator==(const JonesMatrix&, const JonesMatrix&) = default;
};

}  // namespace pol
