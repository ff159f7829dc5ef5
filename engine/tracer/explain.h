// SPDX-License-Identifier: Apache-2.0
// The very tree that made a sample of a pixel, and the proof that it did.
#pragma once

#include <cstdint>
#include <optional>

#include "plan/plan.h"
#include "tracer/ray_tree.h"
#include "tracer/trace.h"

namespace pol {

struct Explanation {
    int x = 0;
    int y = 0;
    std::uint32_t sample = 0;
    int wavelength = 0;  ///< index into Plan::wavelengths_nm
    TraceTask task{};    ///< camera ray with its frame
    RayTree tree;
    TraceResult result{};
    Stokes<double> sample_light{};  ///< of the kernel that makes pictures (Silent observer)
    Stokes<double> leaf_sum{};      ///< of the leaves, in the order in which they ended
    /// True if leaf_sum and sample_light agree to the last bit.
    [[nodiscard]] bool exact() const { return leaf_sum == sample_light; }
};

/// Requires: pixel inside the picture, wavelength an index into plan.wavelengths_nm.
Explanation explain(const Plan& plan, int x, int y, std::uint32_t sample, int wavelength);

/// The same, for who may not want to wait: none once `keep_going` has said no. It is asked after a few hundred branches
/// each, on the calling thread.
std::optional<Explanation> explain(const Plan& plan, int x, int y, std::uint32_t sample, int wavelength,
                                   const KeepGoing& keep_going);

/// Coherence matrix of the light that a leaf's source sends back along `wave`, in the wave's field vectors (a single
/// mode uses xx only): basic radiance times n_camera^2. Zero unless leaf.brings_light().
CoherenceMatrix<double> leaf_source(const Plan& plan, const Explanation& explanation, const RayTreeNode& leaf,
                                    const Wave<double>& wave);

}  // namespace pol
