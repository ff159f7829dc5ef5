// SPDX-License-Identifier: Apache-2.0
// The state of a plane wave on its way through a medium: either a pair of modes that share one wave vector
// (isotropic media, or a crystal wave along the optic axis) or a single crystal mode.
#pragma once

#include <cstdint>

#include "core/vec.h"

namespace pol {

enum class WaveKind : std::uint8_t {
    pair,           ///< two transverse modes, one wave vector: a 2x2 state
    ordinary,       ///< o mode of a uniaxial crystal
    extraordinary,  ///< e mode of a uniaxial crystal
};

/// Wave vector, ray and electric basis of a propagating wave.
///
/// k is in units of omega/c, so |k| is the refractive index seen. `ray` is the unit direction of energy flow
/// (Poynting vector). field[0], and for a pair field[1], are unit real E vectors. For a pair they are
/// perpendicular to k and to each other. The sign of a field vector carries no meaning of its own; every
/// amplitude that refers to it does.
template <class Real>
struct Wave {
    WaveKind kind = WaveKind::pair;
    Vec3<Real> k{};
    Vec3<Real> ray{};
    Vec3<Real> field[2]{};

    [[nodiscard]] int mode_count() const { return kind == WaveKind::pair ? 2 : 1; }
};

}  // namespace pol
