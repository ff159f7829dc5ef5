// SPDX-License-Identifier: Apache-2.0
// Thin ideal sheets: they change the polarization of a ray and nothing else. Axes are world space and are projected on the
// plane across the ray, so oblique rays are well defined.
#pragma once

#include <variant>

#include "core/vec.h"

namespace pol {

/// Passes the field along `axis`, blocks the rest.
struct LinearPolarizer {
    DVec3 axis{1.0, 0.0, 0.0};
    friend bool operator==(const LinearPolarizer&, const LinearPolarizer&) = default;
};

/// Delays the field across `fast_axis` by `retardance` radians against the field along it.
struct Retarder {
    DVec3 fast_axis{1.0, 0.0, 0.0};
    double retardance = 0.0;
    friend bool operator==(const Retarder&, const Retarder&) = default;
};

enum class Handedness { right, left };

/// Passes circular light of one handedness (as seen by the receiver), from either side, blocks the other.
struct CircularPolarizer {
    Handedness passes = Handedness::right;
    friend bool operator==(const CircularPolarizer&, const CircularPolarizer&) = default;
};

using Sheet = std::variant<LinearPolarizer, Retarder, CircularPolarizer>;

}  // namespace pol
