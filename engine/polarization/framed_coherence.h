// SPDX-License-Identifier: Apache-2.0
// A coherence matrix means nothing without the frame it is written in.
#pragma once

#include "polarization/coherence_matrix.h"
#include "polarization/polarization_frame.h"

namespace pol {

template <class Real>
struct FramedCoherence {
    CoherenceMatrix<Real> j;
    PolarizationFrame<Real> frame;
};

/// Rewrites `beam` in `target`. The light does not change, only its description.
/// Requires: both frames have the same k.
template <class Real>
FramedCoherence<Real> in_frame(const FramedCoherence<Real>& beam, const PolarizationFrame<Real>& target) {
    return {rotate_basis(beam.j, angle_between(beam.frame, target)), target};
}

}  // namespace pol
