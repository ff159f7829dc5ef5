// SPDX-License-Identifier: Apache-2.0
// The equations of a plane boundary, one function per pair of media
// (PHYSICS.md 2.1 to 2.7). Use respond() of boundary_solver.h.
//
// Isotropic media, transparent or absorbing, and conductors: Fresnel. With a
// crystal on one side, the two amplitudes on the isotropic side are eliminated
// by hand and a 2x2 system in the crystal's amplitudes remains; crystal against
// crystal is a 4x4 system. Systems are real unless a wave is evanescent. What
// is continuous are the tangential fields E_x, E_y, H_x, H_y in the frame of
// incidence.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "optics/boundary.h"
#include "optics/fresnel.h"
#include "optics/incidence_frame.h"
#include "optics/linear_solve.h"
#include "optics/mirror_split.h"
#include "optics/uniaxial_modes.h"

namespace pol {

namespace detail {

/// The incident wave in the frame of incidence.
template <class Real>
struct Incidence {
    IncidenceFrame<Real> frame{};
    Real index{};            ///< |k|
    Real flux{};             ///< energy flux to the boundary of each mode, unit E; absorbing: |q|
    Complex<Real> pair_n{};  ///< index of a pair, complex if it absorbs
    Complex<Real> pair_q{};  ///< normal component of its wave vector; frame.q if lossless
    /// sqrt(Re z/|z|) for the flux z of unit E_s, H_p of a pair: 1 if lossless.
    std::array<Real, 2> flux_factor{Real(1), Real(1)};
    std::array<LocalMode<Real, Real>, 2> mode{};  ///< what the boundary is solved for
    std::size_t modes = 1;
    MirrorSplit<Real> split{};  ///< if done, mode[0] is the rest without the mirror wave's share

    /// n^2 - k_t^2 for an index n on the other side, from the incident q.
    [[nodiscard]] Real gap(const Real& n) const { return (n - index) * (n + index) + frame.q * frame.q; }
};

template <class Scalar, class Real>
LocalMode<Real, Scalar> lifted(const LocalMode<Real, Real>& m) {
    return {{Scalar(m.e.x), Scalar(m.e.y), Scalar(m.e.z)}, Scalar(m.h_x), Scalar(m.h_y), m.flux};
}

/// The two modes that leave into a crystal: s and p of the pair along the optic
/// axis, else o and e.
template <class Scalar, class Real>
std::array<LocalMode<Real, Scalar>, 2> crystal_modes(const Dielectric<Real>& crystal, const CrystalFace<Real>& face,
                                                     const CrystalRoots<Real>& roots) {
    if (roots.pair) {
        return {s_mode<Real, Scalar>(roots.q_o.re), p_mode<Real, Scalar>(crystal.n, face.k_t, roots.q_o.re)};
    }
    return {ordinary_mode<Real, Scalar>(face, roots), extraordinary_mode<Real, Scalar>(face, roots)};
}

template <class Real>
void add_outgoing(BoundaryResponse<Real>& response, const OutgoingWave<Real>& wave) {
    response.outgoing[static_cast<std::size_t>(response.outgoing_count++)] = wave;
}

/// True if no mode of the wave takes anything, exactly.
template <class Real>
bool carries_nothing(const OutgoingWave<Real>& wave) {
    const Complex<Real> nothing;
    for (const auto& row : wave.amplitude) {
        if (!(row[0] == nothing) || !(row[1] == nothing)) return false;
    }
    return true;
}

/// A pair with |k| = n; `ray` is k/n.
template <class Real>
Wave<Real> pair_wave(const Vec3<Real>& k, const Real& n, const Vec3<Real>& s) {
    const Vec3<Real> direction = k * (Real(1) / n);
    return {WaveKind::pair, k, direction, {s, cross(direction, s)}};
}

/// Amplitudes of the two outgoing modes of one side, per incident mode:
/// amplitude[column][mode].
template <class Scalar>
using Amplitudes = std::array<std::array<Scalar, 2>, 2>;

template <class Real, class Scalar>
void add_crystal_waves(BoundaryResponse<Real>& response, Side side, const Dielectric<Real>& crystal,
                       const Incidence<Real>& incidence, const CrystalRoots<Real>& roots,
                       const std::array<LocalMode<Real, Scalar>, 2>& modes, const Amplitudes<Scalar>& amplitude) {
    using std::sqrt;
    const IncidenceFrame<Real>& frame = incidence.frame;
    std::array<Real, 2> scale;
    for (std::size_t i = 0; i < 2; ++i) scale[i] = sqrt(modes[i].flux / incidence.flux);
    if (roots.pair) {
        OutgoingWave<Real> out{side, pair_wave(frame.wave_vector(roots.q_o.re), crystal.n, frame.s), {}};
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < incidence.modes; ++j) out.amplitude[i][j] = amplitude[j][i] * scale[i];
        }
        add_outgoing(response, out);
        return;
    }
    for (std::size_t i = 0; i < 2; ++i) {
        if (!(i == 0 ? roots.o_propagates : roots.e_propagates)) continue;
        OutgoingWave<Real> out;
        out.side = side;
        for (std::size_t j = 0; j < incidence.modes; ++j) out.amplitude[0][j] = amplitude[j][i] * scale[i];
        const LocalVector<Scalar>& e = modes[i].e;
        Vec3<Real> field;
        if constexpr (std::is_same_v<Scalar, Real>) {
            field = frame.to_world({e.x, e.y, e.z});
        } else {
            field = frame.to_world({e.x.re, e.y.re, e.z.re});
        }
        Wave<Real>& wave = out.wave;
        wave.kind = i == 0 ? WaveKind::ordinary : WaveKind::extraordinary;
        wave.k = frame.wave_vector(i == 0 ? roots.q_o.re : roots.q_e.re);
        wave.ray = i == 0 ? wave.k * (Real(1) / crystal.n) : extraordinary_ray(crystal, wave.k);
        wave.field[0] = i == 0 ? field : unit(field);
        add_outgoing(response, out);
    }
}

/// The waves reflected into the crystal of the incident wave, less the mirror
/// wave's share.
template <class Real, class Scalar>
void add_reflected(BoundaryResponse<Real>& response, const Dielectric<Real>& crystal, const Incidence<Real>& incidence,
                   const CrystalRoots<Real>& roots, const std::array<LocalMode<Real, Scalar>, 2>& modes,
                   Amplitudes<Scalar> amplitude) {
    if (incidence.split.done) {
        Scalar& mirror = amplitude[0][incidence.split.mirror];
        mirror = mirror - Scalar(incidence.split.share);
    }
    add_crystal_waves(response, Side::reflected, crystal, incidence, roots, modes, amplitude);
}

template <class Real>
void add_pair(BoundaryResponse<Real>& response, Side side, const IncidenceFrame<Real>& frame, const Real& q,
              const Real& n, const JonesMatrix<Real>& amplitude) {
    add_outgoing(response, OutgoingWave<Real>{side, pair_wave(frame.wave_vector(q), n, frame.s), amplitude});
}

/// Isotropic to isotropic or conductor.
template <class Real>
void meet_isotropic(BoundaryResponse<Real>& response, const Incidence<Real>& incidence,
                    const Dielectric<Real>& medium2) {
    using std::sqrt;
    const IncidenceFrame<Real>& frame = incidence.frame;
    const Complex<Real> zero;
    if (incidence.pair_n.im != Real(0) || medium2.is_complex()) {
        const AbsorbingFresnel<Real> f =
            absorbing_fresnel(incidence.pair_n, {medium2.n, medium2.kappa}, incidence.index, frame.q);
        add_pair<Real>(response, Side::reflected, frame, -frame.q, incidence.index, {{{f.r_s, zero}, {zero, f.r_p}}});
        response.absorption = {{{Complex<Real>(f.mixed_s), zero}, {zero, Complex<Real>(f.mixed_p)}}};
        response.absorbs = true;
        if (f.goes_on && medium2.kind == MediumKind::isotropic) {
            add_pair<Real>(response, Side::transmitted, frame, f.q2.re, sqrt(frame.k_t * frame.k_t + f.q2.re * f.q2.re),
                           {{{f.t_s, zero}, {zero, f.t_p}}});
        } else {
            response.absorption[0][0].re += f.into_s;
            response.absorption[1][1].re += f.into_p;
        }
        return;
    }
    const Fresnel<Real> f = fresnel(incidence.index, medium2.n, frame.q);
    add_pair<Real>(response, Side::reflected, frame, -frame.q, incidence.index, {{{f.r_s, zero}, {zero, f.r_p}}});
    if (f.total) return;
    add_pair<Real>(response, Side::transmitted, frame, f.q2, medium2.n,
                   {{{Complex<Real>(f.t_s), zero}, {zero, Complex<Real>(f.t_p)}}});
}

/// Isotropic to crystal. With the reflected amplitudes eliminated, the
/// transmitted ones are q u, where
///     sum_j u_j (q E_y - H_x)_j = 2 a_s,     sum_j u_j (n^2 E_x + q H_y)_j =
///     -2 n a_p,
/// and the reflected b_s = 1/2 sum u_j (q E_y + H_x)_j, b_p = 1/2 sum u_j (n
/// E_x - (q/n) H_y)_j: no division by q. In an absorbing medium n and q are
/// complex, and powers of incident and reflected waves are not independent.
template <class Scalar, class Real>
void enter_crystal(BoundaryResponse<Real>& response, const Incidence<Real>& incidence, const Dielectric<Real>& crystal,
                   const CrystalFace<Real>& face, const CrystalRoots<Real>& roots) {
    const std::array<LocalMode<Real, Scalar>, 2> modes = crystal_modes<Scalar>(crystal, face, roots);
    const Scalar q = as_scalar(incidence.pair_q, Scalar{});
    const Scalar n = as_scalar(incidence.pair_n, Scalar{});
    std::array<std::array<Scalar, 2>, 2> m;
    for (std::size_t j = 0; j < 2; ++j) {
        m[0][j] = modes[j].e.y * q - modes[j].h_x;
        m[1][j] = modes[j].e.x * (n * n) + modes[j].h_y * q;
    }
    const Scalar zero(Real(0));
    Amplitudes<Scalar> u = {{{Scalar(Real(2)), zero}, {zero, Real(-2) * n}}};
    solve_2x2(m, u, 2);
    JonesMatrix<Real> reflected;
    for (std::size_t c = 0; c < 2; ++c) {
        Scalar b_s = zero;
        Scalar b_p = zero;
        for (std::size_t j = 0; j < 2; ++j) {
            b_s = b_s + u[c][j] * (modes[j].e.y * q + modes[j].h_x);
            b_p = b_p + u[c][j] * (modes[j].e.x * n - modes[j].h_y * (q / n));
        }
        const Real per_in = Real(1) / incidence.flux_factor[c];
        reflected[0][c] = Complex<Real>(b_s) * (incidence.flux_factor[0] * per_in) / Real(2);
        reflected[1][c] = Complex<Real>(b_p) * (incidence.flux_factor[1] * per_in) / Real(2);
        for (std::size_t j = 0; j < 2; ++j) u[c][j] = u[c][j] * q * per_in;
    }
    add_pair(response, Side::reflected, incidence.frame, -incidence.frame.q, incidence.index, reflected);
    add_crystal_waves(response, Side::transmitted, crystal, incidence, roots, modes, u);
    if (incidence.pair_n.im == Real(0)) return;
    // As mixed_s, mixed_p of AbsorbingFresnel, for a reflection that turns s into p.
    const Complex<Real> y = incidence.pair_q * conj(incidence.pair_n * incidence.pair_n);
    const std::array<Real, 2> loss{incidence.pair_q.im / incidence.pair_q.re, y.im / y.re};
    const Complex<Real> i(Real(0), Real(1));
    for (std::size_t a = 0; a < 2; ++a) {
        for (std::size_t b = 0; b < 2; ++b) {
            response.absorption[a][b] = i * (reflected[a][b] * loss[a] - conj(reflected[b][a]) * loss[b]);
        }
    }
    response.absorbs = true;
}

/// Crystal to isotropic dielectric or conductor with normal wave vector
/// component `q2` and permittivity `eps2`. With the transmitted b_s = E_y, b_p
/// = -H_y/n2 eliminated, the total field on the crystal's side obeys
///     q2 E_y + H_x = 0,     eps2 E_x - q2 H_y = 0.
template <class Scalar, class Real>
void leave_crystal(BoundaryResponse<Real>& response, const Incidence<Real>& incidence, const Dielectric<Real>& crystal,
                   const CrystalFace<Real>& face, const CrystalRoots<Real>& roots, const Dielectric<Real>& medium2,
                   const Complex<Real>& q2_complex, const Complex<Real>& eps2_complex) {
    using std::sqrt;
    const std::array<LocalMode<Real, Scalar>, 2> modes = crystal_modes<Scalar>(crystal, face, roots);
    const Scalar q2 = as_scalar(q2_complex, Scalar{});
    const Scalar eps2 = as_scalar(eps2_complex, Scalar{});
    std::array<std::array<Scalar, 2>, 2> m;
    for (std::size_t j = 0; j < 2; ++j) {
        m[0][j] = q2 * modes[j].e.y + modes[j].h_x;
        m[1][j] = eps2 * modes[j].e.x - q2 * modes[j].h_y;
    }
    Amplitudes<Scalar> a{};
    for (std::size_t c = 0; c < incidence.modes; ++c) {
        const LocalMode<Real, Scalar> in = lifted<Scalar>(incidence.mode[c]);
        a[c] = {-(q2 * in.e.y + in.h_x), q2 * in.h_y - eps2 * in.e.x};
    }
    solve_2x2(m, a, static_cast<int>(incidence.modes));
    add_reflected(response, crystal, incidence, roots, modes, a);

    const bool goes_on = medium2.kind == MediumKind::isotropic && q2_complex.re >= q2_complex.im;
    if (!goes_on && !medium2.is_complex()) return;
    JonesMatrix<Real> inside{};  // E_y and H_y behind the boundary, per incident mode
    for (std::size_t c = 0; c < incidence.modes; ++c) {
        Scalar e_y = Scalar(incidence.mode[c].e.y);
        Scalar h_y = Scalar(incidence.mode[c].h_y);
        for (std::size_t j = 0; j < 2; ++j) {
            e_y = e_y + a[c][j] * modes[j].e.y;
            h_y = h_y + a[c][j] * modes[j].h_y;
        }
        inside[0][c] = Complex<Real>(e_y);
        inside[1][c] = Complex<Real>(h_y);
    }
    const Complex<Real> n2(medium2.n, medium2.kappa);
    if (!goes_on) {
        const Real weight_s = q2_complex.re / incidence.flux;
        const Real weight_p = (q2_complex * conj(eps2_complex)).re / (norm2(eps2_complex) * incidence.flux);
        for (std::size_t i = 0; i < incidence.modes; ++i) {
            for (std::size_t j = 0; j < incidence.modes; ++j) {
                response.absorption[i][j] =
                    conj(inside[0][i]) * inside[0][j] * weight_s + conj(inside[1][i]) * inside[1][j] * weight_p;
            }
        }
        response.absorbs = true;
        return;
    }
    const Real scale = sqrt(q2_complex.re / incidence.flux);
    Real length = medium2.n;
    Complex<Real> to_p(-scale / medium2.n);
    if (medium2.kappa != Real(0)) {  // |to_p|^2 = Re(q2/eps2)/flux, with the phase of E_p as AbsorbingFresnel has it
        const Real k_t = incidence.frame.k_t;
        length = sqrt(k_t * k_t + q2_complex.re * q2_complex.re);
        const Real size2 = (q2_complex * conj(eps2_complex)).re / (norm2(eps2_complex) * incidence.flux);
        to_p = conj(n2) * -sqrt(size2 / norm2(n2));
    }
    for (std::size_t c = 0; c < incidence.modes; ++c) {
        inside[0][c] = inside[0][c] * scale;
        inside[1][c] = inside[1][c] * to_p;
    }
    add_pair(response, Side::transmitted, incidence.frame, q2_complex.re, length, inside);
}

/// Crystal to crystal: tangential E and H of incident and reflected waves equal
/// those of the transmitted waves.
template <class Scalar, class Real>
void cross_crystals(BoundaryResponse<Real>& response, const Incidence<Real>& incidence,
                    const Dielectric<Real>& crystal1, const CrystalFace<Real>& face1, const CrystalRoots<Real>& roots1,
                    const Dielectric<Real>& crystal2, const CrystalFace<Real>& face2,
                    const CrystalRoots<Real>& roots2) {
    const std::array<LocalMode<Real, Scalar>, 2> back = crystal_modes<Scalar>(crystal1, face1, roots1);
    const std::array<LocalMode<Real, Scalar>, 2> on = crystal_modes<Scalar>(crystal2, face2, roots2);
    std::array<std::array<Scalar, 6>, 4> rows;
    for (std::size_t j = 0; j < 2; ++j) {
        rows[0][j] = back[j].e.x;
        rows[1][j] = back[j].e.y;
        rows[2][j] = back[j].h_x;
        rows[3][j] = back[j].h_y;
        rows[0][2 + j] = -on[j].e.x;
        rows[1][2 + j] = -on[j].e.y;
        rows[2][2 + j] = -on[j].h_x;
        rows[3][2 + j] = -on[j].h_y;
    }
    for (std::size_t c = 0; c < incidence.modes; ++c) {
        const LocalMode<Real, Real>& in = incidence.mode[c];
        rows[0][4 + c] = Scalar(-in.e.x);
        rows[1][4 + c] = Scalar(-in.e.y);
        rows[2][4 + c] = Scalar(-in.h_x);
        rows[3][4 + c] = Scalar(-in.h_y);
    }
    if (incidence.modes == 1) {
        solve_4x4<1>(rows);
    } else {
        solve_4x4<2>(rows);
    }
    Amplitudes<Scalar> reflected{};
    Amplitudes<Scalar> transmitted{};
    for (std::size_t c = 0; c < incidence.modes; ++c) {
        reflected[c] = {rows[0][4 + c], rows[1][4 + c]};
        transmitted[c] = {rows[2][4 + c], rows[3][4 + c]};
    }
    add_reflected(response, crystal1, incidence, roots1, back, reflected);
    add_crystal_waves(response, Side::transmitted, crystal2, incidence, roots2, on, transmitted);
}

}  // namespace detail

}  // namespace pol
