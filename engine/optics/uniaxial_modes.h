// SPDX-License-Identifier: Apache-2.0
// The ordinary and extraordinary waves of a uniaxial crystal at a boundary (PHYSICS.md 2.5).
//
// In the frame of incidence k = (k_t, 0, q), with permittivities eps_o = n_o^2 across the optic axis c and eps_e =
// n_e^2 along it.
//     o: k.k = eps_o,               E along k x c,           ray along k
//     e: k.eps k = eps_o eps_e,     H along k x c,           ray along eps k
// An e wave is normalised by its unit H = w, so D = w x k and E = eps^-1 D: no difference that cancels near the axis,
// where the textbook form eps_o c - k (k.c) vanishes. Roots are told apart by the sign of n.eps k, which is the sign of
// the energy flux, never by the sign of q.
#pragma once

#include <cmath>
#include <limits>

#include "core/complex.h"
#include "core/vec.h"
#include "optics/dielectric.h"
#include "optics/incidence_frame.h"
#include "optics/wave.h"

namespace pol {

/// Squared magnitude and conjugate of a real number: formulas below run over real and complex numbers.
template <class Real>
requires(!requires(Real z) { z.im; }) constexpr Real norm2(const Real& a) {
    return a * a;
}

/// Components (x, s, normal) in the frame of incidence, real or complex (GLM's vectors hold real numbers only).
template <class Scalar>
struct LocalVector {
    Scalar x{};
    Scalar y{};
    Scalar z{};
};

/// A uniaxial crystal seen from a boundary.
template <class Real>
struct CrystalFace {
    Vec3<Real> axis{};  ///< c in the frame of incidence
    Real eps_o{};
    Real eps_e{};
    Real delta{};   ///< eps_e - eps_o, from the difference of the indices
    Real per_oe{};  ///< 1/(eps_o eps_e)
    Real k_t{};
    Real normal_eps{};      ///< A = n.eps n
    Real tangential_eps{};  ///< B = k_t.eps n
};

template <class Real>
CrystalFace<Real> crystal_face(const Dielectric<Real>& crystal, const IncidenceFrame<Real>& frame) {
    CrystalFace<Real> face;
    face.axis = frame.to_local(crystal.axis);
    face.eps_o = crystal.n * crystal.n;
    face.eps_e = crystal.n_e * crystal.n_e;
    face.delta = (crystal.n_e - crystal.n) * (crystal.n_e + crystal.n);
    face.per_oe = Real(1) / (face.eps_o * face.eps_e);
    face.k_t = frame.k_t;
    face.normal_eps = face.eps_o + face.delta * face.axis.z * face.axis.z;
    face.tangential_eps = face.delta * face.k_t * face.axis.x * face.axis.z;
    return face;
}

/// k x c for a wave with normal component q.
template <class Scalar, class Real>
LocalVector<Scalar> across_axis(const CrystalFace<Real>& face, const Scalar& q) {
    return {-face.axis.y * q, face.axis.x * q - Scalar(face.k_t * face.axis.z), Scalar(face.k_t * face.axis.y)};
}

/// Normal components of the two waves that leave a boundary into one crystal, and the directions k x c.
///
/// q of an evanescent wave is re + i im with im the decay away from the boundary. `energy_root` is n.eps k of the e
/// wave, proportional to its energy flux; exactly 0 when the wave is critical.
template <class Real>
struct CrystalRoots {
    bool o_propagates = false;
    bool e_propagates = false;
    bool pair = false;  ///< k lies along the optic axis: o and e are one wave with a 2x2 state
    Complex<Real> q_o{};
    Complex<Real> q_e{};
    Real energy_root{};
    Vec3<Real> across_o{};  ///< set where the wave propagates
    Vec3<Real> across_e{};
};

namespace detail {

template <class Real>
Vec3<Real> real_across_axis(const CrystalFace<Real>& face, const Real& q) {
    const LocalVector<Real> across = across_axis(face, q);
    return {across.x, across.y, across.z};
}

/// True if |k x c| is all rounding.
template <class Real>
bool along_axis(const Vec3<Real>& across, const Real& k2) {
    const Real noise = Real(8) * std::numeric_limits<Real>::epsilon();
    return length2(across) <= noise * noise * k2;
}

/// k x c of a wave whose q differs by `step` from that of a wave with `across`: both share the rounding of `across`, so
/// that o and e fields stay perpendicular however near the axis.
template <class Real>
Vec3<Real> step_across(const CrystalFace<Real>& face, const Vec3<Real>& across, const Real& step) {
    return {across.x - step * face.axis.y, across.y + step * face.axis.x, across.z};
}

}  // namespace detail

/// Waves that leave the boundary to the side `direction` (+1: along the normal, -1: against it).
/// `gap_o` = eps_o - k_t^2, best formed from the incident wave (see boundary_solver.h).
template <class Real>
CrystalRoots<Real> crystal_roots(const CrystalFace<Real>& face, const Real& gap_o, const Real& direction) {
    using std::sqrt;
    CrystalRoots<Real> roots;
    const Vec3<Real>& c = face.axis;
    const Real sideways = face.k_t * c.y;
    // Discriminant of A q^2 + 2 B q + (k_t.eps k_t - eps_o eps_e) without cancelling squares.
    const Real discriminant =
        face.eps_o * (face.eps_e * (gap_o + face.delta * c.z * c.z) + face.delta * sideways * sideways);
    roots.o_propagates = gap_o >= Real(0);
    roots.e_propagates = discriminant >= Real(0);
    const Real per_a = Real(1) / face.normal_eps;
    if (roots.o_propagates) {
        roots.q_o = Complex<Real>(direction * sqrt(gap_o));
        roots.across_o = detail::real_across_axis(face, roots.q_o.re);
        roots.pair = detail::along_axis(roots.across_o, face.eps_o);
    } else {
        roots.q_o = Complex<Real>(Real(0), direction * sqrt(-gap_o));
    }
    if (!roots.e_propagates) {
        roots.q_e = Complex<Real>(-face.tangential_eps * per_a, direction * sqrt(-discriminant) * per_a);
        return roots;
    }
    roots.energy_root = direction * sqrt(discriminant);
    if (roots.o_propagates) {
        // The o wave solves the equation of the e wave but for delta |k x c|^2: a step from q_o that stays accurate
        // when both are nearly one.
        const Real o_root = face.normal_eps * roots.q_o.re + face.tangential_eps;
        const bool same_sign = direction * o_root > Real(0);
        const Real step = same_sign ? face.delta * length2(roots.across_o) / (roots.energy_root + o_root)
                                    : (roots.energy_root - o_root) * per_a;
        roots.q_e = Complex<Real>(roots.q_o.re + step);
        roots.across_e = detail::step_across(face, roots.across_o, step);
    } else {
        roots.q_e = Complex<Real>((roots.energy_root - face.tangential_eps) * per_a);
        roots.across_e = detail::real_across_axis(face, roots.q_e.re);
    }
    return roots;
}

/// Waves reflected back into the crystal that an e wave with normal component `q_e` comes from. The reflected e wave
/// has q = -q_e - 2B/A, the other root: taking the root again would lose q at grazing incidence.
template <class Real>
CrystalRoots<Real> crystal_roots_of_reflected_e(const CrystalFace<Real>& face, const Real& q_e) {
    using std::sqrt;
    CrystalRoots<Real> roots;
    const Real incident_root = face.normal_eps * q_e + face.tangential_eps;
    const Real mirrored = -q_e - Real(2) * face.tangential_eps / face.normal_eps;
    roots.e_propagates = true;
    roots.energy_root = -incident_root;
    roots.q_e = Complex<Real>(mirrored);
    roots.across_e = detail::real_across_axis(face, mirrored);
    const Real difference = face.delta * length2(roots.across_e) / face.eps_e;  // q_e^2 - q_o^2
    const Real gap_o = mirrored * mirrored - difference;
    roots.o_propagates = gap_o >= Real(0);
    if (roots.o_propagates) {
        const Real q_o = -sqrt(gap_o);
        const Real step = mirrored < Real(0) ? -difference / (q_o + mirrored) : q_o - mirrored;
        roots.q_o = Complex<Real>(q_o);
        roots.across_o = detail::step_across(face, roots.across_e, step);
        roots.pair = detail::along_axis(roots.across_o, face.eps_o);
    } else {
        roots.q_o = Complex<Real>(Real(0), -sqrt(-gap_o));
    }
    return roots;
}

/// One mode in the frame of incidence: E, tangential H = k x E, and the energy flux |Re(E x H*).n| (0 if evanescent).
/// Scalar is Real if no wave at the boundary is evanescent, Complex<Real> otherwise.
template <class Real, class Scalar>
struct LocalMode {
    LocalVector<Scalar> e{};
    Scalar h_x{};
    Scalar h_y{};
    Real flux{};
};

namespace detail {

template <class Real>
Real as_scalar(const Complex<Real>& z, const Real&) {
    return z.re;
}
template <class Real>
Complex<Real> as_scalar(const Complex<Real>& z, const Complex<Real>&) {
    return z;
}

/// v over its Hermitian norm.
template <class Real, class Scalar>
LocalVector<Scalar> normalised(const LocalVector<Scalar>& v) {
    using std::sqrt;
    const Real scale = Real(1) / sqrt(norm2(v.x) + norm2(v.y) + norm2(v.z));
    return {v.x * scale, v.y * scale, v.z * scale};
}

template <class Real, class Scalar>
LocalVector<Scalar> axis_direction(const CrystalFace<Real>& face, const Scalar& q, const Vec3<Real>& across,
                                   bool propagates) {
    if (propagates) {
        const Vec3<Real> w = unit(across);
        return {Scalar(w.x), Scalar(w.y), Scalar(w.z)};
    }
    return normalised<Real, Scalar>(across_axis(face, q));
}

}  // namespace detail

/// o mode with unit E.
template <class Real, class Scalar>
LocalMode<Real, Scalar> ordinary_mode(const CrystalFace<Real>& face, const CrystalRoots<Real>& roots) {
    const Scalar q = detail::as_scalar(roots.q_o, Scalar{});
    const LocalVector<Scalar> w = detail::axis_direction(face, q, roots.across_o, roots.o_propagates);
    const Real flux = roots.o_propagates ? roots.q_o.re : Real(0);
    return {w, -(q * w.y), q * w.x - face.k_t * w.z, flux < Real(0) ? -flux : flux};
}

/// e mode with unit H.
template <class Real, class Scalar>
LocalMode<Real, Scalar> extraordinary_mode(const CrystalFace<Real>& face, const CrystalRoots<Real>& roots) {
    const Scalar q = detail::as_scalar(roots.q_e, Scalar{});
    const LocalVector<Scalar> w = detail::axis_direction(face, q, roots.across_e, roots.e_propagates);
    const Vec3<Real>& c = face.axis;
    const LocalVector<Scalar> d = {q * w.y, face.k_t * w.z - q * w.x, -(face.k_t * w.y)};
    const Scalar along = (c.x * d.x + c.y * d.y + c.z * d.z) * (face.delta * face.per_oe);
    const Real per_o = face.eps_e * face.per_oe;
    const LocalVector<Scalar> e = {d.x * per_o - along * c.x, d.y * per_o - along * c.y, d.z * per_o - along * c.z};
    const Real flux = roots.energy_root * face.per_oe;  // 0 if evanescent
    return {e, w.x, w.y, flux < Real(0) ? -flux : flux};
}

/// s (first) or p mode of a pair with |k| = n, unit E.
template <class Real, class Scalar>
LocalMode<Real, Scalar> s_mode(const Real& q) {
    return {{Scalar(Real(0)), Scalar(Real(1)), Scalar(Real(0))}, Scalar(-q), Scalar(Real(0)), q < Real(0) ? -q : q};
}
template <class Real, class Scalar>
LocalMode<Real, Scalar> p_mode(const Real& n, const Real& k_t, const Real& q) {
    return {{Scalar(-q / n), Scalar(Real(0)), Scalar(k_t / n)}, Scalar(Real(0)), Scalar(-n), q < Real(0) ? -q : q};
}

/// Direction of energy flow of an e wave: unit(eps k).
template <class Real>
Vec3<Real> extraordinary_ray(const Dielectric<Real>& crystal, const Vec3<Real>& k) {
    const Real delta = (crystal.n_e - crystal.n) * (crystal.n_e + crystal.n);
    return unit(crystal.n * crystal.n * k + (delta * dot(k, crystal.axis)) * crystal.axis);
}

/// The waves with a given wave normal in a medium: one pair (isotropic, or along the optic axis), or o and e.
template <class Real>
struct WavesOfNormal {
    Wave<Real> wave[2]{};
    int count = 0;
};

/// Requires: `s` is unit, the medium is not a conductor.
template <class Real>
WavesOfNormal<Real> waves_of_wave_normal(const Dielectric<Real>& medium, const Vec3<Real>& s) {
    using std::sqrt;
    const Vec3<Real> across = cross(s, medium.axis);
    WavesOfNormal<Real> waves;
    if (medium.kind != MediumKind::uniaxial || detail::along_axis(across, Real(1))) {
        const Vec3<Real> a = any_perpendicular(s);
        waves.wave[0] = {WaveKind::pair, medium.n * s, s, {a, cross(s, a)}};
        waves.count = 1;
        return waves;
    }
    // Near the axis the cross product is largely rounding: what of it lies along s must go, or E is not transverse.
    const Vec3<Real> rough = unit(across);
    const Vec3<Real> w = unit(rough - dot(rough, s) * s);
    const Real delta = (medium.n_e - medium.n) * (medium.n_e + medium.n);
    const Real cosine = dot(s, medium.axis);
    const Real eps_o = medium.n * medium.n;
    const Real n_wave = medium.n * medium.n_e / sqrt(eps_o + delta * cosine * cosine);
    const Vec3<Real> d = cross(w, s);
    const Vec3<Real> e = medium.n_e * medium.n_e * d - (delta * dot(d, medium.axis)) * medium.axis;
    waves.wave[0] = {WaveKind::ordinary, medium.n * s, s, {w, Vec3<Real>{}}};
    waves.wave[1] = {WaveKind::extraordinary, n_wave * s, extraordinary_ray(medium, s), {unit(e), Vec3<Real>{}}};
    waves.count = 2;
    return waves;
}

}  // namespace pol
