// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/render_scene.h"

namespace pol {
namespace {

// physics.md T7: all incoherent passes of a plate at normal incidence, T = 2n/(n^2+1). Tolerance: residual 1e-14 times
// radiance 1, plus rounding of a dozen passes of order 1e-16 each.
TEST(Plate, TransmitsTwoNOverNSquaredPlusOneAtNormalIncidence) {
    const Stokes<double> s = test::look(R"(
camera: {type: orthographic, position: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], width: 0.1}
render: {residual: 1e-14}
media: {glass: {index: 1.5}}
objects:
  - {name: plate, shape: {box: {size: [2, 2, 0.5]}}, medium: glass}
  - {name: lamp, shape: {rectangle: {size: [4, 4]}}, transform: [{translate: [0, 0, -2]}], emission: {radiance: 1}}
)");
    EXPECT_NEAR(s.s0, 12.0 / 13.0, 2e-14);
    EXPECT_NEAR(s.s1, 0.0, 1e-15);
    EXPECT_NEAR(s.s2, 0.0, 1e-15);
    EXPECT_NEAR(s.s3, 0.0, 1e-15);
}

}  // namespace
}  // namespace pol
