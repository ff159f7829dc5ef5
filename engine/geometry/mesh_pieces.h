// SPDX-License-Identifier: Apache-2.0
// The pieces that a mesh falls into, and how exactly its numbers tell where they are. Tolerances follow the piece: what
// lies elsewhere in the same file does not matter.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace pol {

/// Piece of each vertex, numbered from 0 in the order of their first vertices. Triangles that share a vertex, or have
/// equal ones, are of one piece.
std::vector<std::uint32_t> pieces_of(const std::vector<DVec3>& vertices,
                                     std::span<const std::array<std::uint32_t, 3>> triangles);

/// Accuracy of vertices as a file gives them.
class Precision {
public:
    Precision(const std::vector<DVec3>& vertices, std::span<const std::array<std::uint32_t, 3>> triangles);

    /// Half the diagonal of the bounding box of the piece of vertex `v`.
    [[nodiscard]] double piece_size(std::uint32_t v) const { return size_[piece_[v]]; }

    /// How far rounding may have moved `p`: half an ulp along each axis, of 32 bits if all coordinates of the file are
    /// such numbers, else of 64.
    [[nodiscard]] double rounding(const DVec3& p) const;

    /// Of the numbers: 32 or 64.
    [[nodiscard]] int bits() const { return float32_ ? 32 : 64; }

private:
    std::vector<std::uint32_t> piece_;
    std::vector<double> size_;
    bool float32_ = true;
};

/// For each vertex the lowest-numbered kept vertex within its tolerance and that one's own; `kept` receives the
/// survivors in order. Tolerances are rounded down to powers of two.
std::vector<std::uint32_t> weld(const std::vector<DVec3>& vertices, const std::vector<double>& tolerances,
                                std::vector<DVec3>& kept);

}  // namespace pol
