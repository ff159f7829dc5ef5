// SPDX-License-Identifier: Apache-2.0
// The small linear systems of boundary problems, real or complex.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "optics/uniaxial_modes.h"

namespace pol::detail {

/// Solves the 2x2 system with rows `m` for up to two right sides, in place: rhs[column] becomes the solution.
template <class Scalar>
void solve_2x2(const std::array<std::array<Scalar, 2>, 2>& m, std::array<std::array<Scalar, 2>, 2>& rhs, int columns) {
    const Scalar determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    for (std::size_t c = 0; c < static_cast<std::size_t>(columns); ++c) {
        const std::array<Scalar, 2> b = rhs[c];
        rhs[c][0] = (b[0] * m[1][1] - m[0][1] * b[1]) / determinant;
        rhs[c][1] = (m[0][0] * b[1] - b[0] * m[1][0]) / determinant;
    }
}

/// Gaussian elimination with partial pivoting: rows hold the 4x4 matrix and `Columns` right sides from column 4 on,
/// which become the solutions.
template <std::size_t Columns, class Scalar>
void solve_4x4(std::array<std::array<Scalar, 6>, 4>& rows) {
    constexpr std::size_t end = 4 + Columns;
    const Scalar one(decltype(norm2(rows[0][0]))(1));
    std::array<Scalar, 4> per_pivot;
    for (std::size_t i = 0; i < 4; ++i) {
        std::size_t pivot = i;
        for (std::size_t j = i + 1; j < 4; ++j) {
            if (norm2(rows[j][i]) > norm2(rows[pivot][i])) pivot = j;
        }
        if (pivot != i) std::swap(rows[i], rows[pivot]);
        per_pivot[i] = one / rows[i][i];
        for (std::size_t j = i + 1; j < 4; ++j) {
            const Scalar factor = rows[j][i] * per_pivot[i];
            for (std::size_t c = i + 1; c < end; ++c) rows[j][c] = rows[j][c] - factor * rows[i][c];
        }
    }
    for (std::size_t c = 4; c < end; ++c) {
        for (std::size_t i = 4; i-- > 0;) {
            Scalar sum = rows[i][c];
            for (std::size_t j = i + 1; j < 4; ++j) sum = sum - rows[i][j] * rows[j][c];
            rows[i][c] = sum * per_pivot[i];
        }
    }
}

}  // namespace pol::detail
