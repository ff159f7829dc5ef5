// SPDX-License-Identifier: Apache-2.0
// A smooth plane boundary between any two media: which waves leave it, and with what amplitudes.
//
// Conventions (polarization/CONVENTIONS.md): fields vary as exp(i(k.r - omega t)), H = k x E, the normal n points
// from medium 1 (incidence) to medium 2, s = unit(n x k), p = unit(k) x s. Amplitudes are flux-normalised:
// |amplitude|^2 is the ratio of the energy fluxes through the boundary, so at a lossless boundary the
// matrix of amplitudes over the propagating waves has orthonormal columns.
//
// Backward step (PHYSICS.md 2.8): hand in the camera ray as if it were light. With symmetric permittivities
// S_ij(k_t) = S_ji(-k_t) for the same field vectors, so light travelling the other way is transformed by the
// transpose of `amplitude`.
#pragma once

#include <array>
#include <cstdint>

#include "core/complex.h"
#include "core/vec.h"
#include "optics/dielectric.h"
#include "optics/wave.h"
#include "polarization/jones.h"

namespace pol {

enum class Side : std::uint8_t { reflected, transmitted };

/// A propagating wave that leaves the boundary.
/// amplitude[i][j]: mode i of this wave (field[i]) for unit flux in mode j of the incident wave.
template <class Real>
struct OutgoingWave {
    Side side = Side::reflected;
    Wave<Real> wave{};
    JonesMatrix<Real> amplitude{};
};

/// An outgoing mode that decays away from the boundary and carries no power; for display.
template <class Real>
struct EvanescentMode {
    Side side = Side::reflected;
    WaveKind kind = WaveKind::pair;
    int index_in_pair = 0;  ///< 0 = s, 1 = p for a pair
    Vec3<Real> k_re{};
    Vec3<Real> k_im{};
};

/// What a boundary does to one incident wave.
template <class Real>
struct BoundaryResponse {
    /// False if the incident wave brings no energy to the boundary (flux along n <= 0): then nothing else is set.
    bool incident = false;
    /// Basis of the incident wave that `amplitude` columns refer to. For a pair: (s, p); for a crystal mode its
    /// own field in [0].
    std::array<Vec3<Real>, 2> incident_field{};
    int incident_modes = 1;
    /// Propagating outgoing waves: at most two per side.
    std::array<OutgoingWave<Real>, 4> outgoing{};
    int outgoing_count = 0;
    /// Power that is lost at the boundary: a^H absorption a for the incident amplitudes a. Hermitian, zero for lossless
    /// media. What a conductor, or an absorbing medium whose wave dies at once, swallows, computed from the field
    /// inside and not as 1 - R; in an absorbing medium 1 also what the interference of incident and reflected wave
    /// takes, or, being negative, adds (AbsorbingFresnel::mixed_s).
    JonesMatrix<Real> absorption{};
    bool absorbs = false;
};

}  // namespace pol
