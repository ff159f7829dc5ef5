// SPDX-License-Identifier: Apache-2.0
// The polarimeter: ideal elements between the scene and the sensor, turned after the render. Nothing is traced
// again: the picture's Stokes vectors are multiplied by one real 4x4 matrix.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "maps/pixel_light.h"
#include "optics/elements.h"
#include "polarization/mueller.h"
#include "polarization/stokes.h"

namespace pol {

enum class PolarimeterElementKind : std::uint8_t { polarizer, retarder };

/// Angles in radians in the pixel's frame, from x (image right) towards y (image up), seen by the receiver.
struct PolarimeterElement {
    PolarimeterElementKind kind = PolarimeterElementKind::polarizer;
    bool in_beam = true;
    double axis = 0.0;                       ///< transmission axis, or fast axis
    double retardance = 1.5707963267948966;  ///< retarder only
    friend bool operator==(const PolarimeterElement&, const PolarimeterElement&) = default;
};

/// Elements in the order in which the light meets them.
struct Polarimeter {
    std::vector<PolarimeterElement> elements;
    /// True if the light arrives as it is.
    [[nodiscard]] bool empty() const;
    /// Acts on the Stokes vector of a pixel in its frame.
    [[nodiscard]] MuellerMatrix<double> mueller() const;
    friend bool operator==(const Polarimeter&, const Polarimeter&) = default;
};

/// The train that passes one state of light in full and blocks the opposite one.
struct StandardAnalyzer {
    Stokes<double> passes;
    Polarimeter polarimeter;
};

/// H, V, +45, -45, right, left: in pairs of opposite states.
std::span<const StandardAnalyzer> standard_analyzers();

/// Light behind a train of passive elements. They let through no more of the missing or surplus light than there was,
/// so its bounds stay; what rounding leaves of light that they stop is told by the light in front of them.
PixelLight behind(const MuellerMatrix<double>& train, const PixelLight& light);

}  // namespace pol
