// SPDX-License-Identifier: Apache-2.0
// The 2x2 (or, for a crystal mode, 2x1) matrix that takes field amplitudes at a ray to the camera.
#pragma once

#include <cmath>
#include <cstddef>

#include "core/complex.h"
#include "core/vec.h"
#include "optics/boundary.h"
#include "polarization/coherence_matrix.h"
#include "polarization/jones.h"
#include "polarization/stokes.h"

namespace pol {

/// m[row][column]: camera axis (0 = x, 1 = y) times field vector of the ray. A crystal mode uses column 0 only.
/// Amplitudes are flux-normalised, so |M a|^2 is basic radiance (PHYSICS.md 2.3, 2.8).
template <class Real>
struct Throughput {
    JonesMatrix<Real> m;

    static Throughput identity() {
        Throughput t;
        t.m = JonesMatrix<Real>::identity();
        return t;
    }

    /// w = tr(M^H M)/2: the share of the pixel that unpolarized light on this ray can bring.
    [[nodiscard]] Real weight() const {
        return Real(0.5) * ((norm2(m[0][0]) + norm2(m[1][0])) + (norm2(m[0][1]) + norm2(m[1][1])));
    }

    void scale(const Real& factor) {
        for (auto& row : m)
            for (auto& element : row) element = element * factor;
    }

    /// What is left of a matrix of this weight when nothing but the weight is kept: light from here gives the camera
    /// the same S0 whatever its polarization.
    [[nodiscard]] static Throughput of_weight(const Real& weight, int mode_count) {
        using std::sqrt;
        const Complex<Real> amplitude(sqrt(weight));
        Throughput t;
        t.m[0][0] = amplitude;
        t.m[1][mode_count - 1] = amplitude;
        return t;
    }

    /// Stokes vector at the camera of unpolarized light with S0 = 1 on a pair of modes, or with 1/2 on a single mode.
    [[nodiscard]] Stokes<Real> unpolarized() const {
        const Real xx = Real(0.5) * (norm2(m[0][0]) + norm2(m[0][1]));
        const Real yy = Real(0.5) * (norm2(m[1][0]) + norm2(m[1][1]));
        const Complex<Real> xy = m[0][0] * conj(m[1][0]) + m[0][1] * conj(m[1][1]);  // 2 J_xy
        return {xx + yy, xx - yy, xy.re, xy.im};
    }

    /// Stokes vector at the camera of light with coherence matrix `source` in the ray's field basis: M J M^H.
    [[nodiscard]] Stokes<Real> gather(const CoherenceMatrix<Real>& source) const {
        // rows of M J
        Complex<Real> mj[2][2];
        for (int row = 0; row < 2; ++row) {
            mj[row][0] = m[row][0] * source.xx + m[row][1] * conj(source.xy);
            mj[row][1] = m[row][0] * source.xy + m[row][1] * source.yy;
        }
        const Complex<Real> xx = mj[0][0] * conj(m[0][0]) + mj[0][1] * conj(m[0][1]);
        const Complex<Real> yy = mj[1][0] * conj(m[1][0]) + mj[1][1] * conj(m[1][1]);
        const Complex<Real> xy = mj[0][0] * conj(m[1][0]) + mj[0][1] * conj(m[1][1]);
        return {xx.re + yy.re, xx.re - yy.re, Real(2) * xy.re, Real(2) * xy.im};
    }
};

/// M rewritten for new field vectors of the same ray: column j = sum_i M_i (old_i . new_j).
/// Requires: both bases span the plane across the ray.
/// `inline`: without the word GCC 12 calls it, which costs the glass kernel 5 %.
template <class Real>
inline Throughput<Real> in_basis(const Throughput<Real>& t, const Vec3<Real> (&old_field)[2], const Vec3<Real>& new_x,
                                 const Vec3<Real>& new_y) {
    const Real xx = dot(old_field[0], new_x);
    const Real yx = dot(old_field[1], new_x);
    const Real xy = dot(old_field[0], new_y);
    const Real yy = dot(old_field[1], new_y);
    Throughput<Real> out;
    for (int row = 0; row < 2; ++row) {
        out.m[row][0] = t.m[row][0] * xx + t.m[row][1] * yx;
        out.m[row][1] = t.m[row][0] * xy + t.m[row][1] * yy;
    }
    return out;
}

/// M on a wave that leaves a boundary. `m` is written for the incident waves of the response (incident_field).
template <class Real>
Throughput<Real> on_wave(const Throughput<Real>& m, const OutgoingWave<Real>& wave, int incident_modes) {
    Throughput<Real> out;
    for (int row = 0; row < 2; ++row)
        for (int mode = 0; mode < wave.wave.mode_count(); ++mode) {
            const auto& a = wave.amplitude[static_cast<std::size_t>(mode)];
            out.m[row][mode] = m.m[row][0] * a[0];
            if (incident_modes == 2) out.m[row][mode] += m.m[row][1] * a[1];
        }
    return out;
}

/// M behind a thin sheet, for the same field vectors.
template <class Real>
Throughput<Real> behind_sheet(const Throughput<Real>& t, const JonesMatrix<Real>& jones) {
    Throughput<Real> out;
    for (int row = 0; row < 2; ++row)
        for (std::size_t column = 0; column < 2; ++column)
            out.m[row][column] = t.m[row][0] * jones[0][column] + t.m[row][1] * jones[1][column];
    return out;
}

}  // namespace pol
