// SPDX-License-Identifier: Apache-2.0
// Two pictures held against each other, map by map.
#pragma once

#include "maps/evaluate.h"

namespace pol {

/// `a` minus `b`, two values of one quantity in its unit; azimuths as undirected lines, so between -90 and 90 degrees.
/// Less than what a thousand roundings make of the values, or of the quantity's range if that is more, is 0: two
/// pictures of the same light that were summed in different orders do not differ. Defined where both are, at the
/// smaller weight; else the graver of their states, and `no_light` only if both say so: light beside darkness has no
/// difference of polarization. Requires: quantity is not `color`.
MapPixel difference(Quantity quantity, const MapPixel& a, const MapPixel& b);

/// Quantity::poincare: half the angle between two states on the Poincare sphere, 0 to 90 degrees; at the smaller weight
/// where both states are defined, else as difference() has it. Nothing but rounding is 0.
MapPixel poincare_distance(const PixelLight& a, const PixelLight& b);

}  // namespace pol
