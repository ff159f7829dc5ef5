// SPDX-License-Identifier: Apache-2.0
// A crystal wave that grazes a face from inside, as its own mirror image and a
// small rest.
//
// Near grazing the incident wave and its reflection almost cancel, and what is
// left, all that gets through, would be rounding: at 1e-6 rad ten digits are
// lost. So the incident wave is written as share * mirror + rest, where mirror
// is the reflected wave of the same kind (o or e) and the rest, proportional to
// the difference of their q, follows from k x c = (-c_y q, c_x q - k_t c_z, k_t
// c_y) without a cancelling difference. The boundary is linear: it is solved
// for the rest, and `share` is taken from the reflected amplitude.
//
// Where the wave is nearer to the optic axis than to the face, k x c of the
// mirror wave is another direction and much longer: share and rest would be
// large and cancel. There the wave is left whole: what that costs, eps over the
// angle to the face, is less than eps over the angle to the axis, to which o
// and e are known at all.
#pragma once

#include <cmath>
#include <cstddef>

#include "optics/uniaxial_modes.h"

namespace pol::detail {

template <class Real>
struct MirrorSplit {
    bool done = false;
    std::size_t mirror = 0;  ///< index of the mirror wave: 0 = o, 1 = e
    Real share{};
    LocalMode<Real, Real> rest{};  ///< tangential fields only
};

/// Splits `incident`, a single mode with normal wave vector component `q`, if
/// it is near grazing. `roots` are the waves that the face reflects
/// (crystal_roots with direction -1, or crystal_roots_of_reflected_e).
template <class Real>
MirrorSplit<Real> split_off_mirror(const CrystalFace<Real>& face, const CrystalRoots<Real>& roots, WaveKind kind,
                                   const Real& q, const LocalMode<Real, Real>& incident) {
    using std::sqrt;
    MirrorSplit<Real> split;
    const bool ordinary = kind == WaveKind::ordinary;
    const Real step = ordinary ? Real(2) * q : Real(-2) * roots.energy_root / face.normal_eps;  // q - q of the mirror
    const Real near_grazing = Real(1) / Real(16);
    if (roots.pair || kind == WaveKind::pair || step * step > near_grazing * near_grazing * face.eps_o) return split;

    const Vec3<Real> across = real_across_axis(face, q);
    const Vec3<Real> h(incident.h_x, incident.h_y, face.k_t * incident.e.y);
    const Vec3<Real> along = ordinary ? Vec3<Real>(incident.e.x, incident.e.y, incident.e.z) : h;  // +-unit(k x c)
    const Real size2 = length2(across);
    const Real mirror_size2 = length2(ordinary ? roots.across_o : roots.across_e);
    // Two vectors that differ by |step|, one twice as long as the other: |k x c| is less than |step|.
    if (mirror_size2 >= Real(4) * size2) return split;
    const Real scale = dot(along, across) < Real(0) ? -sqrt(length2(along) / size2) : sqrt(length2(along) / size2);
    const Vec3<Real>& c = face.axis;
    const Real factor = scale * step;
    LocalMode<Real, Real>& rest = split.rest;
    if (ordinary) {
        rest.e = {-(factor * c.y), factor * c.x, Real(0)};
        rest.h_x = factor * face.k_t * c.z;
        rest.h_y = Real(0);
    } else {
        rest.h_x = -(factor * c.y);
        rest.h_y = factor * c.x;
        const Real sum = q + roots.q_e.re;
        const Vec3<Real> d(factor * (c.x * sum - face.k_t * c.z), factor * c.y * sum, -(factor * face.k_t * c.x));
        const Vec3<Real> e = d * (face.eps_e * face.per_oe) - c * (dot(c, d) * face.delta * face.per_oe);
        rest.e = {e.x, e.y, e.z};
    }
    split.done = true;
    split.mirror = ordinary ? 0 : 1;
    split.share = scale * sqrt(mirror_size2);
    return split;
}

}  // namespace pol::detail
