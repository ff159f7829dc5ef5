// SPDX-License-Identifier: Apache-2.0
// Solves a plane boundary between any two media for one incident wave.
// boundary.h says what the result means, boundary_systems.h has the equations.
#pragma once

#include <cmath>
#include <cstddef>

#include "core/contract.h"
#include "optics/boundary.h"
#include "optics/boundary_systems.h"

namespace pol {

/// True if a wave cannot tell the media apart: equal constants, optic axes
/// equal but for their sign.
template <class Real>
bool same_matter(const Dielectric<Real>& a, const Dielectric<Real>& b) {
    return a.kind == b.kind && a.n == b.n && a.n_e == b.n_e && a.kappa == b.kappa &&
           (a.axis == b.axis || a.axis == -b.axis);
}

namespace detail {

/// Describes the incident wave; flux <= 0 if it does not come to the boundary.
/// `face` is read for crystal modes only.
template <class Real>
Incidence<Real> describe_incidence(const IncidenceFrame<Real>& frame, const Dielectric<Real>& medium,
                                   const CrystalFace<Real>& face, const Wave<Real>& wave) {
    using std::sqrt;
    Incidence<Real> incidence;
    incidence.frame = frame;
    incidence.flux = frame.q;
    incidence.index = medium.n;
    if (wave.kind == WaveKind::pair) {
        incidence.modes = 2;
        incidence.pair_n = Complex<Real>(medium.n, medium.kappa);
        incidence.pair_q = Complex<Real>(frame.q);
        if (medium.kappa != Real(0) && frame.q > Real(0)) {
            incidence.index = sqrt(length2(wave.k));
            incidence.pair_q = conductor_q(incidence.index, medium.n, medium.kappa, frame.q);
            incidence.flux = abs(incidence.pair_q);
            const Complex<Real> y = incidence.pair_q * conj(incidence.pair_n * incidence.pair_n);
            incidence.flux_factor = {sqrt(incidence.pair_q.re / incidence.flux), sqrt(y.re / abs(y))};
        }
        incidence.mode = {s_mode<Real, Real>(frame.q), p_mode<Real, Real>(medium.n, frame.k_t, frame.q)};
        return incidence;
    }
    const Vec3<Real> e = frame.to_local(wave.field[0]);
    LocalMode<Real, Real>& mode = incidence.mode[0];
    mode.e = {e.x, e.y, e.z};
    mode.h_x = -frame.q * e.y;
    mode.h_y = frame.q * e.x - frame.k_t * e.z;
    if (wave.kind == WaveKind::extraordinary) {
        const Real h_z = frame.k_t * e.y;
        const Real h2 = mode.h_x * mode.h_x + mode.h_y * mode.h_y + h_z * h_z;
        incidence.index = sqrt(length2(wave.k));
        incidence.flux = h2 * (face.normal_eps * frame.q + face.tangential_eps) * face.per_oe;
    }
    return incidence;
}

/// Waves that a boundary reflects back into the crystal of the incident wave.
template <class Real>
CrystalRoots<Real> reflected_roots(const CrystalFace<Real>& face, WaveKind incident, const Real& q) {
    if (incident == WaveKind::extraordinary) return crystal_roots_of_reflected_e(face, q);
    return crystal_roots(face, q * q,
                         Real(-1));  // the root of q^2 is q to the last bit
}

template <class Real>
void respond_from_crystal(BoundaryResponse<Real>& response, Incidence<Real> incidence, WaveKind kind,
                          const Dielectric<Real>& medium1, const CrystalFace<Real>& face1,
                          const Dielectric<Real>& medium2) {
    CrystalRoots<Real> roots1 = reflected_roots(face1, kind, incidence.frame.q);
    if (kind != WaveKind::pair) {
        // To take k along the axis is to turn the axis by a rounding, which changes energy fluxes by that over q: next
        // to the face only if it is a rounding of q.
        roots1.pair = roots1.pair && along_axis(roots1.across_o, roots1.q_o.re * roots1.q_o.re);
    }
    const bool real1 = roots1.o_propagates && roots1.e_propagates;
    incidence.split = split_off_mirror(face1, roots1, kind, incidence.frame.q, incidence.mode[0]);
    if (incidence.split.done) incidence.mode[0] = incidence.split.rest;
    if (medium2.kind == MediumKind::uniaxial) {
        const CrystalFace<Real> face2 = crystal_face(medium2, incidence.frame);
        const CrystalRoots<Real> roots2 = crystal_roots(face2, incidence.gap(medium2.n), Real(1));
        if (real1 && roots2.o_propagates && roots2.e_propagates) {
            cross_crystals<Real>(response, incidence, medium1, face1, roots1, medium2, face2, roots2);
        } else {
            cross_crystals<Complex<Real>>(response, incidence, medium1, face1, roots1, medium2, face2, roots2);
        }
        return;
    }
    const Complex<Real> eps2((medium2.n - medium2.kappa) * (medium2.n + medium2.kappa),
                             Real(2) * medium2.n * medium2.kappa);
    const Complex<Real> q2 = conductor_q(incidence.index, medium2.n, medium2.kappa, incidence.frame.q);
    if (real1 && eps2.im == Real(0) && q2.im == Real(0)) {
        leave_crystal<Real>(response, incidence, medium1, face1, roots1, medium2, q2, eps2);
    } else {
        leave_crystal<Complex<Real>>(response, incidence, medium1, face1, roots1, medium2, q2, eps2);
    }
}

}  // namespace detail

/// As `respond`, but waves that carry exactly nothing stay in the list: for
/// tables.
template <class Real>
BoundaryResponse<Real> respond_in_full(const Dielectric<Real>& medium1, const Dielectric<Real>& medium2,
                                       const Vec3<Real>& normal, const Wave<Real>& incident) {
    POL_EXPECTS(medium1.kind != MediumKind::conductor);
    POL_EXPECTS(medium1.kind == MediumKind::uniaxial || incident.kind == WaveKind::pair);
    BoundaryResponse<Real> response;
    const IncidenceFrame<Real> frame = incidence_frame(normal, incident.k);
    CrystalFace<Real> face1;
    if (medium1.kind == MediumKind::uniaxial) {
        Dielectric<Real> crystal = medium1;
        // A pair's optic axis is its k. The axis as it is given may be a rounding apart, all of q for a grazing wave.
        if (incident.kind == WaveKind::pair) crystal.axis = incident.k * (Real(1) / medium1.n);
        face1 = crystal_face(crystal, frame);
    }
    const detail::Incidence<Real> incidence = detail::describe_incidence(frame, medium1, face1, incident);
    if (!(incidence.flux > Real(0))) return response;
    response.incident = true;
    response.incident_modes = incident.mode_count();
    Wave<Real> wave = incident;
    if (incident.kind == WaveKind::pair) wave = detail::pair_wave(incident.k, incidence.index, frame.s);
    response.incident_field = {wave.field[0], wave.field[1]};
    if (same_matter(medium1, medium2)) {
        OutgoingWave<Real> out{Side::transmitted, wave, {}};
        for (std::size_t i = 0; i < incidence.modes; ++i) out.amplitude[i][i] = Complex<Real>(Real(1));
        detail::add_outgoing(response, out);
        return response;
    }
    if (medium1.kind == MediumKind::uniaxial) {
        detail::respond_from_crystal(response, incidence, incident.kind, medium1, face1, medium2);
    } else if (medium2.kind == MediumKind::uniaxial) {
        const CrystalFace<Real> face2 = crystal_face(medium2, frame);
        const CrystalRoots<Real> roots = crystal_roots(face2, incidence.gap(medium2.n), Real(1));
        if (roots.o_propagates && roots.e_propagates && medium1.kappa == Real(0)) {
            detail::enter_crystal<Real>(response, incidence, medium2, face2, roots);
        } else {
            detail::enter_crystal<Complex<Real>>(response, incidence, medium2, face2, roots);
        }
    } else {
        detail::meet_isotropic(response, incidence, medium2);
    }
    return response;
}

/// All propagating waves that leave the boundary, with flux-normalised
/// amplitudes for each mode of the incident wave.
///
/// `normal` points from medium 1 to medium 2. The wave is incident if it brings
/// energy to the boundary, whatever the sign of k.normal. Media in contact that
/// are the same matter let it pass unchanged, in exactly one child. Exactly
/// critical waves carry exactly nothing and are left out.
///
/// Requires: `normal` is unit; medium 1 is no conductor; `incident` is a wave
/// of medium 1, a pair only where the medium has pairs (isotropic, or k along
/// the optic axis).
template <class Real>
BoundaryResponse<Real> respond(const Dielectric<Real>& medium1, const Dielectric<Real>& medium2,
                               const Vec3<Real>& normal, const Wave<Real>& incident) {
    BoundaryResponse<Real> response = respond_in_full(medium1, medium2, normal, incident);
    int kept = 0;
    for (int i = 0; i < response.outgoing_count; ++i) {
        const OutgoingWave<Real>& wave = response.outgoing[static_cast<std::size_t>(i)];
        if (detail::carries_nothing(wave)) continue;
        if (kept != i) response.outgoing[static_cast<std::size_t>(kept)] = wave;
        ++kept;
    }
    response.outgoing_count = kept;
    return response;
}

}  // namespace pol
