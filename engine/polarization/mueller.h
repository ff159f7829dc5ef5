// SPDX-License-Identifier: Apache-2.0
// Mueller matrices, for display and tests: the tracer itself works with Jones and coherence matrices.
#pragma once

#include <array>
#include <cstddef>

#include "polarization/coherence_matrix.h"
#include "polarization/jones.h"
#include "polarization/stokes.h"

namespace pol {

/// Real 4x4 matrix on Stokes vectors, m[row][column], between two stated frames.
template <class Real>
struct MuellerMatrix {
    std::array<std::array<Real, 4>, 4> m{};

    friend constexpr Stokes<Real> operator*(const MuellerMatrix& a, const Stokes<Real>& s) {
        const auto row = [&](std::size_t i) {
            return a.m[i][0] * s.s0 + a.m[i][1] * s.s1 + a.m[i][2] * s.s2 + a.m[i][3] * s.s3;
        };
        return {row(0), row(1), row(2), row(3)};
    }
    friend constexpr bool operator==(const MuellerMatrix&, const MuellerMatrix&) = default;
};

/// Mueller matrix of a deterministic element: column j is what A makes of the j-th unit Stokes vector.
template <class Real>
constexpr MuellerMatrix<Real> to_mueller(const JonesMatrix<Real>& a) {
    MuellerMatrix<Real> result;
    for (std::size_t column = 0; column < 4; ++column) {
        const auto one_at = [&](std::size_t i) { return i == column ? Real(1) : Real(0); };
        const Stokes<Real> unit_vector{one_at(0), one_at(1), one_at(2), one_at(3)};
        const Stokes<Real> image = to_stokes(transform(a, to_coherence(unit_vector)));
        result.m[0][column] = image.s0;
        result.m[1][column] = image.s1;
        result.m[2][column] = image.s2;
        result.m[3][column] = image.s3;
    }
    return result;
}

}  // namespace pol
