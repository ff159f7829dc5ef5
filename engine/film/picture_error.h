// SPDX-License-Identifier: Apache-2.0
// How far a whole picture may be from the truth: two parts that are never merged into one number.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/hypot.h"

namespace pol {

/// Errors relative to the picture, as `fro_c` measures them (CUTTING.md 3): root mean square over pixels and
/// wavelengths of ||dC||_F by that of ||C||_F, C the coherence matrix, ||C||_F^2 = (S0^2 + S1^2 + S2^2 + S3^2) / 2.
/// Pixels without samples are left out.
struct PictureError {
    bool random_samples = false;  ///< as in FilmLayout
    /// Share of a pixel that was not traced, mean and largest: bounds |dS0| in units of `brightest`.
    double residual_mean = 0.0;
    double residual_max = 0.0;
    /// Upper bound of the error by light that was not traced: ||dC||_F <= residual * brightest in every pixel. Without
    /// random samples (mode point) the light that one random path stands for counts here, too (truncation_bound).
    /// Infinite if light is missing from a picture that is black.
    double truncation = 0.0;
    /// Estimate (68 %) of the error by too few samples, from two independent halves of them; see ErrorSums. 0 in mode
    /// point if nothing was random. Empty where nothing tells it: a pixel has a single sample, no sample has met any
    /// light, or random paths of mode point, of which only the bound above is known.
    std::optional<double> sampling;
    /// How well that is known: relative standard deviation of sampling^2, an upper estimate, from 0 (the error is
    /// spread over many pixels) to 1 (one pixel has all of it).
    double sampling_spread = 0.0;
};

/// Bound of ||dC||_F by light that was not traced (R, trace at most `residual`) and by light that one random path tells
/// (T) in place of the true one (T'), traces at most `tail`; all in units of `brightest`. R, T and T' are positive
/// semidefinite, so that <T, T' + R> >= 0 and
///     ||T - T' - R||_F^2 <= ||T||_F^2 + ||T' + R||_F^2 <= tail^2 + (tail + residual)^2.
inline double truncation_bound(double residual, double tail) {
    return tail > 0.0 ? hypot(tail, tail + residual) : residual;
}

/// What a set of pixels adds to the error of a picture. Sums over pixels and wavelengths.
///
/// Sampling. The even and the odd samples of a pixel are two sets that know nothing of each other (sample_position), so
/// the errors e_A, e_B of their means are independent. Half the difference of the means, h = (m_A - m_B)/2, has the
/// same mean square as the error of the whole, (e_A + e_B)/2: E h^2 = (V_A + V_B)/4, since E e_A e_B = 0. This holds
/// whatever the variances, for quasi-random halves and for random tails, as long as both halves have n samples and at
/// least one of them is without bias. With an odd number of samples, n_A =
/// n_B + 1, the same is true up to 1/n for h = (m_A - m_B) sqrt(n_A n_B)/(n_A + n_B).
///
/// Pixels are independent, so that the variance of the sum of their ||h||^2 is at most the sum of the squares.
///
/// Its limits. In one pixel h^2 has one degree of freedom: |h| is the standard error times a half-normal number, below
/// a tenth of it in 8 of 100 pixels. The sum over P pixels has P of them: its relative standard deviation is
/// sqrt(2 / P_eff), P_eff = (sum V)^2 / sum V^2, for the root half of that; 200 pixels on edges give 5 %. What no
/// sample of a pixel has met (a needle of light) no estimate knows of.
struct ErrorSums {
    double residual = 0.0;
    double residual_max = 0.0;
    double light = 0.0;              ///< of ||C||_F^2
    double missing = 0.0;            ///< of (truncation_bound * brightest)^2
    double count = 0.0;              ///< terms of the sums above
    double half_error = 0.0;         ///< of ||h||_F^2
    double half_error_square = 0.0;  ///< over pixels, of the square of what each adds to half_error
    bool has_single = false;         ///< a pixel has one sample, hence no halves
    bool has_tail = false;           ///< a random path stood for a part of the light

    ErrorSums& operator+=(const ErrorSums& other) {
        residual += other.residual;
        residual_max = std::max(residual_max, other.residual_max);
        light += other.light;
        missing += other.missing;
        count += other.count;
        half_error += other.half_error;
        half_error_square += other.half_error_square;
        has_single = has_single || other.has_single;
        has_tail = has_tail || other.has_tail;
        return *this;
    }
};

/// `random_samples`: as in FilmLayout.
PictureError picture_error(const ErrorSums& sums, bool random_samples);

}  // namespace pol
