// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/units.h"
#include "geometry/half_space_solid.h"
#include "geometry/mesh_check.h"

namespace pol {
namespace {

// Rounding of a sum of a few hundred products of numbers of order 1.
constexpr double rounding = 1e-13;

void expect_sound(const Mesh& mesh) {
    const Result<Done> closed = check_closed(mesh);
    EXPECT_TRUE(closed) << (closed ? "" : to_string(closed.error()));
    ASSERT_EQ(mesh.triangles.size(), mesh.facet_of_triangle.size());
    // Euler: V - E + F = 2 with 3 F = 2 E.
    EXPECT_EQ(2 * mesh.vertices.size(), mesh.triangles.size() + 4);
    double size = 0.0;
    for (const DVec3& p : mesh.vertices) size = std::max(size, glm::length(p));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Plane& plane = mesh.facets[mesh.facet_of_triangle[t]];
        const auto& v = mesh.triangles[t];
        EXPECT_NEAR(std::sqrt(length2(plane.normal)), 1.0, 1e-15);
        const DVec3 area = cross(mesh.vertices[v[1]] - mesh.vertices[v[0]], mesh.vertices[v[2]] - mesh.vertices[v[0]]);
        EXPECT_GT(dot(area, plane.normal), 0.0);
        for (const std::uint32_t p : v) {
            EXPECT_NEAR(dot(plane.normal, mesh.vertices[p]), plane.offset, 1e-14 * size);
        }
    }
}

TEST(Shapes, BoxHasSixFacesAndItsVolume) {
    const Mesh mesh = make_mesh(BoxShape{{2.0, 3.0, 0.5}}).value();
    expect_sound(mesh);
    EXPECT_EQ(mesh.facets.size(), 6U);
    EXPECT_EQ(mesh.vertices.size(), 8U);
    EXPECT_NEAR(signed_volume(mesh), 3.0, rounding);
    EXPECT_EQ(mesh.facets[0].normal, DVec3(-1.0, 0.0, 0.0));
    EXPECT_EQ(mesh.facets[5].normal, DVec3(0.0, 0.0, 1.0));
    EXPECT_EQ(mesh.facets[3].offset, 1.5);
}

TEST(Shapes, BrilliantHas73FacetsMeetingInTheirClassicalCorners) {
    const Mesh mesh = make_mesh(BrilliantShape{}).value();
    expect_sound(mesh);
    EXPECT_EQ(mesh.facets.size(), 73U);
    // 8 at the table, 8 below the stars, 16 above and 16 below the girdle, 8 between mains and lower halves, culet.
    EXPECT_EQ(mesh.vertices.size(), 57U);
    double top = 0.0;
    double bottom = 0.0;
    double girdle = 0.0;
    for (const DVec3& p : mesh.vertices) {
        top = std::max(top, p.z);
        bottom = std::min(bottom, p.z);
        girdle = std::max(girdle, std::hypot(p.x, p.y));
    }
    // Depths follow from ratios and angles: 43 % of the radius at 34.5 degrees, the whole radius at 40.75 degrees.
    EXPECT_NEAR(top, 0.03 + 0.43 * std::tan(radians(34.5)), rounding);
    EXPECT_NEAR(bottom, -0.03 - std::tan(radians(40.75)), rounding);
    EXPECT_NEAR(girdle, 1.0, rounding);
    // Regular octagon of circumradius 0.57.
    double table = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (mesh.facet_of_triangle[t] != 0) continue;
        const auto& v = mesh.triangles[t];
        table += 0.5 * std::sqrt(length2(cross(mesh.vertices[v[1]] - mesh.vertices[v[0]],
                                               mesh.vertices[v[2]] - mesh.vertices[v[0]])));
    }
    EXPECT_NEAR(table, 2.0 * std::sqrt(2.0) * 0.57 * 0.57, rounding);
    EXPECT_NEAR(degrees(std::acos(mesh.facets[1].normal.z)), 34.5, 1e-12);
    EXPECT_NEAR(degrees(std::acos(-mesh.facets[65].normal.z)), 40.75, 1e-12);
}

TEST(Shapes, BrilliantKeepsIts73FacetsOverTheProportionsThatCuttersUse) {
    for (const double table : {0.45, 0.55, 0.65}) {
        for (const double crown : {25.0, 34.5, 40.0}) {
            for (const double pavilion : {38.0, 43.0}) {
                for (const double girdle : {0.005, 0.08}) {
                    for (const double star : {0.45, 0.65}) {
                        for (const double lower : {0.6, 0.9}) {
                            const auto mesh = make_mesh(
                                BrilliantShape{6.5, table, radians(crown), radians(pavilion), girdle, star, lower});
                            ASSERT_TRUE(mesh) << to_string(mesh.error());
                            EXPECT_EQ(mesh.value().facets.size(), 73U);
                            EXPECT_EQ(mesh.value().vertices.size(), 57U);
                        }
                    }
                }
            }
        }
    }
}

TEST(Shapes, PrismHasItsApexAngleAndVolume) {
    const double apex = radians(60.0);
    const Mesh mesh = make_mesh(PrismShape{apex, 2.0, 3.0}).value();
    expect_sound(mesh);
    EXPECT_EQ(mesh.facets.size(), 5U);
    EXPECT_NEAR(signed_volume(mesh), 0.5 * 4.0 * std::sin(apex) * 3.0, rounding);
    // Legs are facets 3 and 4; their normals enclose 180 degrees minus the apex.
    EXPECT_NEAR(dot(mesh.facets[3].normal, mesh.facets[4].normal), -std::cos(apex), rounding);
    EXPECT_EQ(mesh.facets[2].normal, DVec3(0.0, -1.0, 0.0));
}

// The path through the rhomb, traced through the solid: axial ray, incidence `angle` twice, out along the axis.
TEST(Shapes, RhombLeadsTheAxialRayFromTheMiddleOfOneEndToTheMiddleOfTheOther) {
    for (const double angle_degrees : {48.6, 54.6, 60.0, 75.0}) {
        SCOPED_TRACE(angle_degrees);
        const double angle = radians(angle_degrees);
        const Mesh mesh = make_mesh(RhombShape{angle, 1.0, 1.0}).value();
        expect_sound(mesh);
        const HalfSpaceSolid solid = HalfSpaceSolid::from_mesh(mesh).value();
        const double entrance_x = -solid.plane(5).offset;
        ASSERT_NEAR(solid.plane(5).normal.x, -1.0, 1e-15);
        double middle_y = 0.0;
        for (const DVec3& p : solid.vertices()) {
            if (std::abs(p.x - entrance_x) < 1e-9) middle_y += p.y / 4.0;
        }
        DVec3 o(entrance_x, middle_y, 0.0);
        DVec3 d(1.0, 0.0, 0.0);
        int left = 5;
        for (const int expected : {2, 4}) {
            const FacetHit hit = solid.exit(o, d, left);
            ASSERT_EQ(hit.facet, expected);
            const DVec3 n = solid.plane(hit.facet).normal;
            EXPECT_NEAR(std::acos(dot(n, d)), angle, 1e-14);
            o += hit.distance * d;
            d -= 2.0 * dot(n, d) * n;
            left = hit.facet;
        }
        const FacetHit out = solid.exit(o, d, left);
        EXPECT_EQ(out.facet, 3);
        EXPECT_NEAR(d.x, 1.0, 1e-15);
        EXPECT_NEAR((o + out.distance * d).y, -middle_y, 1e-14);
    }
}

TEST(Shapes, ExtrusionOfAHexagonHasItsVolume) {
    ExtrusionShape hexagon;
    for (int k = 0; k < 6; ++k) hexagon.polygon.emplace_back(std::cos(k * pi / 3.0), std::sin(k * pi / 3.0));
    hexagon.height = 0.25;
    const Mesh mesh = make_mesh(hexagon).value();
    expect_sound(mesh);
    EXPECT_EQ(mesh.facets.size(), 8U);
    EXPECT_NEAR(signed_volume(mesh), 1.5 * std::sqrt(3.0) * 0.25, rounding);
}

TEST(Shapes, ImpossibleParametersNameTheirField) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    const auto field = [](const Shape& shape) {
        const auto mesh = make_mesh(shape);
        return mesh ? std::string("no error") : mesh.error().field;
    };
    BrilliantShape stone;
    stone.crown_angle = radians(90.0);
    EXPECT_EQ(field(stone), "crown_angle");
    stone = {};
    stone.diameter = nan;
    EXPECT_EQ(field(stone), "diameter");
    stone = {};
    stone.star_length = 0.1;
    EXPECT_EQ(field(stone), "star_length");
    stone = {};
    stone.girdle_ratio = 0.0;
    EXPECT_EQ(field(stone), "girdle_ratio");
    EXPECT_EQ(field(BoxShape{{1.0, -1.0, 1.0}}), "size");
    EXPECT_EQ(field(BoxShape{{1.0, inf, 1.0}}), "size");
    EXPECT_EQ(field(PrismShape{0.0, 1.0, 1.0}), "apex_angle");
    EXPECT_EQ(field(PrismShape{1.0, 1.0, 0.0}), "height");
    EXPECT_EQ(field(RhombShape{radians(30.0), 1.0, 1.0}), "angle");
    EXPECT_EQ(field(RectangleShape{{0.0, 1.0}}), "size");
    EXPECT_EQ(field(ExtrusionShape{{{0, 0}, {1, 0}}, 1.0}), "polygon");
    EXPECT_EQ(field(ExtrusionShape{{{0, 0}, {0, 1}, {1, 0}}, 1.0}), "polygon[1]") << "clockwise";
    EXPECT_EQ(field(ExtrusionShape{{{0, 0}, {1, 0}, {0.1, 0.1}, {0, 1}}, 1.0}), "polygon[2]") << "not convex";
    // A pentagram turns left everywhere, but twice around.
    ExtrusionShape star;
    for (int k = 0; k < 5; ++k) star.polygon.emplace_back(std::cos(k * 0.8 * pi), std::sin(k * 0.8 * pi));
    EXPECT_EQ(field(star), "polygon");
}

TEST(Shapes, MirroredSolidsKeepTheirNormalsOutward) {
    DMat4 mirror(1.0);
    mirror[0] = {-2.0, 0.0, 0.0, 0.0};
    mirror[1] = {0.3, 1.0, 0.0, 0.0};
    mirror[3] = {5.0, -7.0, 11.0, 1.0};
    const Mesh stone = make_mesh(BrilliantShape{}).value();
    const Mesh moved = transformed(stone, mirror).value();
    EXPECT_TRUE(check_closed(moved));
    // |det| = 2.
    EXPECT_NEAR(signed_volume(moved), 2.0 * signed_volume(stone), 1e-12);
    for (std::size_t t = 0; t < moved.triangles.size(); ++t) {
        for (const std::uint32_t p : moved.triangles[t]) {
            const Plane& plane = moved.facets[moved.facet_of_triangle[t]];
            // Coordinates of order 10, a dozen operations.
            EXPECT_NEAR(dot(plane.normal, moved.vertices[p]), plane.offset, 3e-14);
        }
    }
    EXPECT_TRUE(is_convex(moved));
}

TEST(Shapes, SingularOrProjectiveTransformsAreErrors) {
    const Mesh box = make_mesh(BoxShape{}).value();
    DMat4 flat(1.0);
    flat[2][2] = 0.0;
    EXPECT_FALSE(transformed(box, flat));
    DMat4 projective(1.0);
    projective[0][3] = 0.1;
    EXPECT_FALSE(transformed(box, projective));
    DMat4 nan(1.0);
    nan[3][0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(transformed(box, nan));
    DMat4 tiny(1e-6);
    tiny[3][3] = 1.0;
    EXPECT_TRUE(transformed(box, tiny)) << "small is not singular";
}

}  // namespace
}  // namespace pol
