// SPDX-License-Identifier: Apache-2.0
#include "geometry/ray_caster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/random.h"
#include "core/units.h"
#include "geometry/geometry_helpers.h"
#include "geometry/half_space_solid.h"
#include "geometry/mesh_check.h"
#include "geometry/shapes.h"
#include "geometry/watertight.h"

namespace pol {
namespace {

using test::dice;
using test::Dice;

Mesh stone() {
    return make_mesh(BrilliantShape{}).value();
}

RayCaster caster(std::vector<Mesh> meshes) {
    return RayCaster::build(std::move(meshes)).value();
}

// Star-shaped body of n x 2n quads with bumps: closed, smooth-sided, not convex.
Mesh bumpy(int n) {
    std::vector<DVec3> vertices{{0, 0, 1}, {0, 0, -1}};
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const auto id = [n](int ring, int k) { return static_cast<std::uint32_t>(2 + (ring - 1) * 2 * n + k % (2 * n)); };
    for (int ring = 1; ring < n; ++ring) {
        for (int k = 0; k < 2 * n; ++k) {
            const double theta = pi * ring / n;
            const double phi = pi * k / n;
            const double r = 1.0 + 0.3 * std::sin(5.0 * theta) * std::sin(theta) * std::cos(4.0 * phi);
            vertices.emplace_back(r * std::sin(theta) * std::cos(phi), r * std::sin(theta) * std::sin(phi),
                                  r * std::cos(theta));
        }
    }
    for (int k = 0; k < 2 * n; ++k) {
        triangles.push_back({0, id(1, k), id(1, k + 1)});
        triangles.push_back({1, id(n - 1, k + 1), id(n - 1, k)});
        for (int ring = 1; ring < n - 1; ++ring) {
            triangles.push_back({id(ring, k), id(ring + 1, k), id(ring + 1, k + 1)});
            triangles.push_back({id(ring, k), id(ring + 1, k + 1), id(ring, k + 1)});
        }
    }
    return mesh_from_triangles(vertices, triangles).value();
}

// The contract without any search structure.
std::optional<MeshHit> plain_nearest(const Mesh& mesh, const DVec3& o, const DVec3& d) {
    const WatertightRay ray(o, d);
    std::optional<MeshHit> best;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& v = mesh.triangles[t];
        const auto hit = ray.cross(mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]);
        if (hit && hit->distance > 0.0 && (!best || hit->distance < best->distance)) {
            best = MeshHit{0, static_cast<int>(mesh.facet_of_triangle[t]), static_cast<int>(t), hit->distance};
        }
    }
    return best;
}

TEST(Watertight, TellsInFromOutAndMeetsEdgesFromBothSides) {
    const DVec3 a(0, 0, 0);
    const DVec3 b(1, 0, 0);
    const DVec3 c(0, 1, 0);
    const auto down = WatertightRay({0.25, 0.25, 2.0}, {0, 0, -1}).cross(a, b, c);
    ASSERT_TRUE(down);
    EXPECT_EQ(down->distance, 2.0);
    EXPECT_FALSE(down->leaving) << "against the normal +z: enters";
    EXPECT_TRUE(WatertightRay({0.25, 0.25, -2.0}, {0, 0, 1}).cross(a, b, c)->leaving);
    const DVec3 across(1, 1, 0);
    const WatertightRay edge({0.5, 0.5, 1.0}, {0, 0, -1});
    EXPECT_TRUE(edge.cross(a, b, c));
    EXPECT_TRUE(edge.cross(b, across, c));
    EXPECT_FALSE(WatertightRay({0.6, 0.6, 1.0}, {0, 0, -1}).cross(a, b, c));
    for (int axis = 0; axis < 3; ++axis) {
        // The same triangle in all three coordinate planes, from both sides: the permutation keeps the sense.
        const auto turn = [axis](const DVec3& p) { return DVec3(p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]); };
        for (const double side : {-1.0, 1.0}) {
            const auto hit =
                WatertightRay(turn({0.2, 0.2, -side}), turn({0.0, 0.0, side})).cross(turn(a), turn(b), turn(c));
            ASSERT_TRUE(hit);
            EXPECT_EQ(hit->leaving, side > 0.0);
        }
    }
}

TEST(RayCaster, AgreesWithHalfSpacesOnTheSameSolidAtEveryScale) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
        for (const double offset : {0.0, 10.0}) {
            SCOPED_TRACE(scale);
            SCOPED_TRACE(offset);
            DMat4 place(scale);
            place[3] = {offset * scale, -offset * scale, 2.0 * offset * scale, 1.0};
            const Mesh mesh = transformed(stone(), place).value();
            const HalfSpaceSolid solid = HalfSpaceSolid::from_mesh(mesh).value();
            const RayCaster rays = caster({mesh});
            // Coordinates of order (1 + 2 offset) scale, a dozen roundings.
            const double tolerance = 4e-15 * (1.0 + 2.0 * offset) * scale;
            Dice random = dice(4);
            int disagreements = 0;
            for (int i = 0; i < 20000; ++i) {
                const DVec3 outside = solid.center() + 4.0 * solid.radius() * random.direction();
                const DVec3 d = unit(solid.center() + 0.9 * solid.radius() * random.direction() - outside);
                const FacetHit a = solid.enter(outside, d, -1);
                const auto b = rays.nearest(outside, d);
                ASSERT_EQ(static_cast<bool>(a), b.has_value());
                if (!a) continue;
                disagreements += a.facet != b->facet;
                ASSERT_NEAR(a.distance * std::abs(dot(solid.plane(a.facet).normal, d)),
                            b->distance * std::abs(dot(solid.plane(b->facet).normal, d)), tolerance);
                DVec3 o = outside + a.distance * d;
                DVec3 inward = d;
                int left = a.facet;
                int triangle = b->triangle;
                for (int bounce = 0; bounce < 20; ++bounce) {
                    const FacetHit e = solid.exit(o, inward, left);
                    const LeftFacet behind[]{{0, left, triangle}};
                    const auto f = rays.nearest(o, inward, behind);
                    ASSERT_TRUE(e);
                    ASSERT_TRUE(f);
                    disagreements += e.facet != f->facet;
                    if (e.facet != f->facet) break;
                    const DVec3 n = solid.plane(e.facet).normal;
                    ASSERT_NEAR((e.distance - f->distance) * dot(n, inward), 0.0, tolerance);
                    o += e.distance * inward;
                    inward = unit(inward - 2.0 * dot(n, inward) * n);
                    left = e.facet;
                    triangle = f->triangle;
                }
            }
            // Facets may differ only where a ray meets an edge to rounding: chance 1e-14 per hit.
            EXPECT_EQ(disagreements, 0);
        }
    }
}

TEST(RayCaster, FindsWhatAPlainLoopOverAllTrianglesFinds) {
    const Mesh mesh = bumpy(24);
    ASSERT_TRUE(check_closed(mesh));
    ASSERT_FALSE(is_convex(mesh));
    const RayCaster rays = caster({mesh});
    Dice random = dice(5);
    int touches = 0;
    for (int i = 0; i < 20000; ++i) {
        const DVec3 o = 3.0 * random.direction();
        // Every third ray is aimed at a vertex or an edge, often on the silhouette.
        const auto& v = mesh.triangles[static_cast<std::size_t>(i) % mesh.triangles.size()];
        const DVec3 a = mesh.vertices[v[0]];
        const DVec3 aim =
            i % 3 == 0 ? a + (i % 2 == 0 ? 0.0 : random.next()) * (mesh.vertices[v[1]] - a) : 1.1 * random.direction();
        const DVec3 d = aim - o;
        const auto found = rays.nearest(o, d);
        auto expected = plain_nearest(mesh, o, d);
        double passed = 0.0;
        if (i % 3 == 0 && expected && (!found || found->distance - expected->distance > 1e-9)) {
            // Floats may miss a silhouette that is cut less deep than they can tell: then what comes next is right.
            ++touches;
            passed = expected->distance + 1e-5 / std::sqrt(length2(d));
            expected = plain_nearest(mesh, o + passed * d, d);
        }
        ASSERT_EQ(found.has_value(), expected.has_value()) << i;
        if (!found) continue;
        // Interpolated and plane distance differ by rounding over the cosine.
        const auto cosine_at = [&](const MeshHit& h) {
            return std::abs(dot(mesh.facets[static_cast<std::size_t>(h.facet)].normal, unit(d)));
        };
        const double cosine = std::min(cosine_at(*expected), cosine_at(*found));
        ASSERT_NEAR(found->distance, passed + expected->distance, 1e-14 + 4e-15 / cosine) << i;
    }
    EXPECT_LT(touches, 20000 / 3 / 10) << "far fewer than one aimed ray in ten may be such a touch";
}

// A ray inside a closed mesh always finds its way out, and in and out alternate.
void expect_no_leaks(const Mesh& mesh, int count, int bounces, double tolerance) {
    const RayCaster rays = caster({mesh});
    Dice random = dice(6);
    int leaks = 0;
    for (int i = 0; i < count; ++i) {
        random.key.pixel = static_cast<std::uint32_t>(i);
        random.dimension = 0;
        const auto& v = mesh.triangles[static_cast<std::size_t>(i) % mesh.triangles.size()];
        const DVec3 a = mesh.vertices[v[0]];
        const DVec3 aim = a + (i % 2 == 0 ? 0.0 : random.next()) * (mesh.vertices[v[1]] - a);
        DVec3 o = aim + 0.5 * unit(aim) + 0.3 * random.direction();
        DVec3 d = unit(aim - o);
        auto hit = rays.nearest(o, d);
        if (!hit) continue;  // an edge on the silhouette may be missed by rounding
        o += hit->distance * d;
        for (int bounce = 0; bounce < bounces; ++bounce) {
            const Plane* plane = &mesh.facets[static_cast<std::size_t>(hit->facet)];
            const LeftFacet behind[]{{0, hit->facet, hit->triangle}};
            hit = rays.nearest(o, d, behind);
            if (!hit || hit->facet == behind[0].facet || hit->distance < -1e-6) {
                ++leaks;
                break;
            }
            o += hit->distance * d;
            plane = &mesh.facets[static_cast<std::size_t>(hit->facet)];
            if (std::abs(dot(plane->normal, o) - plane->offset) > tolerance) ++leaks;
            d = unit(d - 2.0 * dot(plane->normal, d) * plane->normal);
            // Grazing reflection that rounding turns outward: nothing is inside any more.
            if (dot(plane->normal, d) >= 0.0) break;
        }
    }
    EXPECT_EQ(leaks, 0);
}

TEST(RayCaster, OneMillionRaysAimedAtEdgesAndCornersNeverLeak) {
    // Coordinates of order 1, a dozen roundings.
    expect_no_leaks(stone(), 1000000, 1, 4e-15);
}

// Where both facets of an edge face the ray, its line goes deep into the stone: there is no excuse to miss.
TEST(RayCaster, RaysAimedAtEdgesBetweenTwoVisibleFacetsMeetThem) {
    const Mesh mesh = stone();
    const RayCaster rays = caster({mesh});
    Dice random = dice(9);
    int aimed = 0;
    for (int i = 0; i < 300000; ++i) {
        random.key.pixel = static_cast<std::uint32_t>(i);
        random.dimension = 0;
        const auto& v = mesh.triangles[static_cast<std::size_t>(i) % mesh.triangles.size()];
        const DVec3 a = mesh.vertices[v[0]];
        const DVec3 aim = a + (i % 4 == 0 ? 0.0 : random.next()) * (mesh.vertices[v[1]] - a);
        const DVec3 o = aim + 0.5 * unit(aim) + 0.3 * random.direction();
        const DVec3 d = unit(aim - o);
        const bool visible = std::all_of(mesh.facets.begin(), mesh.facets.end(), [&](const Plane& plane) {
            return std::abs(dot(plane.normal, aim) - plane.offset) > 1e-9 || dot(plane.normal, d) < -0.05;
        });
        if (!visible) continue;
        ++aimed;
        const auto hit = rays.nearest(o, d);
        ASSERT_TRUE(hit) << i;
        // A dozen roundings of numbers of order 1 over a cosine of 0.05.
        ASSERT_NEAR(hit->distance, glm::length(aim - o), 5e-14) << i;
    }
    EXPECT_GT(aimed, 100000);
}

// An open sheet has no inside whose parity could show that floats took the wrong side of the diagonal.
TEST(RayCaster, NoRaySlipsThroughTheDiagonalOfAnOpenSheet) {
    DMat4 tilted(1.0);
    tilted[0] = {0.9, 0.1, 0.3, 0.0};
    tilted[1] = {-0.2, 1.1, 0.4, 0.0};
    tilted[3] = {0.3, 0.7, -0.1, 1.0};
    const Mesh sheet = transformed(make_mesh(RectangleShape{}).value(), tilted).value();
    const RayCaster rays = caster({sheet});
    Dice random = dice(12);
    for (int i = 0; i < 100000; ++i) {
        const DVec3 aim = sheet.vertices[0] + (0.001 + 0.998 * random.next()) * (sheet.vertices[2] - sheet.vertices[0]);
        const DVec3 o = aim + 2.0 * random.direction();
        if (std::abs(dot(sheet.facets[0].normal, o) - sheet.facets[0].offset) < 0.05) continue;
        ASSERT_TRUE(rays.nearest(o, aim - o)) << i;
    }
}

// A ray inside that is aimed at corners may leave there and come in again beyond: the first way out counts.
TEST(RayCaster, FromInsideANonConvexSolidTheFirstWayOutIsFound) {
    const Mesh mesh = bumpy(8);
    ASSERT_FALSE(is_convex(mesh));
    const RayCaster rays = caster({mesh});
    Dice random = dice(13);
    const LeftFacet inside[]{{0, -1, -1}};
    int touches = 0;
    for (int i = 0; i < 200000; ++i) {
        random.key.pixel = static_cast<std::uint32_t>(i);
        random.dimension = 0;
        const DVec3 aim = mesh.vertices[static_cast<std::size_t>(i) % mesh.vertices.size()];
        const DVec3 o = 0.9 * random.next() * mesh.vertices[static_cast<std::size_t>(random.next() * 100.0)];
        const DVec3 d = unit(aim - o);
        const auto found = rays.nearest(o, d, inside);
        const auto expected = plain_nearest(mesh, o, d);
        ASSERT_TRUE(found);
        ASSERT_TRUE(expected);
        const auto cosine_at = [&](const MeshHit& h) {
            return std::abs(dot(mesh.facets[static_cast<std::size_t>(h.facet)].normal, d));
        };
        // Interpolated and plane distance differ by rounding over the cosine.
        const double tolerance = 1e-14 + 4e-15 / std::min(cosine_at(*expected), cosine_at(*found));
        if (std::abs(found->distance - expected->distance) <= tolerance) continue;
        // The one excuse: the corner is only touched, the ray is inside again (and was before) within 1e-6.
        ++touches;
        const DVec3 beyond = o + (expected->distance + 1e-6) * d;
        ASSERT_TRUE(encloses(mesh, beyond)) << i;
    }
    EXPECT_LT(touches, 200);
}

// Open surfaces have no in and out that could help: only the skipped facet keeps a ray from the sheet it starts on.
TEST(RayCaster, BetweenTwoOpenSheetsARayNeverMeetsTheOneItHasJustLeft) {
    const Mesh sheet = make_mesh(RectangleShape{{100.0, 100.0}}).value();
    DMat4 tilted(1.0);
    tilted[0] = {0.9, 0.1, 0.3, 0.0};
    tilted[1] = {-0.2, 1.1, 0.4, 0.0};
    DMat4 above = tilted;
    above[3] = {0.1, 0.2, 1.0 / 3.0, 1.0};
    const RayCaster rays = caster({transformed(sheet, tilted).value(), transformed(sheet, above).value()});
    const DVec3 normal = rays.mesh(0).facets[0].normal;
    Dice random = dice(10);
    for (int chain = 0; chain < 2000; ++chain) {
        DVec3 o(0.05, 0.1, 1.0 / 6.0);
        DVec3 d = unit(random.direction() + 3.0 * normal);
        int expected = 1;
        std::vector<LeftFacet> left;
        for (int bounce = 0; bounce < 20; ++bounce, expected = 1 - expected) {
            const auto hit = rays.nearest(o, d, left);
            ASSERT_TRUE(hit);
            ASSERT_EQ(hit->mesh, expected);
            o += hit->distance * d;
            d -= 2.0 * dot(normal, d) * normal;
            left = {{hit->mesh, hit->facet, hit->triangle}};
        }
    }
}

TEST(RayCaster, ChainsOfTwentyReflectionsFromEdgesAndCornersNeverLeak) {
    expect_no_leaks(stone(), 20000, 20, 4e-15);
    expect_no_leaks(bumpy(24), 10000, 20, 4e-15);
}

TEST(RayCaster, MovedFarAwayTheStoneStillHoldsItsLight) {
    DMat4 place(1e-3);
    place[3] = {1.0, 1.0, 1.0, 1.0};
    const Mesh mesh = transformed(stone(), place).value();
    // Vertices are rounded to 1e-16 of a coordinate 1; the facets stay where they are to that.
    expect_no_leaks(mesh, 20000, 1, 4e-15);
}

TEST(RayCaster, SkipsTheFacetJustLeftOfBothTouchingMeshes) {
    // Two unit cubes face to face at x = 0.5.
    const Mesh cube = make_mesh(BoxShape{}).value();
    DMat4 beside(1.0);
    beside[3] = {1.0, 0.0, 0.0, 1.0};
    const RayCaster rays = caster({cube, transformed(cube, beside).value()});
    const DVec3 o(0.5, 0.1, 0.2);
    const LeftFacet both[]{{0, 1, -1}, {1, 0, -1}};
    const auto hit = rays.nearest(o, {1.0, 0.0, 0.0}, both);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->mesh, 1);
    EXPECT_EQ(hit->facet, 1);
    EXPECT_DOUBLE_EQ(hit->distance, 1.0);
    const auto from_far = rays.nearest({-100.0, 0.1, 0.2}, {2.0, 0.0, 0.0});
    ASSERT_TRUE(from_far);
    EXPECT_EQ(from_far->mesh, 0);
    EXPECT_EQ(from_far->facet, 0);
    EXPECT_DOUBLE_EQ(from_far->distance, 49.75);
    EXPECT_FALSE(rays.nearest({-100.0, 0.1, 0.2}, {-1.0, 0.0, 0.0}));
    EXPECT_TRUE(rays.contains(0, {0.49, 0.0, 0.0}));
    EXPECT_FALSE(rays.contains(0, {0.51, 0.0, 0.0}));
    EXPECT_TRUE(rays.contains(1, {0.51, 0.0, 0.0}));
    EXPECT_EQ(rays.mesh_count(), 2);
}

TEST(RayCaster, SurfacesCloserThanFloatsCanTellAreMetInTheirTrueOrder) {
    // Sheets a distance 1e-9 apart; float32 sees one.
    Mesh near = make_mesh(RectangleShape{}).value();
    Mesh far = near;
    for (DVec3& p : far.vertices) p.z -= 1e-9;
    far.facets[0].offset = -1e-9;
    const RayCaster rays = caster({far, near});
    Dice random = dice(8);
    for (int i = 0; i < 1000; ++i) {
        const DVec3 aim(0.9 * (random.next() - 0.5), 0.9 * (random.next() - 0.5), 0.0);
        const DVec3 o = aim + DVec3(random.next() - 0.5, random.next() - 0.5, 1.0);
        const auto down = rays.nearest(o, unit(aim - o));
        ASSERT_TRUE(down);
        EXPECT_EQ(down->mesh, 1);
        const DVec3 below(o.x, o.y, -o.z);
        const auto up = rays.nearest(below, unit(aim - below));
        ASSERT_TRUE(up);
        EXPECT_EQ(up->mesh, 0);
    }
}

// In one Embree scene the stone would be a point: a float knows 1e7 to 1.
TEST(RayCaster, OneChipFarAwayHidesNothing) {
    const Mesh body = bumpy(12);
    DMat4 away(0.1);
    away[3] = {1e7, 2e7, 0.0, 1.0};
    const Mesh chip = transformed(stone(), away).value();
    Mesh both = body;
    test::append(both, chip);
    const RayCaster alone = caster({body});
    const RayCaster one_file = caster({both});
    const RayCaster two_files = caster({body, chip});
    Dice random = dice(77);
    for (int i = 0; i < 2000; ++i) {
        const DVec3 o = 3.0 * random.direction();
        const DVec3 d = unit(1.1 * random.direction() - o);
        const auto expected = alone.nearest(o, d);
        for (const RayCaster* with_chip : {&one_file, &two_files}) {
            const auto hit = with_chip->nearest(o, d);
            ASSERT_EQ(hit.has_value(), expected.has_value());
            if (!hit) continue;
            ASSERT_EQ(hit->triangle, expected->triangle);
            ASSERT_EQ(hit->distance, expected->distance);
        }
    }
    const DVec3 at_chip = DVec3(away[3]) - DVec3(5.0, 0.0, 0.0);
    EXPECT_TRUE(one_file.nearest(at_chip, {1.0, 0.0, 0.0}));
    EXPECT_TRUE(two_files.nearest(at_chip, {1.0, 0.0, 0.0}));
}

TEST(RayCaster, NothingToTraceIsAnError) {
    EXPECT_FALSE(RayCaster::build({}));
    Mesh broken = stone();
    broken.vertices[3].x = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(RayCaster::build({broken}));
}

}  // namespace
}  // namespace pol
