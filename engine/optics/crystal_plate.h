// SPDX-License-Identifier: Apache-2.0
// Light behind the paper's virtual crystal plate (section 5.3): a plane-parallel plate of a uniaxial crystal covers the
// emitter, and only one of its two rays is passed on.
#pragma once

#include <cstddef>

#include "core/vec.h"
#include "optics/boundary_solver.h"
#include "optics/elements.h"
#include "polarization/coherence_matrix.h"

namespace pol {

/// State of the light that leaves such an emitter of unit basic radiance along `light_direction` into a medium of index
/// `n`, in the basis (e1, e2).
///
/// By reciprocity (PHYSICS.md 2.8): a wave sent back along the light enters the crystal, and the transpose of the
/// amplitudes of its transmitted mode is what light in that mode turns into on its way out. The light in the crystal is
/// unpolarized, half of it in the mode that passes: the trace is 1/2, or with `fresnel` 1/2 times the transmittance of
/// the exit face for that mode.
///
/// Where the crystal has only one ray (along the optic axis; equal indices) half of the unpolarized light passes. Where
/// the passed mode does not exist inside for this direction (evanescent), or the light runs into the emitter: zero.
///
/// Requires: `normal` (outward) and `light_direction` are unit; e1, e2 are unit, perpendicular to each other and the
/// light.
inline CoherenceMatrix<double> crystal_plate_state(const Dielectric<double>& crystal, const DVec3& normal,
                                                   const DVec3& light_direction, double n, CrystalRay passed,
                                                   bool fresnel, const DVec3& e1, const DVec3& e2) {
    const Dielectric<double> ambient = make_isotropic(n);
    const DVec3 back = -light_direction;
    const Wave<double> wave{WaveKind::pair, n * back, back, {e1, e2}};
    const BoundaryResponse<double> response = respond(ambient, crystal, -normal, wave);
    const WaveKind kind = passed == CrystalRay::ordinary ? WaveKind::ordinary : WaveKind::extraordinary;
    CoherenceMatrix<double> state;
    double transmittance = 0.0;
    double share = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(response.outgoing_count); ++i) {
        const OutgoingWave<double>& out = response.outgoing[i];
        const bool passes = out.wave.kind == kind || out.wave.kind == WaveKind::pair;
        if (out.side != Side::transmitted || !passes) continue;
        share = 0.5 / out.wave.mode_count();
        for (std::size_t m = 0; m < static_cast<std::size_t>(out.wave.mode_count()); ++m) {
            JonesVector<double> field;
            for (std::size_t j = 0; j < 2; ++j) {
                field.x += out.amplitude[m][j] * dot(response.incident_field[j], e1);
                field.y += out.amplitude[m][j] * dot(response.incident_field[j], e2);
            }
            state += CoherenceMatrix<double>::outer(field);
        }
        transmittance = trace(state) / out.wave.mode_count();
    }
    if (transmittance == 0.0) return {};
    return (fresnel ? share : share / transmittance) * state;
}

}  // namespace pol
