// SPDX-License-Identifier: Apache-2.0
// Are two pictures the same, as far as their numbers and error bars can tell?
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "compare/pairing.h"

namespace pol::compare {

/// The differences of one Stokes component against the error bars of both pictures.
///
/// An error bar comes from two halves of the samples: it is itself random, with one degree of freedom. Their mean
/// square over 5 x 5 pixels, or the pixel's own if that is larger, is the standard error here; t is the difference
/// beyond rounding and untraced light in units of it.
struct ComponentSignificance {
    std::size_t values = 0;  ///< that have an error bar
    double largest = 0.0;    ///< t
    std::size_t beyond = 0;  ///< values with t > 3
    /// How many of those chance makes at most: by Student's distribution, its degrees of freedom from the bars.
    double beyond_by_chance = 0.0;
    /// Root mean square of the differences by that of the error bars: 1 if the bars explain them all.
    double ratio = 0.0;
    /// What `ratio` does not exceed by chance (five standard deviations, by the number of pixels that have the errors).
    double largest_ratio = 0.0;

    std::size_t unbarred = 0;  ///< values that differ and have no finite error bar (a single sample)

    [[nodiscard]] bool is_chance() const { return unbarred == 0 && ratio <= largest_ratio; }
};

/// t above which a value counts as beyond its bar.
inline constexpr double significant_t = 3.0;

struct Significance {
    bool a_has_bars = false;
    bool b_has_bars = false;
    std::array<std::optional<ComponentSignificance>, 4> components;  ///< S0 to S3, where both know it

    [[nodiscard]] bool is_chance() const;
};

/// The pixel where the coherence matrices, of the components that both know, are farthest apart.
struct WorstPixel {
    int x = 0;  ///< of the common pictures
    int y = 0;
    std::size_t band = 0;
    double distance = 0.0;  ///< |dC|_F
    Stokes<double> a;
    Stokes<double> b;
};

/// How far apart the pictures are, number by number.
///
/// A number is the same if it differs by no more than both files round it, and no more than both pictures left
/// untraced:
///   |a - b| <= (r_A + r_B) s + (step_A + step_B) / 2 + bound_A + bound_B,
/// r the rounding of a file (StoredNumbers), s the larger of |a| and |b|, or of all components of the pixel where it is
/// a mean over a box or turned by an odd angle (the parts of a sum were rounded, not the sum). Colors that were made of
/// several bands are not allowed any rounding, and compressions that lose more than that are not known by a bound.
struct Agreement {
    std::size_t values = 0;
    std::size_t identical = 0;
    std::size_t beyond_rounding = 0;  ///< finite in both and not the same
    std::size_t not_finite = 0;       ///< in one of them only, or different
    /// sqrt(sum |dC|_F^2 / sum |C_A|_F^2) of the components that both know, where all of a pixel are finite: fro_c
    /// (error_metrics.h) if they know all. Infinite if A is black there and B is not.
    double distance = 0.0;
    std::optional<Significance> significance;  ///< where either has error bars
    std::optional<WorstPixel> worst;           ///< empty: no number is finite in both

    /// All are the same; or what differs is chance by the error bars (Significance::is_chance) and all are finite.
    [[nodiscard]] bool is_same() const;
};

/// Requires: as common_pictures gives them.
Agreement agreement(const CommonPictures& pictures);

/// Share of Student's t with `freedom` degrees beyond +-t. Requires: freedom >= 1.
double beyond_t(double t, int freedom);

}  // namespace pol::compare
