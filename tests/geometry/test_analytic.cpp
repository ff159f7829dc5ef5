// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "core/units.h"
#include "geometry/open_surface.h"
#include "geometry/sphere.h"

namespace pol {
namespace {

DVec3 direction(std::uint32_t i) {
    const RandomKey key{7, i, 0, 0};
    const double z = 2.0 * random_unit(key, 0) - 1.0;
    const double azimuth = 2.0 * pi * random_unit(key, 1);
    return unit(DVec3(std::sqrt(1.0 - z * z) * std::cos(azimuth), std::sqrt(1.0 - z * z) * std::sin(azimuth), z));
}

TEST(Sphere, IsMetWhereGeometrySays) {
    const Sphere ball{{1.0, 2.0, 3.0}, 2.0};
    // Half a radius off axis: the chord is r sqrt(3) long.
    const DVec3 o(-9.0, 3.0, 3.0);
    const DVec3 d(1.0, 0.0, 0.0);
    EXPECT_NEAR(ball.enter(o, d, -1).distance, 10.0 - std::sqrt(3.0), 1e-14);
    EXPECT_NEAR(ball.exit({1.0, 3.0, 3.0}, d, -1).distance, std::sqrt(3.0), 1e-14);
    EXPECT_FALSE(ball.enter(o, -d, -1));
    EXPECT_FALSE(ball.enter({-9.0, 4.5, 3.0}, d, -1));
    EXPECT_FALSE(ball.enter(o, d, 0)) << "just left";
    EXPECT_FALSE(ball.exit({3.0, 2.0, 3.0}, d, 0)) << "leads outward from the surface: no chord";
    EXPECT_TRUE(ball.contains({2.9, 2.0, 3.0}, 0.05));
    EXPECT_FALSE(ball.contains({2.9, 2.0, 3.0}, 0.15));
}

TEST(Sphere, ChainsOfInternalReflectionsKeepTheirChord) {
    // In a circle all chords of one ray have the same length, 2 r cos i.
    for (const double radius : {1e-6, 1.0, 1e6}) {
        const Sphere ball{DVec3(3.0 * radius), radius};
        for (std::uint32_t i = 0; i < 1000; ++i) {
            DVec3 o = ball.center + radius * direction(i);
            DVec3 d = direction(i + 5000);
            if (dot(d, ball.normal_at(o)) > 0.0) d = -d;
            const double chord = -2.0 * radius * dot(d, ball.normal_at(o));
            for (int bounce = 0; bounce < 20; ++bounce) {
                const FacetHit hit = ball.exit(o, d, 0);
                ASSERT_TRUE(hit);
                o += hit.distance * d;
                const DVec3 n = ball.normal_at(o);
                // Errors of position (offset 3 r: 1e-15 r each) add up over the bounces.
                ASSERT_NEAR(hit.distance, chord, 5e-14 * radius);
                ASSERT_NEAR(std::sqrt(length2(o - ball.center)), radius, 5e-14 * radius);
                d = unit(d - 2.0 * dot(n, d) * n);
            }
        }
    }
}

// Close above and below the surface, against the quadratic in 64-bit significands.
TEST(Sphere, CloseStartsErrByNoMoreThanRoundingOfTheRadius) {
    const Sphere ball{DVec3(0.0), 1.0};
    for (const double gap : {1e-3, 1e-7, 1e-11}) {
        for (std::uint32_t i = 0; i < 1000; ++i) {
            const DVec3 up = direction(i);
            DVec3 d = direction(i + 3000);
            if (dot(d, up) > -0.1) continue;
            const DVec3 o = (1.0 + gap) * up;
            const Vec3<long double> o_long(o);
            const Vec3<long double> d_long(d);
            const long double b = dot(o_long, d_long) / length2(d_long);
            const long double c = (length2(o_long) - 1.0L) / length2(d_long);
            const long double root = std::sqrt(b * b - c);
            // Some ten roundings of numbers up to 1, divided by the cosine at the surface (0.1 or more).
            EXPECT_NEAR(ball.enter(o, d, -1).distance, static_cast<double>(-b - root), 1e-14);
            EXPECT_NEAR(ball.exit(o, d, -1).distance, static_cast<double>(-b + root), 1e-14);
        }
    }
}

// From 1e6 radii away: the line's distance from the center is known to 1e6 ulp, no worse.
TEST(Sphere, FarStartsLoseNoMoreThanTheirCoordinatesDo) {
    const Sphere ball{DVec3(0.0), 1.0};
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const DVec3 aim = 0.9 * direction(i);
        const DVec3 d = direction(i + 7777);
        const DVec3 o = aim - 1e6 * d;
        const FacetHit hit = ball.enter(o, d, -1);
        ASSERT_TRUE(hit);
        // Slope of the surface at 0.9 radii off axis: 0.9 / sqrt(1 - 0.81) = 2.1.
        ASSERT_NEAR(std::sqrt(length2(o + hit.distance * d)), 1.0, 4.0 * 1e6 * 2.3e-16);
    }
}

// Grazing light is reflected straight on, so a tangent goes on as if there were no ball. Where rounding of the start
// (an ulp of 1e9 is 1e-7) decides, a line that meets the ball must still run inward there: nothing else can be solved.
TEST(Sphere, ATangentMissesTheBall) {
    for (const double radius : {1.0, 0.5, 1e-6}) {
        const Sphere ball{DVec3(0.0), radius};
        for (const DVec3& d : {DVec3(0.0, 0.0, -1.0), DVec3(0.0, 1.0, 0.0), DVec3(-1.0, 0.0, 0.0)}) {
            EXPECT_FALSE(ball.enter(radius * any_perpendicular(d) - 10.0 * d, d, -1));
        }
    }
    const Sphere ball{DVec3(0.0), 1.0};
    int met = 0;
    for (std::uint32_t i = 0; i < 10000; ++i) {
        const DVec3 d = direction(i);
        const DVec3 o = any_perpendicular(d) - 1e9 * d;
        const FacetHit hit = ball.enter(o, d, -1);
        if (!hit) continue;
        ++met;
        EXPECT_LT(dot(ball.normal_at(o + hit.distance * d), d), 0.0);
    }
    EXPECT_GT(met, 1000) << "rounding puts no line inside: the test tests nothing";
}

TEST(Sphere, OnlyRoundTransformsAreAccepted) {
    DMat4 m(1.0);
    m[0] = {0.0, 2.0, 0.0, 0.0};
    m[1] = {2.0, 0.0, 0.0, 0.0};
    m[2] = {0.0, 0.0, 2.0, 0.0};
    m[3] = {1.0, 2.0, 3.0, 1.0};
    const auto ball = make_sphere({0.5}, m);
    ASSERT_TRUE(ball);
    EXPECT_NEAR(ball.value().radius, 1.0, 1e-15);
    EXPECT_EQ(ball.value().center, DVec3(1.0, 2.0, 3.0));
    m[2][2] = 2.001;
    EXPECT_EQ(make_sphere({0.5}, m).error().field, "transform");
    m[2][2] = 0.0;
    EXPECT_EQ(make_sphere({0.5}, m).error().field, "transform");
    EXPECT_EQ(make_sphere({-1.0}, DMat4(1.0)).error().field, "radius");
    EXPECT_EQ(make_sphere({std::nan("")}, DMat4(1.0)).error().field, "radius");
}

TEST(OpenSurface, RectangleGivesTextureCoordinatesFromCornerToCorner) {
    DMat4 place(1.0);
    place[3] = {0.0, 0.0, -2.0, 1.0};
    const auto made = OpenSurface::from(RectangleShape{{4.0, 2.0}}, place);
    ASSERT_TRUE(made);
    const OpenSurface& sheet = made.value();
    EXPECT_DOUBLE_EQ(sheet.area(), 8.0);
    EXPECT_EQ(sheet.plane().normal, DVec3(0.0, 0.0, 1.0));
    const auto hit = sheet.hit({1.0, -0.5, 3.0}, {0.0, 0.0, -1.0}, -1);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->distance, 5.0);
    EXPECT_DOUBLE_EQ(hit->uv.x, 0.75);
    EXPECT_DOUBLE_EQ(hit->uv.y, 0.25);
    EXPECT_TRUE(sheet.hit({1.0, -0.5, -3.0}, {0.0, 0.0, 1.0}, -1)) << "from behind";
    EXPECT_TRUE(sheet.hit({2.0, 1.0, 3.0}, {0.0, 0.0, -1.0}, -1)) << "the corner belongs to it";
    EXPECT_FALSE(sheet.hit({2.001, 0.0, 3.0}, {0.0, 0.0, -1.0}, -1));
    EXPECT_FALSE(sheet.hit({0.0, 0.0, 3.0}, {0.0, 0.0, 1.0}, -1)) << "behind the start";
    EXPECT_FALSE(sheet.hit({0.0, 0.0, 3.0}, {1.0, 0.0, 0.0}, -1)) << "parallel";
    EXPECT_FALSE(sheet.hit({0.0, 0.0, -2.0}, {1.0, 0.0, 0.0}, -1)) << "parallel, within";
    EXPECT_FALSE(sheet.hit({0.0, 0.0, -2.0}, {0.0, 0.0, 1.0}, 0)) << "just left";
}

TEST(OpenSurface, DiskIsRoundAndFollowsShearAndMirror) {
    const OpenSurface disk = OpenSurface::from(DiskShape{2.0}, DMat4(1.0)).value();
    EXPECT_NEAR(disk.area(), 4.0 * pi, 1e-14);
    EXPECT_TRUE(disk.hit({1.4, 1.4, 1.0}, {0.0, 0.0, -1.0}, -1));
    EXPECT_FALSE(disk.hit({1.5, 1.5, 1.0}, {0.0, 0.0, -1.0}, -1));
    DMat4 mirror(1.0);
    mirror[0] = {-1.0, 0.0, 0.0, 0.0};
    mirror[1] = {0.5, 1.0, 0.0, 0.0};
    const OpenSurface ellipse = OpenSurface::from(DiskShape{1.0}, mirror).value();
    EXPECT_EQ(ellipse.plane().normal, DVec3(0.0, 0.0, 1.0));
    // Object point (0, 0.9) lands at (0.45, 0.9).
    const auto hit = ellipse.hit({0.45, 0.9, 1.0}, {0.0, 0.0, -1.0}, -1);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->uv.x, 0.5, 1e-15);
    EXPECT_NEAR(hit->uv.y, 0.95, 1e-15);
    EXPECT_NEAR(ellipse.area(), pi, 1e-14);
}

TEST(OpenSurface, FlatteningTransformsAndImpossibleSizesAreErrors) {
    DMat4 flat(1.0);
    flat[1] = flat[0];
    EXPECT_EQ(OpenSurface::from(RectangleShape{}, flat).error().field, "transform");
    EXPECT_EQ(OpenSurface::from(RectangleShape{{-1.0, 1.0}}, DMat4(1.0)).error().field, "size");
    EXPECT_EQ(OpenSurface::from(DiskShape{0.0}, DMat4(1.0)).error().field, "radius");
}

}  // namespace
}  // namespace pol
