// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pol {

/// A round dial for the direction of an undirected axis, counted from the right counter-clockwise as on the picture.
/// Drag turns it (Shift: in steps of 15 degrees), a double click sets it to 0. Radians, kept in [0, pi). Returns true
/// if the user changed it.
bool axis_dial(const char* name, double& axis_rad, float diameter);

}  // namespace pol
