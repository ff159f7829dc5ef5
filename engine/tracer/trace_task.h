// SPDX-License-Identifier: Apache-2.0
// What a kernel is asked for and what it answers.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/random.h"
#include "plan/camera_model.h"

namespace pol {

/// One sample to trace.
struct TraceTask {
    CameraRay ray{};
    int group = 0;   ///< index into Plan::groups
    int region = 0;  ///< where the camera is
    RandomKey key{};
    /// How far the tree is followed, as RenderSettings has it.
    double residual = 0.0;
    bool until_determined = false;
    int node_budget = 0;
};

/// What became of the unit weight of a sample, and the work it took.
struct TraceResult {
    double resolved = 0.0;
    double absorbed = 0.0;
    double residual = 0.0;  ///< not traced
    double tail = 0.0;      ///< estimated by one random path
    std::uint32_t nodes = 0;
    std::uint32_t failures = 0;
    bool cancelled = false;
    /// The light that was found, if the radiance of every lamp were its luminance: what tells whether the maps are
    /// determined (determined.h). A random tail is no part of it.
    Stokes<double> seen{};
};

/// Largest |resolved + absorbed + residual + tail - 1| that counts as rounding. A tree of 1e5 nodes of a few dozen
/// operations each stays below 1e-10 even if every rounding error had the same sign.
constexpr double energy_tolerance = 1e-9;

/// Branches after which a random tail is given up; its weight is then residual. Light that total reflection traps has
/// no end: the tail is work like the head, and gets as much of it again. A small budget leaves the tail enough to come
/// out of nearly all that it can leave: a ball within a ball, not on one axis, keeps some light for 15 000 branches. At
/// four samples the untraced light of that picture bounds its error by 7.0e-3 with 256 branches, 3.8e-3 with 4096.
constexpr int tail_limit(int node_budget) {
    return std::clamp(node_budget, 1 << 12, 1 << 16);
}

}  // namespace pol
