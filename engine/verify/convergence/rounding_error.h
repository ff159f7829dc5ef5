// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "plan/plan.h"
#include "tracer/ray_tree.h"

namespace pol::verify {

/// Floating-point error of a picture: the trees of some pixels against themselves followed in 128 bit (wide_replay.h).
/// Errors are |dC|_F over the root mean square of |C|_F of these pixels. How the plan's numbers came about (meshes,
/// transforms, dispersion) is not part of it, and neither are random tails.
struct RoundingError {
    double fro_c = 0.0;   ///< root mean square over the pixels compared
    double median = 0.0;  ///< of the pixels whose ray branches or passes a sheet: others have nothing to round
    double largest = 0.0;
    std::size_t compared = 0;
    std::size_t too_large = 0;       ///< left out: most_replayed_branches do not suffice
    std::size_t other_branches = 0;  ///< left out: rounding decided whether a branch exists
    std::size_t beyond_edge = 0;     ///< compared, but some ray met a face beyond its edge: rounding chose the path
    std::size_t with_tail = 0;       ///< compared but for their random tails
    double wavelength_nm = 0.0;
};

inline constexpr int rounding_grid = 16;
inline constexpr std::size_t most_replayed_branches = std::size_t{1} << 20U;  ///< of all pixels together

/// On a grid of at most rounding_grid pixels along each side, centre sample, middle wavelength. None once `keep_going`
/// has said no.
std::optional<RoundingError> rounding_error(const Plan& plan, const KeepGoing& keep_going);

/// The figures in words, with every pixel that is not in them.
std::string text_of(const RoundingError& error);

}  // namespace pol::verify
