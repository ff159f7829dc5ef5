// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/geometry_helpers.h"
#include "geometry/shapes.h"

namespace pol {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// Each triangle with corners of its own, rounded to float32, as a viewer's export has them.
Result<Mesh> as_if_exported(const Mesh& mesh) {
    std::vector<DVec3> vertices;
    Triangles triangles;
    for (const auto& v : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(vertices.size());
        for (const std::uint32_t p : v) {
            const glm::vec3 rounded(mesh.vertices[p]);
            vertices.emplace_back(rounded);
        }
        triangles.push_back({first, first + 1, first + 2});
    }
    return mesh_from_triangles(vertices, triangles);
}

// Through a volatile: optimized, GCC 12 takes DVec3(glm::vec3(p)) for p.
DVec3 as_float32(DVec3 p) {
    for (int i = 0; i < 3; ++i) {
        const volatile float rounded = static_cast<float>(p[i]);
        p[i] = static_cast<double>(rounded);
    }
    return p;
}

std::vector<DVec3> tetrahedron() {
    return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
}
Triangles tetrahedron_faces() {
    return {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
}

std::string complaint_about(const std::vector<DVec3>& vertices, const Triangles& triangles) {
    const auto mesh = mesh_from_triangles(vertices, triangles);
    if (!mesh) return mesh.error().what;
    const auto closed = check_closed(mesh.value());
    return closed ? "" : closed.error().what;
}

TEST(MeshCheck, Float32SoupOfABrilliantHasIts73PlanesAgain) {
    const Mesh exact = make_mesh(BrilliantShape{}).value();
    const auto found = as_if_exported(exact);
    ASSERT_TRUE(found) << to_string(found.error());
    EXPECT_EQ(found.value().facets.size(), 73U);
    EXPECT_EQ(found.value().vertices.size(), 57U);
    EXPECT_TRUE(check_closed(found.value()));
    EXPECT_TRUE(is_convex(found.value()));
    for (const Plane& plane : exact.facets) {
        double best = 1.0;
        for (const Plane& candidate : found.value().facets) {
            best = std::min(best, std::sqrt(length2(candidate.normal - plane.normal)));
        }
        // Corners off by 6e-8 over facets at least 0.03 wide (the girdle).
        EXPECT_LT(best, 2.0 * 6e-8 / 0.03);
    }
}

TEST(MeshCheck, SmoothMeshesKeepOneFacetPerTriangle) {
    // A cone of 5000 sides, 1 rad per radius: neighbors differ by 1e-3 rad, sagitta 1e-3 * 1e-3: above tolerance.
    constexpr std::uint32_t sides = 5000;
    std::vector<DVec3> vertices{{0, 0, 1}, {0, 0, 0}};
    Triangles triangles;
    for (std::uint32_t k = 0; k < sides; ++k) {
        const double azimuth = 2.0 * 3.14159265358979 * k / sides;
        vertices.emplace_back(std::cos(azimuth), std::sin(azimuth), 0.0);
        const std::uint32_t here = 2 + k;
        const std::uint32_t next = 2 + (k + 1) % sides;
        triangles.push_back({0, here, next});
        triangles.push_back({1, next, here});
    }
    const Mesh mesh = mesh_from_triangles(vertices, triangles).value();
    // 5000 flanks (or, at worst, pairs of them merged) and one base.
    EXPECT_GT(mesh.facets.size(), sides / 2);
    EXPECT_TRUE(check_closed(mesh));
    EXPECT_TRUE(is_convex(mesh));
}

// Neighbors bend by 0.07 rad, wherever the ball is: 1e6 radii out a double is still good to 1e-10. The same ball as
// 32-bit numbers is rough to 6e-5 of its radius at 1e3, a tenth of what one of its 5120 triangles bulges.
TEST(MeshCheck, ABallKeepsItsFacetsHoweverFarItIs) {
    for (const double distance : {0.0, 1e3, 2e3, 1e6}) {
        const test::Triangles ball = test::icosphere(4, {distance, -0.3 * distance, 0.0});
        const Mesh mesh = mesh_from_triangles(ball.vertices, ball.triangles).value();
        EXPECT_EQ(mesh.facets.size(), 5120U) << distance;
        EXPECT_TRUE(check_closed(mesh)) << distance;
    }
    test::Triangles rough = test::icosphere(4, {1e3, 0.0, 0.0});
    for (DVec3& p : rough.vertices) p = as_float32(p);
    EXPECT_EQ(mesh_from_triangles(rough.vertices, rough.triangles).value().facets.size(), 5120U);
}

// A ball of fifty million triangles bends by 5e-4 rad from one to the next and bulges by less than 1e-7 of its radius.
// A strip of it:
TEST(MeshCheck, FineTrianglesAreNotFlattened) {
    std::vector<DVec3> vertices{{0.0, 0.0, 1.0}};  // an apex makes the piece as large as the ball
    Triangles triangles;
    for (std::uint32_t k = 0; k <= 50; ++k) {
        const double angle = 5e-4 * k;
        vertices.emplace_back(std::sin(angle), 0.0, -std::cos(angle));
        vertices.emplace_back(std::sin(angle), 5e-4, -std::cos(angle));
    }
    for (std::uint32_t k = 0; k < 50; ++k) triangles.push_back({2 * k + 1, 2 * k + 2, 2 * k + 3});
    for (std::uint32_t k = 0; k < 50; ++k) triangles.push_back({2 * k + 3, 2 * k + 2, 2 * k + 4});
    triangles.push_back({0, 1, 2});
    const Mesh mesh = mesh_from_triangles(vertices, triangles).value();
    EXPECT_EQ(mesh.facets.size(), 51U);
}

TEST(MeshCheck, OneChipFarAwayChangesNoOtherFacet) {
    test::Triangles ball = test::icosphere(3, DVec3(0.0));
    const auto first = static_cast<std::uint32_t>(ball.vertices.size());
    for (const DVec3& corner : tetrahedron()) ball.vertices.push_back(corner + DVec3(1e7, 0.0, 0.0));
    for (const auto& t : tetrahedron_faces()) ball.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    const auto mesh = mesh_from_triangles(ball.vertices, ball.triangles);
    ASSERT_TRUE(mesh) << to_string(mesh.error());
    EXPECT_EQ(mesh.value().facets.size(), 1280U + 4U);
    EXPECT_EQ(mesh.value().vertices.size(), first + 4U);
}

// At 2e6 the 32-bit numbers are 0.125 apart: a sixteenth of the ball.
TEST(MeshCheck, NumbersTooCoarseForTheirPieceAreRefused) {
    test::Triangles ball = test::icosphere(2, {2e6, 0.0, 0.0});
    for (DVec3& p : ball.vertices) p = as_float32(p);
    const std::string what = complaint_about(ball.vertices, ball.triangles);
    EXPECT_NE(what.find("32-bit numbers, too coarse"), std::string::npos) << what;
    EXPECT_NE(what.find("(1999999.5, "), std::string::npos) << what;
}

TEST(MeshCheck, SoundTetrahedronPasses) {
    EXPECT_EQ(complaint_about(tetrahedron(), tetrahedron_faces()), "");
    EXPECT_NEAR(signed_volume(mesh_from_triangles(tetrahedron(), tetrahedron_faces()).value()), 1.0 / 6.0, 1e-16);
}

TEST(MeshCheck, AHoleNamesItsEdgeAndTriangle) {
    Triangles open = tetrahedron_faces();
    open.pop_back();
    const std::string what = complaint_about(tetrahedron(), open);
    EXPECT_NE(what.find("hole"), std::string::npos) << what;
    EXPECT_NE(what.find("vertex 0 (0, 0, 0) to vertex 2 (0, 1, 0)"), std::string::npos) << what;
    EXPECT_NE(what.find("triangle 0 alone"), std::string::npos) << what;
}

TEST(MeshCheck, AnInsideOutMeshIsNamedSo) {
    Triangles inverted = tetrahedron_faces();
    for (auto& t : inverted) std::swap(t[1], t[2]);
    EXPECT_NE(complaint_about(tetrahedron(), inverted).find("inside out"), std::string::npos);
}

TEST(MeshCheck, OneTurnedTriangleIsFound) {
    Triangles turned = tetrahedron_faces();
    std::swap(turned[2][0], turned[2][1]);
    const std::string what = complaint_about(tetrahedron(), turned);
    EXPECT_NE(what.find("same direction"), std::string::npos) << what;
    EXPECT_NE(what.find("2"), std::string::npos) << what;
}

TEST(MeshCheck, DegenerateTrianglesAreNamed) {
    Triangles faces = tetrahedron_faces();
    faces.push_back({1, 1, 2});
    EXPECT_NE(complaint_about(tetrahedron(), faces).find("triangle 4 is degenerate"), std::string::npos);
    std::vector<DVec3> corners = tetrahedron();
    corners.emplace_back(0.5, 0.0, 0.0);
    faces.back() = {0, 4, 1};
    EXPECT_NE(complaint_about(corners, faces).find("triangle 4 is degenerate"), std::string::npos) << "three in line";
}

TEST(MeshCheck, DuplicateFacesAreNamed) {
    Triangles faces = tetrahedron_faces();
    faces.push_back({3, 1, 0});
    EXPECT_NE(complaint_about(tetrahedron(), faces).find("triangles 1 and 4 have the same corners"), std::string::npos);
}

TEST(MeshCheck, BadNumbersAreNamed) {
    std::vector<DVec3> corners = tetrahedron();
    corners[2].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(complaint_about(corners, tetrahedron_faces()).find("vertex 2 is not finite"), std::string::npos);
    Triangles faces = tetrahedron_faces();
    faces[3][2] = 9;
    EXPECT_NE(complaint_about(tetrahedron(), faces).find("triangle 3 uses vertex 9 of 4"), std::string::npos);
    EXPECT_NE(complaint_about(tetrahedron(), {}).find("no triangles"), std::string::npos);
    corners = tetrahedron();
    corners[1].x = 1e200;
    EXPECT_NE(complaint_about(corners, tetrahedron_faces()), "");
}

TEST(MeshCheck, NonManifoldEdgesAreFound) {
    // Two tetrahedra back to back along the edge 0-1.
    std::vector<DVec3> corners = tetrahedron();
    corners.insert(corners.end(), {{0, -1, 0}, {0, 0, -1}});
    Triangles faces = tetrahedron_faces();
    for (const auto& t : tetrahedron_faces()) {
        std::array<std::uint32_t, 3> moved = t;
        for (auto& v : moved) v = v >= 2 ? v + 2 : v;
        faces.push_back(moved);
    }
    EXPECT_NE(complaint_about(corners, faces).find("same direction by triangles"), std::string::npos);
}

}  // namespace
}  // namespace pol
