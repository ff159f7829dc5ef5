// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "viewer/bench.h"
#include "viewer/view_transform.h"

namespace pol {
namespace {

// Malus: a polarizer at theta passes cos^2 theta of light that is linear along x (physics.md T13).
TEST(Bench, APolarizerPassesCosineSquaredOfLinearLight) {
    for (int degree = 0; degree <= 180; degree += 15) {
        const double theta = degree * 3.141592653589793 / 180.0;
        Bench bench;
        bench.elements.push_back({BenchElementKind::polarizer, true, theta, 0.0});
        const Stokes<double> out = bench.mueller() * Stokes<double>{1.0, 1.0, 0.0, 0.0};
        EXPECT_NEAR(out.s0, std::pow(std::cos(theta), 2), 4e-16) << degree;
    }
}

TEST(ViewTransform, ThePointUnderTheCursorStaysWhileZooming) {
    ViewTransform view{3.0, {10.0, -20.0}};
    const DVec2 cursor(200.0, 150.0);
    const DVec2 before = view.picture_from_view(cursor);
    view.zoom_at(cursor, 1.7);
    const DVec2 after = view.picture_from_view(cursor);
    EXPECT_NEAR(before.x, after.x, 1e-12);
    EXPECT_NEAR(before.y, after.y, 1e-12);
}

}  // namespace
}  // namespace pol
