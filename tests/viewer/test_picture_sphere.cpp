// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "known_picture.h"
#include "support/lit_trees.h"
#include "viewer/pages/sphere_view.h"
#include "viewer/panels/sphere_panel.h"
#include "window_without_gl.h"

namespace pol {
namespace {

TEST(SphereView, LooksAtThePointWhereTheViewerStands) {
    const SphereView at_h{0.0, 0.0};
    const DVec3 h = at_h.seen({1.0, 0.0, 0.0});
    EXPECT_NEAR(h.z, 1.0, 1e-15) << "H is in front";
    EXPECT_NEAR(at_h.seen({0.0, 1.0, 0.0}).x, 1.0, 1e-15) << "+45 is on the right";
    EXPECT_NEAR(at_h.seen({0.0, 0.0, 1.0}).y, 1.0, 1e-15) << "R is up";
    const SphereView at_pole{0.3, 0.5 * pi};
    EXPECT_NEAR(at_pole.seen({0.0, 0.0, 1.0}).z, 1.0, 1e-15);
}

TEST(SphereView, KeepsLengthsAndHandedness) {
    const SphereView view{1.1, -0.4};
    const DVec3 x = view.seen({1.0, 0.0, 0.0});
    const DVec3 y = view.seen({0.0, 1.0, 0.0});
    const DVec3 z = view.seen({0.0, 0.0, 1.0});
    EXPECT_NEAR(glm::length(x), 1.0, 1e-15);
    EXPECT_NEAR(glm::length(glm::cross(x, y) - z), 0.0, 1e-15) << "no mirror image";
}

// The point of the front that lies under the hand goes with it.
TEST(SphereView, FollowsTheHand) {
    SphereView view{0.0, 0.0};
    view.drag({0.1, 0.05});
    const DVec3 h = view.seen({1.0, 0.0, 0.0});
    EXPECT_GT(h.x, 0.09);
    EXPECT_LT(h.y, -0.04) << "screen coordinates run down";
}

TEST(Sphere, ThePlaceOfAStateHasItsDegreeOfPolarizationAsRadius) {
    const auto point = sphere_point(polarized_light(3.0, 0.6, 0.4, 0.2));
    ASSERT_TRUE(point);
    EXPECT_NEAR(glm::length(point->place), 0.6, 1e-15);
    EXPECT_NEAR(std::atan2(point->place.y, point->place.x), 0.8, 1e-15) << "twice the azimuth";
    EXPECT_EQ(point->intensity, 3.0);
    EXPECT_FALSE(sphere_point({0.0, 0.0, 0.0, 0.0}));
    EXPECT_FALSE(sphere_point({NAN, 0.0, 0.0, 0.0}));
    EXPECT_FALSE(sphere_point({1.0, NAN, 0.0, 0.0}));
}

// The field of (1, 0, 0, 1) turns clockwise for the receiver: right-handed for him, left-handed for the source.
TEST(Sphere, ItsNamesAndPointsFollowTheConvention) {
    StokesImage image = known_picture(1, 1);
    image.stokes.assign(image.stokes.size(), {1.0, 0.0, 0.3, 0.9});
    for (const Viewpoint viewpoint : {Viewpoint::receiver, Viewpoint::source}) {
        for (const PositiveS3 positive : {PositiveS3::right, PositiveS3::left}) {
            const Convention convention{viewpoint, positive, TimeSign::minus};
            SCOPED_TRACE(convention.text());
            const auto points = sphere_points(ShownPicture(image, {}, convention), 0, {0, 0, 1, 1}, 10);
            ASSERT_EQ(points.size(), 1u);
            std::string nearest;
            std::string beside;
            for (const SphereLabel& label : sphere_labels(convention)) {
                if (label.at.z * points[0].place.z > 0.0) nearest = label.text;
                if (label.at.y * points[0].place.y > 0.0) beside = label.text;
            }
            EXPECT_EQ(nearest, viewpoint == Viewpoint::receiver ? "R" : "L");
            EXPECT_EQ(beside, viewpoint == Viewpoint::receiver ? "+45" : "-45");
        }
    }
}

TEST(SpherePanel, SaysWhichConventionItsNamesHave) {
    WindowWithoutGl window;
    ASSERT_NO_FATAL_FAILURE(open_picture(window.session, known_picture()));
    SpherePanel panel;
    window.session.change_view().convention = {Viewpoint::source, PositiveS3::left, TimeSign::minus};
    EXPECT_NE(window.text_of([&] { panel.draw(window.session, window.wishes); }).find("source's view, S3 > 0 left"),
              std::string::npos);
}

TEST(Sphere, TheLassoTakesExactlyThePixelsThatAreSeenInIt) {
    const StokesImage image = known_picture();
    const ShownPicture shown(image, {});
    const SphereView view{0.0, 0.0};
    const std::vector<DVec2> right_half{{0.0, -2.0}, {2.0, -2.0}, {2.0, 2.0}, {0.0, 2.0}};
    const TileRect region{2, 3, 14, 12};
    for (const bool front_only : {true, false}) {
        const auto marked = pixels_inside(shown, 0, region, view, right_half, front_only);
        ASSERT_EQ(marked.size(), image.pixel_count());
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const Stokes<double>& s = image.at(0, image.pixel(x, y));
                const bool is_in_region = x >= 2 && x < 14 && y >= 3;
                const bool is_right = s.s2 > 0.0;
                const bool is_front = s.s1 >= 0.0 || !front_only;
                EXPECT_EQ(marked[image.pixel(x, y)], is_in_region && is_right && is_front) << x << "," << y;
            }
        }
    }
}

TEST(Sphere, PointsOfALargeRegionAreThinnedOut) {
    const StokesImage image = known_picture(100, 90);
    const auto points = sphere_points(ShownPicture(image, {}), 1, {0, 0, 100, 90}, 500);
    EXPECT_LE(points.size(), 510u);
    EXPECT_GE(points.size(), 200u);
    EXPECT_EQ(points.front().band, 1u);
}

// By hand: Shift and drag around the right half of the sphere marks the pixels of the picture.
TEST(SpherePanel, ALassoMarksPixelsOfThePicture) {
    WindowWithoutGl window;
    ASSERT_NO_FATAL_FAILURE(open_picture(window.session, known_picture()));
    SpherePanel panel;
    const auto draw = [&] {
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0.0F, 0.0F});
        ImGui::SetNextWindowSize({400.0F, 500.0F});
        ImGui::Begin("sphere", nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove);
        panel.draw(window.session, window.wishes);
        ImGui::End();
        ImGui::Render();
        window.wishes.fulfil(window.session);
    };
    test::hold_shift(true);
    test::put_mouse({210.0F, 60.0F});
    draw();
    draw();
    test::hold_button(0, true);
    draw();
    for (const ImVec2 at : {ImVec2(210, 80), ImVec2(380, 80), ImVec2(380, 380), ImVec2(210, 380)}) {
        test::put_mouse(at);
        draw();
    }
    test::hold_button(0, false);
    draw();
    const std::vector<bool>& marked = window.session.selection().marked;
    ASSERT_EQ(marked.size(), 192u);
    const auto count = std::count(marked.begin(), marked.end(), true);
    EXPECT_GT(count, 10);
    EXPECT_LT(count, 150);
}

// In the pixel's frame: the only leaf with light is the pixel, whose closed form is that of the camera's branch.
TEST(Sphere, ALeafIsWhereItsShareOfThePixelIs) {
    test::for_each_lit_branch([](const Plan&, const Explanation& e, int branch, const test::BranchLight& expected) {
        if (branch != 0) return;
        const std::vector<SpherePoint> points = sphere_points(e, Polarimeter{}, Convention{}, 100);
        if (expected.light.s0 < 1e-12) return;  // a share of rounding is somewhere on the sphere
        ASSERT_EQ(points.size(), 1U);
        EXPECT_TRUE(e.tree.nodes[static_cast<std::size_t>(*points[0].node)].brings_light());
        const auto mirrored =
            sphere_points(e, Polarimeter{}, Convention{Viewpoint::source, PositiveS3::right, {}}, 100);
        EXPECT_EQ(mirrored[0].place, points[0].place * DVec3(1.0, -1.0, -1.0)) << "S2 and S3 as the source sees them";
        const Stokes<double> in_pixel = test::seen_from({1.0, points[0].place.x, points[0].place.y, points[0].place.z},
                                                        e.task.ray.x, e.task.ray.y, expected.x);
        // Divided by S0, of which reflection leaves 0.1 % at the least.
        test::expect_stokes((expected.light.s0) * in_pixel, expected.light, test::lit_rounding);
    });
}

}  // namespace
}  // namespace pol
