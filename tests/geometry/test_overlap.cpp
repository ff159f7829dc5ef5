// SPDX-License-Identifier: Apache-2.0
#include "geometry/geometry_helpers.h"
#include "geometry/overlap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "geometry/mesh_check.h"
#include "geometry/shapes.h"

namespace pol {
namespace {

DMat4 moved(double x, double y, double z) {
    DMat4 m(1.0);
    m[3] = {x, y, z, 1.0};
    return m;
}

Mesh box(const DVec3& size, const DVec3& center) {
    return transformed(make_mesh(BoxShape{size}).value(), moved(center.x, center.y, center.z)).value();
}

HalfSpaceSolid solid(const Mesh& mesh) {
    return HalfSpaceSolid::from_mesh(mesh).value();
}

// The same two boxes as convex solids and as general meshes: both methods must say the same.
void expect_boxes(const Mesh& a, const Mesh& b, Arrangement expected) {
    const HalfSpaceSolid sa = solid(a);
    const HalfSpaceSolid sb = solid(b);
    EXPECT_EQ(arrangement(&sa, &sb), expected) << "convex pair";
    EXPECT_EQ(arrangement(&a, &b), expected) << "mesh pair";
    EXPECT_EQ(arrangement(&a, &sb), expected) << "mixed pair";
    const Arrangement back = expected == Arrangement::a_contains_b   ? Arrangement::b_contains_a
                             : expected == Arrangement::b_contains_a ? Arrangement::a_contains_b
                                                                     : expected;
    EXPECT_EQ(arrangement(&sb, &sa), back);
    EXPECT_EQ(arrangement(&b, &a), back);
}

TEST(Overlap, BoxesAreSortedByHowTheyLie) {
    const Mesh unit_box = box(DVec3(1.0), DVec3(0.0));
    expect_boxes(unit_box, box(DVec3(1.0), {2.0, 0.0, 0.0}), Arrangement::disjoint);
    expect_boxes(unit_box, box(DVec3(1.0), {1.0 + 1e-7, 0.0, 0.0}), Arrangement::disjoint);
    expect_boxes(unit_box, box(DVec3(1.0), {1.0, 0.3, 0.2}), Arrangement::touching);
    expect_boxes(unit_box, box(DVec3(1.0), {1.0, 1.0, 1.0}), Arrangement::touching);
    expect_boxes(unit_box, box(DVec3(1.0), {0.9, 0.3, 0.2}), Arrangement::overlapping);
    expect_boxes(unit_box, box(DVec3(0.5), {0.1, 0.0, 0.2}), Arrangement::a_contains_b);
    expect_boxes(unit_box, box(DVec3(0.5), {0.25, 0.25, 0.0}), Arrangement::a_contains_b);
    expect_boxes(box(DVec3(0.5), {0.1, 0.0, 0.2}), unit_box, Arrangement::b_contains_a);
}

TEST(Overlap, CrossedBarsOfEqualHeightOverlapThoughNoEdgePiercesAFace) {
    expect_boxes(box({9.0, 1.0, 1.0}, DVec3(0.0)), box({1.0, 9.0, 1.0}, DVec3(0.0)), Arrangement::overlapping);
}

TEST(Overlap, EqualSolidsContainEachOther) {
    const HalfSpaceSolid a = solid(make_mesh(BrilliantShape{}).value());
    EXPECT_EQ(arrangement(&a, &a), Arrangement::a_contains_b);
}

// Two bars, edge towards edge and crossed at right angles: only the cross product of those edges separates them.
TEST(Overlap, CrossedEdgesAreSeparatedByTheirCrossProduct) {
    const double half = std::sqrt(0.5);
    DMat4 turned(1.0);
    turned[1] = {0.0, half, half, 0.0};
    turned[2] = {0.0, -half, half, 0.0};
    const Mesh bar = make_mesh(BoxShape{{10.0, 1.0, 1.0}}).value();
    const HalfSpaceSolid lower = solid(transformed(bar, turned).value());
    for (const double gap : {-1e-3, 0.0, 1e-3}) {
        SCOPED_TRACE(gap);
        DMat4 above(1.0);
        above[0] = {0.0, 1.0, 0.0, 0.0};
        above[1] = {-half, 0.0, half, 0.0};
        above[2] = {half, 0.0, half, 0.0};
        above[3] = {0.0, 0.0, 2.0 * half + gap, 1.0};
        const HalfSpaceSolid upper = solid(transformed(bar, above).value());
        EXPECT_EQ(arrangement(&lower, &upper), gap < 0.0   ? Arrangement::overlapping
                                               : gap > 0.0 ? Arrangement::disjoint
                                                           : Arrangement::touching);
    }
}

TEST(Overlap, SpheresAreSortedByDistance) {
    const Sphere ball{DVec3(0.0), 1.0};
    const auto with = [&](double x, double radius) {
        const Sphere other{{x, 0.0, 0.0}, radius};
        return arrangement(&ball, &other);
    };
    EXPECT_EQ(with(3.0, 1.0), Arrangement::disjoint);
    EXPECT_EQ(with(2.0, 1.0), Arrangement::touching);
    EXPECT_EQ(with(1.5, 1.0), Arrangement::overlapping);
    EXPECT_EQ(with(0.5, 0.5), Arrangement::a_contains_b);
    EXPECT_EQ(with(0.5, 3.0), Arrangement::b_contains_a);
}

TEST(Overlap, ASphereAndABoxAreSortedByDistance) {
    const Mesh mesh = box(DVec3(2.0), DVec3(0.0));
    const HalfSpaceSolid cube = solid(mesh);
    const auto with = [&](const DVec3& center, double radius) {
        const Sphere ball{center, radius};
        EXPECT_EQ(arrangement(&ball, &mesh), arrangement(&ball, &cube));
        return arrangement(&cube, &ball);
    };
    EXPECT_EQ(with({3.0, 0.0, 0.0}, 1.0), Arrangement::disjoint);
    EXPECT_EQ(with({2.0, 0.0, 0.0}, 1.0), Arrangement::touching);
    EXPECT_EQ(with({1.9, 0.0, 0.0}, 1.0), Arrangement::overlapping);
    EXPECT_EQ(with(DVec3(0.0), 1.0), Arrangement::a_contains_b) << "the inscribed ball touches from inside";
    EXPECT_EQ(with(DVec3(0.0), 1.1), Arrangement::overlapping);
    EXPECT_EQ(with(DVec3(0.0), std::sqrt(3.0)), Arrangement::b_contains_a) << "the circumscribed ball";
    // Corner towards the ball: touching at distance r, where the planes alone would see an overlap.
    EXPECT_EQ(with(DVec3(1.0 + 1.0 / std::sqrt(3.0)), 1.0), Arrangement::touching);
    EXPECT_EQ(with(DVec3(1.05 + 1.0 / std::sqrt(3.0)), 1.0), Arrangement::disjoint);
}

TEST(Overlap, ABallInThePitOfANonConvexSolidIsOutsideIt) {
    const Mesh pit = test::pitted_cube();
    const Sphere in_the_pit{{0.5, 0.5, 0.85}, 0.1};
    EXPECT_EQ(arrangement(&pit, &in_the_pit), Arrangement::disjoint);
    const Sphere in_the_solid{{0.5, 0.5, 0.25}, 0.1};
    EXPECT_EQ(arrangement(&pit, &in_the_solid), Arrangement::a_contains_b);
    const Mesh stick = box({0.1, 0.1, 1.0}, {0.5, 0.5, 1.2});
    EXPECT_EQ(arrangement(&pit, &stick), Arrangement::disjoint);
    const Mesh long_stick = box({0.1, 0.1, 1.0}, {0.5, 0.5, 1.0});
    EXPECT_EQ(arrangement(&pit, &long_stick), Arrangement::overlapping);
}

TEST(Overlap, TouchingFacetsAreThePairsThatShareAnArea) {
    const HalfSpaceSolid a = solid(box(DVec3(1.0), DVec3(0.0)));
    const HalfSpaceSolid b = solid(box(DVec3(1.0), {1.0, 0.5, 0.0}));
    const auto pairs = common_facets(&a, &b, Facing::opposite);
    ASSERT_EQ(pairs.size(), 1U);
    EXPECT_EQ(pairs[0].a, 1) << "+x of a";
    EXPECT_EQ(pairs[0].b, 0) << "-x of b";
    const HalfSpaceSolid edge_only = solid(box(DVec3(1.0), {1.0, 1.0, 0.0}));
    EXPECT_TRUE(common_facets(&a, &edge_only, Facing::opposite).empty());
    const HalfSpaceSolid apart = solid(box(DVec3(1.0), {1.0 + 1e-7, 0.5, 0.0}));
    EXPECT_TRUE(common_facets(&a, &apart, Facing::opposite).empty());
    const HalfSpaceSolid flush_inside = solid(box(DVec3(0.5), {0.25, 0.0, 0.0}));
    EXPECT_TRUE(common_facets(&a, &flush_inside, Facing::opposite).empty()) << "same facing: not a contact";
    const Sphere ball{{1.5, 0.0, 0.0}, 1.0};
    EXPECT_TRUE(common_facets(&a, &ball, Facing::opposite).empty());
}

// Coordinates of 20 are off by 20 * 2.2e-16 = 4e-15 at most: a gap of 1e-8, or of 1e-12, is one that somebody wrote.
TEST(Overlap, AGapOfMoreThanRoundingIsAGap) {
    const Mesh left = box(DVec3(40.0), DVec3(0.0));
    for (const double gap : {1e-8, 1e-12})
        expect_boxes(left, box(DVec3(40.0), {40.0 + gap, 0.0, 0.0}), Arrangement::disjoint);
    expect_boxes(left, box(DVec3(40.0), {40.0, 0.0, 0.0}), Arrangement::touching);
    const Sphere ball{{0.0, 0.0, 0.0}, 20.0};
    const Sphere near{{40.0 + 1e-8, 0.0, 0.0}, 20.0};
    EXPECT_EQ(arrangement(&ball, &near), Arrangement::disjoint);
}

// Tolerances are those of the facets that meet, not of the largest coordinate in the file.
TEST(Overlap, OneChipFarAwayClosesNoGap) {
    Mesh left = box(DVec3(1.0), DVec3(0.0));
    test::append(left, box(DVec3(1e-3), DVec3(1e6)));
    const Mesh apart = box(DVec3(1.0), {1.0 + 1e-10, 0.2, 0.0});
    EXPECT_EQ(arrangement(&left, &apart), Arrangement::disjoint);
    EXPECT_TRUE(common_facets(&left, &apart, Facing::opposite).empty());
    const Mesh beside = box(DVec3(1.0), {1.0, 0.2, 0.0});
    EXPECT_EQ(arrangement(&left, &beside), Arrangement::touching);
    EXPECT_EQ(common_facets(&left, &beside, Facing::opposite).size(), 1U);
}

TEST(Overlap, EqualSpheresAreOneFacetEach) {
    const Sphere a{{0.1, 0.2, 0.3}, 1.0};
    const Sphere b{{0.1, 0.2, 0.3 + 1e-16}, 1.0};
    EXPECT_EQ(common_facets(&a, &b, Facing::same).size(), 1U);
    EXPECT_TRUE(common_facets(&a, &b, Facing::opposite).empty());
    const Sphere larger{{0.1, 0.2, 0.3}, 1.0 + 1e-12};
    EXPECT_TRUE(common_facets(&a, &larger, Facing::same).empty()) << "a film of 1e-12";
}

// The two prisms of a cemented Wollaston pair, at any scale and place.
TEST(Overlap, PrismsCementedAlongASlantTouchAtEveryScale) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
        const DMat4 place = [scale] {
            const double c = std::cos(0.3);
            const double s = std::sin(0.3);
            DMat4 m(scale);
            m[0] = {scale * c, scale * s, 0.0, 0.0};
            m[1] = {-scale * s, scale * c, 0.0, 0.0};
            m[3] = {3.0 * scale, -2.0 * scale, scale, 1.0};
            return m;
        }();
        const ExtrusionShape first{{{-1.0, -0.5}, {0.6, -0.5}, {-0.6, 0.5}, {-1.0, 0.5}}, 1.0};
        const ExtrusionShape second{{{0.6, -0.5}, {1.0, -0.5}, {1.0, 0.5}, {-0.6, 0.5}}, 1.0};
        const HalfSpaceSolid a = solid(transformed(make_mesh(first).value(), place).value());
        const HalfSpaceSolid b = solid(transformed(make_mesh(second).value(), place).value());
        EXPECT_EQ(arrangement(&a, &b), Arrangement::touching);
        const auto pairs = common_facets(&a, &b, Facing::opposite);
        ASSERT_EQ(pairs.size(), 1U);
        EXPECT_EQ(pairs[0].a, 3);
        EXPECT_EQ(pairs[0].b, 5);
    }
}

}  // namespace
}  // namespace pol
