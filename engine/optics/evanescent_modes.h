// SPDX-License-Identifier: Apache-2.0
// The waves at a boundary that decay away from it: nothing is followed along them, but people want to see them.
#pragma once

#include <vector>

#include "optics/boundary_solver.h"

namespace pol {

namespace detail {

template <class Real>
void list_decaying(std::vector<EvanescentMode<Real>>& modes, Side side, const IncidenceFrame<Real>& frame,
                   const CrystalRoots<Real>& roots) {
    const auto add = [&](WaveKind kind, const Complex<Real>& q) {
        modes.push_back({side, kind, 0, frame.wave_vector(q.re), q.im * frame.normal});
    };
    if (!roots.o_propagates) add(WaveKind::ordinary, roots.q_o);
    if (!roots.e_propagates) add(WaveKind::extraordinary, roots.q_e);
}

}  // namespace detail

/// Evanescent outgoing modes of both sides: of a medium-2 dielectric beyond its critical angle s and p, of a crystal o
/// or e or both. Empty if the wave is not incident, if the media are the same matter, and for absorbing media, whose
/// field carries power. k_im points away from the boundary. Requirements as for `respond`.
template <class Real>
std::vector<EvanescentMode<Real>> evanescent_modes(const Dielectric<Real>& medium1, const Dielectric<Real>& medium2,
                                                   const Vec3<Real>& normal, const Wave<Real>& incident) {
    std::vector<EvanescentMode<Real>> modes;
    const IncidenceFrame<Real> frame = incidence_frame(normal, incident.k);
    CrystalFace<Real> face1;
    if (medium1.kind == MediumKind::uniaxial) face1 = crystal_face(medium1, frame);
    const detail::Incidence<Real> incidence = detail::describe_incidence(frame, medium1, face1, incident);
    if (!(incidence.flux > Real(0)) || same_matter(medium1, medium2)) return modes;
    if (medium1.kind == MediumKind::uniaxial) {
        detail::list_decaying(modes, Side::reflected, frame, detail::reflected_roots(face1, incident.kind, frame.q));
    }
    if (medium2.kind == MediumKind::uniaxial) {
        const CrystalFace<Real> face2 = crystal_face(medium2, frame);
        detail::list_decaying(modes, Side::transmitted, frame, crystal_roots(face2, incidence.gap(medium2.n), Real(1)));
    } else if (!medium2.is_complex()) {
        const Complex<Real> q2 = conductor_q(incidence.index, medium2.n, Real(0), frame.q);
        for (int i = 0; i < 2 && q2.im != Real(0); ++i) {
            modes.push_back({Side::transmitted, WaveKind::pair, i, frame.tangential, q2.im * normal});
        }
    }
    return modes;
}

}  // namespace pol
