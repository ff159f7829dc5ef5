// SPDX-License-Identifier: Apache-2.0
// Who watches the kernel. The picture is made with an observer that sees nothing, a pixel is explained with one that
// writes everything down (ray_tree.h): same kernel, same numbers.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "polarization/stokes.h"
#include "tracer/crossing.h"
#include "tracer/node.h"

namespace pol {

/// Asked now and then, with the number of branches so far, by work that may take long: false ends it.
using KeepGoing = std::function<bool(std::size_t branches)>;

/// Sees nothing, never stops. What an observer must offer.
struct Silent {
    [[nodiscard]] bool cancelled() const { return false; }
    /// A branch is born; parent -1 for the camera ray.
    void opened(const Node&, int /*parent*/, Interaction) {}
    /// A branch has arrived somewhere: node.origin is the point.
    void reached(const Node&, const Crossing&) {}
    /// A branch has ended; `light` is its share of the pixel per wavelength of the group, empty if it brings none.
    void ended(const Node&, LeafReason, std::span<const Stokes<double>>) {}
    /// The random tail goes on from here; from now on nodes are rescaled to the weight of all that was open.
    void tail_begins(const Node&) {}
};

/// Silent, but for asking whether anybody still waits.
struct Patient : Silent {
    const KeepGoing* keep_going = nullptr;
    [[nodiscard]] bool cancelled() const { return !(*keep_going)(0); }
};

}  // namespace pol
