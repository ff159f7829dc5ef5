// SPDX-License-Identifier: Apache-2.0
// Every change of convention between two pictures, tried at once (README.md of this folder).
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "compare/stokes_plane.h"

namespace pol::compare {

/// Which pixel of A is held against one of B: the symmetries of the square.
enum class Geometry { same, flip_y, flip_x, rot180, transpose, rot90, rot270, antitranspose };
/// "flip_y".
std::string_view name_of(Geometry geometry);

/// What a convention does to (S1, S2, S3).
enum class FrameChange {
    signs,        ///< other signs or another order
    turned,       ///< a frame turned by one angle
    mirrored,     ///< ... and seen from behind
    radial,       ///< x away from the middle of the picture
    projected,    ///< x the camera's right, projected across the ray, where ours is across ray and up
    unprojected,  ///< the other way round
};
/// "signs", "turned frame", "turned frame, mirrored", "radial frame", "projected frame", "unprojected frame".
std::string_view name_of(FrameChange change);

/// z below this decides nothing: six standard deviations.
inline constexpr double decided_z = 6.0;

/// One way to make B from A: B_i = scale * sign_i * A'_{order_i}, A' in the changed frame. Component 1 is element 0.
struct ConventionFit {
    Geometry geometry = Geometry::same;
    FrameChange frame = FrameChange::signs;
    std::array<int, 3> order{1, 2, 3};
    std::array<int, 3> signs{1, 1, 1};    ///< 1 where nothing tells it and the component is in its place
    std::optional<double> turn_deg;       ///< x of B is turned counter-clockwise by it; only turned and mirrored
    double scale = 1.0;                   ///< of S0
    std::array<double, 3> correlation{};  ///< 0 to 1 (not centred)
    std::array<double, 3> z{};            ///< how many standard deviations speak for the sign
    std::array<double, 3> sigma{};        ///< rms of what is left of a component, or the noise, relative to S0 of B
    double dop_scale = 1.0;               ///< degree of polarization of B relative to A's
    double residual = 0.0;                ///< sum of squares that are left of S1, S2, S3
    double simplicity = 0.0;              ///< the smaller, the simpler

    [[nodiscard]] bool decides(std::size_t component) const { return z[component] >= decided_z; }
};

/// All fits of one pair, and what they were chosen by.
struct ConventionFits {
    std::vector<ConventionFit> fits;  ///< of the geometries that S0 allows; empty: nothing in common
    StokesComponents judged;          ///< without S0
    /// Of S0, means removed, best geometry; 1 if neither picture has any structure in S0.
    double s0_correlation = 0.0;
    double boxes = 0.0;              ///< that both have light in
    double floor = 0.0;              ///< of a component's standard error, by noise or 1e-6 of S0
    double polarization_of_a = 0.0;  ///< sum of squares of the judged components, in units of B
    double polarization_of_b = 0.0;
    double light_of_b = 0.0;   ///< sum of squares of S0
    double s0_residual = 0.0;  ///< sum of squares of S0 left by the scale, best geometry
};

/// Fewest boxes with light in both that say anything.
inline constexpr double fewest_boxes = 8.0;

/// `pixel_tangent`: tangent of the view angle per pixel of B, for frames that depend on it; nullopt: not tried.
/// Geometries that do not fit the sizes are left out.
ConventionFits fit_conventions(const StokesPlane& a, const StokesPlane& b, std::optional<double> pixel_tangent);

/// Slope of log S0 of B against log S0 of A where both exceed 1e-3 of their largest: 1 for linear numbers. Empty if
/// there are fewer than 8 such boxes, or if S0 hardly varies (standard deviation of the logarithm 0.05).
std::optional<double> s0_gamma(const StokesPlane& a, const StokesPlane& b, Geometry geometry);

/// Light that B cuts off.
struct Clip {
    double at = 0.0;     ///< S0 of B there
    double share = 0.0;  ///< of the pixels of boxes that both have light in
};
/// B's largest S0, if A goes on above it: in the boxes of which at least half has it, A varies (standard deviation 5 %
/// of the mean, and three standard errors) and is brighter than that by the scale of the others. Empty if not, or if
/// there are fewer than 8 boxes of either kind: a highlight smaller than a box is not seen.
std::optional<Clip> s0_clip(const StokesPlane& a, const StokesPlane& b, Geometry geometry);

}  // namespace pol::compare
