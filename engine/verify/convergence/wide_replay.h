// SPDX-License-Identifier: Apache-2.0
// A recorded tree followed once more in 128 bit: what its light would be if nothing were rounded.
#pragma once

#include <optional>

#include "core/quad.h"
#include "plan/plan.h"
#include "polarization/stokes.h"
#include "tracer/explain.h"

namespace pol::verify {

struct WideLight {
    Stokes<Quad> light{};
    /// A ray met a face of a flat convex solid beyond the face's edge: without rounding it meets another one.
    bool beyond_edge = false;
};

/// Light of the tree's leaves but for those on the random tail, which is another estimate with every rescaling.
///
/// Exact, because it is what the question is about: the numbers of the plan (planes, corners, indices, absorption) and
/// the camera ray of the explanation, once vectors that are to be unit and perpendicular are made so; and the tree's
/// shape: which branch meets which facet and what it splits into. Followed anew, boundaries by the general solver of
/// optics: points, directions, field vectors, amplitudes, absorption, sums. Only the source at a leaf is asked in
/// double, with the wave there rounded once. That is exact for unpolarized lamps and surroundings in the camera's
/// medium, and good to some 1e-16 of the leaf's light otherwise, which is then the floor of what can be seen.
///
/// None where a branch of the tree does not exist in 128 bit, or one that exists with a weight that a double sum up to
/// 1 would see is not in the tree: near critical angles rounding decides about branches.
std::optional<WideLight> wide_light(const Plan& plan, const Explanation& explanation);

/// The same leaves as the kernel added them.
Stokes<double> light_without_tail(const RayTree& tree);

/// |dC|_F between light and the same light without rounding.
double rounding_distance(const Stokes<double>& rounded, const Stokes<Quad>& exact);

}  // namespace pol::verify
