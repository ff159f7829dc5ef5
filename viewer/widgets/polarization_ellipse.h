// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "polarization/measures.h"

namespace pol {

/// A square of `side` points with the polarization ellipse of the polarized part, x to the right and y up as who looks
/// sees it, and an arrow in the direction of rotation; a dashed circle for the unpolarized part. Radii are square roots
/// of shares of S0. `seen`: handedness +1 is clockwise.
void draw_polarization_ellipse(const Measures<double>& seen, float side);

/// The same where S3 was not measured: a line along the azimuth, of the length of the linear part, and no circle.
void draw_azimuth(const Measures<double>& seen, float side);

}  // namespace pol
