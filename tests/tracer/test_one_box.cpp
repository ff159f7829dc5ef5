// SPDX-License-Identifier: Apache-2.0
// The kernel against one that was written for a single scene and shares nothing with it but vectors, the camera and the
// rule of what to follow first.
#include <gtest/gtest.h>

#include "bench/one_box.h"
#include "support/render_scene.h"

namespace pol {
namespace {

// Some ten interfaces of a few dozen operations each: 1e-13 if every rounding error had the same sign.
TEST(OneBox, AHandWrittenTracerSeesTheSameLight) {
    const auto plan = test::plan_of(test::scene_of(bench::one_box_scene));
    const StokesImage picture = test::render(plan);
    const auto by_hand = bench::one_box_picture(plan->camera, picture.width, picture.height);
    EXPECT_LE(bench::relative_difference(picture.stokes, by_hand), 1e-12);
}

}  // namespace
}  // namespace pol
