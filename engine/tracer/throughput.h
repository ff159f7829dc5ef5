// SPDX-License-Identifier: Apache-2.0
// The 2x2 (or, for a crystal mode, 2x1) matrix that takes field amplitudes at a ray to the camera.
#pragma once

#include <cmath>

#include "core/complex.h"
#include "core/vec.h"
#include "polarization/coherence_matrix.h"
#include "polarization/stokes.h"

namespace pol {

/// m[row][column]: camera axis (0 = x, 1 = y) times field vector of the ray. A crystal mode uses column 0 only.
/// Amplitudes are flux-normalised, so |M a|^2 is basic radiance (physics.md 2.3, 2.8).
struct Throughput {
    Complex<double> m[2][2]{};

    static Throughput identity() {
        Throughput t;
        t.m[0][0] = t.m[1][1] = Complex<double>(1.0);
        return t;
    }

    /// w = tr(M^H M)/2: the share of the pixel that unpolarized light on this ray can bring.
    [[nodiscard]] double weight() const {
        return 0.5 * ((norm2(m[0][0]) + norm2(m[1][0])) + (norm2(m[0][1]) + norm2(m[1][1])));
    }

    void scale(double factor) {
        for (auto& row : m)
            for (auto& element : row) element = element * factor;
    }

    /// What is left of a matrix of this weight when nothing but the weight is kept: light from here gives the camera
    /// the same S0 whatever its polarization.
    [[nodiscard]] static Throughput of_weight(double weight, int mode_count) {
        const Complex<double> amplitude(std::sqrt(weight));
        Throughput t;
        t.m[0][0] = amplitude;
        t.m[1][mode_count - 1] = amplitude;
        return t;
    }

    /// Stokes vector at the camera of unpolarized light with S0 = 1 on a pair of modes, or with 1/2 on a single mode.
    [[nodiscard]] Stokes<double> unpolarized() const {
        const double xx = 0.5 * (norm2(m[0][0]) + norm2(m[0][1]));
        const double yy = 0.5 * (norm2(m[1][0]) + norm2(m[1][1]));
        const Complex<double> xy = m[0][0] * conj(m[1][0]) + m[0][1] * conj(m[1][1]);  // 2 J_xy
        return {xx + yy, xx - yy, xy.re, xy.im};
    }

    /// Stokes vector at the camera of light with coherence matrix `source` in the ray's field basis: M J M^H.
    [[nodiscard]] Stokes<double> gather(const CoherenceMatrix<double>& source) const {
        // rows of M J
        Complex<double> mj[2][2];
        for (int row = 0; row < 2; ++row) {
            mj[row][0] = m[row][0] * source.xx + m[row][1] * conj(source.xy);
            mj[row][1] = m[row][0] * source.xy + m[row][1] * source.yy;
        }
        const Complex<double> xx = mj[0][0] * conj(m[0][0]) + mj[0][1] * conj(m[0][1]);
        const Complex<double> yy = mj[1][0] * conj(m[1][0]) + mj[1][1] * conj(m[1][1]);
        const Complex<double> xy = mj[0][0] * conj(m[1][0]) + mj[0][1] * conj(m[1][1]);
        return {xx.re + yy.re, xx.re - yy.re, 2.0 * xy.re, 2.0 * xy.im};
    }
};

/// M rewritten for new field vectors of the same ray: column j = sum_i M_i (old_i . new_j).
/// Requires: both bases span the plane across the ray.
inline Throughput in_basis(const Throughput& t, const DVec3 (&old_field)[2], const DVec3& new_x, const DVec3& new_y) {
    const double xx = dot(old_field[0], new_x);
    const double yx = dot(old_field[1], new_x);
    const double xy = dot(old_field[0], new_y);
    const double yy = dot(old_field[1], new_y);
    Throughput out;
    for (int row = 0; row < 2; ++row) {
        out.m[row][0] = t.m[row][0] * xx + t.m[row][1] * yx;
        out.m[row][1] = t.m[row][0] * xy + t.m[row][1] * yy;
    }
    return out;
}

}  // namespace pol
