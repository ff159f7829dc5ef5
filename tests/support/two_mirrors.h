// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pol::test {

/// A lamp of radiance 1 seen by way of two parallel faces of glass, n = 1.5, at Brewster's angle; what they transmit
/// dies at the other faces. Each reflects R_s = (5/13)^2 of s and nothing of p (cos 2 theta_B = -5/13).
inline constexpr const char* two_mirrors =
    "camera: {type: orthographic, position: [-3, 2, 0], target: [0, 0, 0], width: 1e-9}\n"
    "render: {residual: 0, size: [3, 2]}\n"
    "media: {glass: {index: 1.5}}\n"
    "objects:\n"
    "  - {name: lower, shape: {box: {size: [2, 1, 2]}}, transform: [{translate: [0, -0.5, 0]}], medium: glass,\n"
    "     black: [[0, -1, 0], [1, 0, 0], [-1, 0, 0], [0, 0, 1], [0, 0, -1]]}\n"
    "  - {name: upper, shape: {box: {size: [2, 1, 2]}}, transform: [{translate: [1.5, 1.5, 0]}], medium: glass,\n"
    "     black: [[0, 1, 0], [1, 0, 0], [-1, 0, 0], [0, 0, 1], [0, 0, -1]]}\n"
    "  - name: lamp\n"
    "    shape: {rectangle: {size: 30}}\n"
    "    transform: [{rotate: {axis: [1, 0, 0], angle: -90}}, {translate: [10, -5, 0]}]\n"
    "    emission: {radiance: 1}\n";
inline constexpr double brewster_s_reflectance = 25.0 / 169.0;

}  // namespace pol::test
