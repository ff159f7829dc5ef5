// SPDX-License-Identifier: Apache-2.0
#include "geometry/half_space_solid.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "core/random.h"
#include "core/units.h"
#include "geometry/geometry_helpers.h"
#include "geometry/mesh_check.h"
#include "geometry/shapes.h"

namespace pol {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using test::dice;
using test::Dice;

// A point strictly inside: a random mean of all vertices.
DVec3 point_inside(const HalfSpaceSolid& solid, Dice& random) {
    DVec3 sum(0.0);
    double weights = 0.0;
    for (const DVec3& p : solid.vertices()) {
        const double weight = -std::log(1.0 - random.next()) + 1e-3;
        sum += weight * p;
        weights += weight;
    }
    return sum / weights;
}

HalfSpaceSolid brilliant() {
    return HalfSpaceSolid::from_mesh(make_mesh(BrilliantShape{}).value()).value();
}

// The contract, written as plainly as it can be.
FacetHit plain_exit(const HalfSpaceSolid& solid, const DVec3& o, const DVec3& d, int skip) {
    FacetHit best{infinity, -1};
    for (int i = 0; i < solid.facet_count(); ++i) {
        const Plane& p = solid.plane(i);
        const double along = (p.normal.x * d.x + p.normal.y * d.y) + p.normal.z * d.z;
        const double ahead = p.offset - ((p.normal.x * o.x + p.normal.y * o.y) + p.normal.z * o.z);
        if (i != skip && along > 0.0 && ahead / along < best.distance) best = {ahead / along, i};
    }
    return best;
}

FacetHit plain_enter(const HalfSpaceSolid& solid, const DVec3& o, const DVec3& d) {
    FacetHit near{-infinity, -1};
    double far = infinity;
    for (int i = 0; i < solid.facet_count(); ++i) {
        const Plane& p = solid.plane(i);
        const double along = (p.normal.x * d.x + p.normal.y * d.y) + p.normal.z * d.z;
        const double ahead = p.offset - ((p.normal.x * o.x + p.normal.y * o.y) + p.normal.z * o.z);
        if (along < 0.0 && ahead / along > near.distance) near = {ahead / along, i};
        if (along > 0.0) far = std::min(far, ahead / along);
        if (along == 0.0 && ahead < 0.0) return {};
    }
    return near.distance <= far && near.distance + far > 0.0 ? near : FacetHit{};
}

struct EveryTarget {
    ~EveryTarget() { hwy::SetSupportedTargetsForTest(0); }
};

TEST(HalfSpaceSolid, EveryInstructionSetGivesTheBitsOfThePlainLoop) {
    const EveryTarget restore;
    // Facet counts that fill registers of every width unevenly: 5, 6, 8, 73.
    std::vector<HalfSpaceSolid> solids{brilliant()};
    solids.push_back(HalfSpaceSolid::from_mesh(make_mesh(BoxShape{}).value()).value());
    solids.push_back(HalfSpaceSolid::from_mesh(make_mesh(PrismShape{1.0, 1.0, 1.0}).value()).value());
    ExtrusionShape hexagon;
    for (int k = 0; k < 6; ++k) hexagon.polygon.emplace_back(std::cos(k * pi / 3.0), std::sin(k * pi / 3.0));
    solids.push_back(HalfSpaceSolid::from_mesh(make_mesh(hexagon).value()).value());
    int targets = 0;
    for (std::int64_t bits = hwy::SupportedTargets(); bits != 0; bits &= bits - 1) {
        const std::int64_t target = bits & -bits;
        SCOPED_TRACE(hwy::TargetName(target));
        hwy::SetSupportedTargetsForTest(target);
        ++targets;
        Dice random = dice(1);
        for (const HalfSpaceSolid& solid : solids) {
            for (int i = 0; i < 20000; ++i) {
                const DVec3 o = point_inside(solid, random);
                // Axis-parallel directions make exact ties and zero denominators.
                const DVec3 d = i % 5 == 0 ? DVec3(i % 2, (i / 2) % 2, (i / 4) % 2) : random.direction();
                const int skip = static_cast<int>(random.next() * solid.facet_count());
                const FacetHit a = solid.exit(o, d, skip);
                const FacetHit b = plain_exit(solid, o, d, skip);
                ASSERT_EQ(a.facet, b.facet);
                ASSERT_EQ(a.distance, b.distance);
                const DVec3 outside = solid.center() + 3.0 * solid.radius() * random.direction();
                const DVec3 aim = i % 5 == 0 ? solid.vertices()[static_cast<std::size_t>(i) % solid.vertices().size()]
                                             : solid.center() + 1.2 * solid.radius() * random.direction();
                const FacetHit c = solid.enter(outside, aim - outside, -1);
                const FacetHit e = plain_enter(solid, outside, aim - outside);
                ASSERT_EQ(c.facet, e.facet);
                if (c) {
                    ASSERT_EQ(c.distance, e.distance);
                }
            }
        }
    }
    EXPECT_GE(targets, 2) << "this machine runs one instruction set only: nothing was compared";
}

// The ball test comes before the planes. Boxes have corners on their ball: rays through them, and just past them, at
// every scale, from near and from 1e6 radii away, and with a ball far from the origin of the coordinates.
TEST(HalfSpaceSolid, TheBallTurnsNoRayAwayThatMeetsAPlane) {
    Dice random = dice(7);
    std::size_t met = 0;
    for (const double size : {1e-6, 1.0, 1e6}) {
        for (const double offset : {0.0, 1e3}) {
            DMat4 placed(size);
            placed[3] = glm::dvec4(offset * size, -offset * size, offset * size, 1.0);
            const auto solid =
                HalfSpaceSolid::from_mesh(transformed(make_mesh(BoxShape{}).value(), placed).value()).value();
            for (int i = 0; i < 40000; ++i) {
                const DVec3 corner = solid.vertices()[static_cast<std::size_t>(i) % solid.vertices().size()];
                const double past = (i % 3 - 1) * std::pow(10.0, -16.0 + 15.0 * random.next());
                const DVec3 aim = corner + past * (corner - solid.center());
                const double distance = solid.radius() * std::pow(10.0, 0.5 + 5.5 * random.next());
                const DVec3 outside = aim + distance * random.direction();
                const DVec3 towards = std::pow(10.0, 2.0 * random.next() - 1.0) * unit(aim - outside);
                const FacetHit expected = plain_enter(solid, outside, towards);
                const FacetHit found = solid.enter(outside, towards, -1);
                ASSERT_EQ(found.facet, expected.facet) << size << ' ' << offset << ' ' << i;
                if (expected) {
                    ASSERT_EQ(found.distance, expected.distance);
                    ++met;
                }
            }
        }
    }
    EXPECT_GE(met, 20000U);
}

TEST(HalfSpaceSolid, OfExactlyTiedFacetsTheLowestIndexWins) {
    const EveryTarget restore;
    const HalfSpaceSolid cube = HalfSpaceSolid::from_mesh(make_mesh(BoxShape{{2.0, 2.0, 2.0}}).value()).value();
    for (std::int64_t bits = hwy::SupportedTargets(); bits != 0; bits &= bits - 1) {
        hwy::SetSupportedTargetsForTest(bits & -bits);
        // Faces -x +x -y +y -z +z; toward corner +++ all of 1, 3, 5 tie at distance 1.
        EXPECT_EQ(cube.exit(DVec3(0.0), DVec3(1.0), -1).facet, 1);
        EXPECT_EQ(cube.exit(DVec3(0.0), DVec3(1.0), 1).facet, 3);
        EXPECT_EQ(cube.exit(DVec3(0.0), DVec3(-1.0), -1).facet, 0);
        EXPECT_EQ(cube.exit(DVec3(0.0), DVec3(0.0, 1.0, -1.0), -1).facet, 3);
        EXPECT_EQ(cube.enter(DVec3(3.0), DVec3(-1.0), -1).facet, 1);
        EXPECT_EQ(cube.enter(DVec3(3.0), DVec3(-1.0), -1).distance, 2.0);
    }
}

TEST(HalfSpaceSolid, CubeFacesAreMetWhereTheyStand) {
    const HalfSpaceSolid cube = HalfSpaceSolid::from_mesh(make_mesh(BoxShape{{2.0, 2.0, 2.0}}).value()).value();
    const FacetHit in = cube.enter({-5.0, 0.25, 0.5}, {2.0, 0.0, 0.0}, -1);
    EXPECT_EQ(in.facet, 0);
    EXPECT_EQ(in.distance, 2.0);
    EXPECT_FALSE(cube.enter({-5.0, 1.25, 0.5}, {1.0, 0.0, 0.0}, -1)) << "passes beside, parallel to a face";
    EXPECT_FALSE(cube.enter({-5.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}, -1)) << "flies away";
    EXPECT_FALSE(cube.enter({-1.0, 0.0, 0.0}, {-1.0, 0.5, 0.0}, 0)) << "has just left";
    EXPECT_FALSE(cube.exit(DVec3(0.0), DVec3(0.0), -1)) << "no direction, no exit: reported";
    EXPECT_FALSE(cube.exit(DVec3(0.0), DVec3(std::nan("")), -1));
    EXPECT_TRUE(cube.contains({0.99, 0.0, 0.0}, 0.0));
    EXPECT_FALSE(cube.contains({0.99, 0.0, 0.0}, 0.02));
    EXPECT_TRUE(cube.contains({1.01, 0.0, 0.0}, -0.02));
    EXPECT_DOUBLE_EQ(cube.radius(), std::sqrt(3.0));
}

// Aimed from outside at the middle of edges and at corners, the ray must come in, and then go out elsewhere, as
// long as its line really passes through the inside: half way between two exits.
TEST(HalfSpaceSolid, OneMillionRaysAimedAtEdgesAndCornersNeverLeak) {
    const HalfSpaceSolid solid = brilliant();
    Dice random = dice(2);
    const Mesh& mesh = solid.mesh();
    int leaks = 0;
    int silhouettes = 0;
    for (int i = 0; i < 1000000; ++i) {
        random.dimension = static_cast<std::uint32_t>(16 * i);
        const auto& triangle = mesh.triangles[static_cast<std::size_t>(i) % mesh.triangles.size()];
        const DVec3 a = mesh.vertices[triangle[0]];
        const DVec3 b = mesh.vertices[triangle[1]];
        const DVec3 target = i % 3 == 0 ? a : a + random.next() * (b - a);
        // From inside: the target is the point where the ray leaves.
        const DVec3 inside = solid.center() + 0.3 * random.next() * random.direction();
        const FacetHit out = solid.exit(inside, target - inside, -1);
        // Start to edge is the unit of distance here; a dozen roundings of numbers of order 1, divided by cosines that
        // are never below 0.05 from so deep inside.
        if (!out || std::abs(out.distance - 1.0) > 1e-13) ++leaks;
        // From outside through the target into the inside point.
        const DVec3 outside = target + (target - inside) * (0.5 + random.next());
        const DVec3 d = target - outside;
        const FacetHit in = solid.enter(outside, d, -1);
        if (!in || std::abs(in.distance - 1.0) > 1e-13) {
            ++leaks;
            continue;
        }
        const DVec3 entry = outside + in.distance * d;
        const FacetHit through = solid.exit(entry, d, in.facet);
        if (!through || through.distance < 0.1) ++leaks;
        // Grazing: the line touches the edge and may miss by rounding, but if it enters it leaves.
        const DVec3 grazing = cross(b - a, random.direction());
        const DVec3 start = target - grazing;
        if (const FacetHit touch = solid.enter(start, grazing, -1)) {
            ++silhouettes;
            const FacetHit leave = solid.exit(start + touch.distance * grazing, grazing, touch.facet);
            // Along a plane distances are ill-conditioned; the depth below it (distance times cosine) is not.
            if (!leave || leave.distance * dot(solid.plane(leave.facet).normal, grazing) < -2e-15) ++leaks;
        }
    }
    EXPECT_EQ(leaks, 0);
    EXPECT_GT(silhouettes, 10000);
}

// 20 internal reflections with no epsilon: every hit lies on its plane and inside all others.
TEST(HalfSpaceSolid, ChainsOfInternalReflectionsStayOnTheSurface) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
        for (const double offset : {0.0, 10.0}) {
            SCOPED_TRACE(scale);
            SCOPED_TRACE(offset);
            DMat4 place(scale);
            place[3] = {offset * scale, -offset * scale, 2.0 * offset * scale, 1.0};
            const auto mesh = transformed(make_mesh(BrilliantShape{}).value(), place);
            const HalfSpaceSolid solid = HalfSpaceSolid::from_mesh(mesh.value()).value();
            // Coordinates of order (1 + 2 offset) scale carry half an ulp each; some ten operations; 1/cos up to 10.
            const double tolerance = 1e-14 * (1.0 + 2.0 * offset) * scale;
            Dice random = dice(3);
            for (int chain = 0; chain < 5000; ++chain) {
                DVec3 o = point_inside(solid, random);
                DVec3 d = random.direction();
                int left = -1;
                for (int bounce = 0; bounce < 20; ++bounce) {
                    const FacetHit hit = solid.exit(o, d, left);
                    ASSERT_TRUE(hit);
                    ASSERT_NE(hit.facet, left);
                    ASSERT_GT(hit.distance, -tolerance);
                    o += hit.distance * d;
                    const Plane& plane = solid.plane(hit.facet);
                    ASSERT_NEAR(dot(plane.normal, o), plane.offset, tolerance);
                    ASSERT_TRUE(solid.contains(o, -tolerance));
                    d = unit(d - 2.0 * dot(plane.normal, d) * plane.normal);
                    left = hit.facet;
                }
            }
        }
    }
}

TEST(HalfSpaceSolid, AStartInsideByRoundingStillEnters) {
    const HalfSpaceSolid cube = HalfSpaceSolid::from_mesh(make_mesh(BoxShape{{2.0, 2.0, 2.0}}).value()).value();
    const FacetHit in = cube.enter({-1.0 + 1e-16, 0.0, 0.0}, {1.0, 0.0, 0.0}, -1);
    EXPECT_EQ(in.facet, 0);
    EXPECT_LE(in.distance, 0.0);
    EXPECT_FALSE(cube.enter({-1.0 + 1e-16, 0.0, 0.0}, {-1.0, 0.0, 0.0}, -1)) << "leaving, not entering";
}

TEST(HalfSpaceSolid, PlanesThatDoNotBoundASolidAreAnError) {
    std::vector<Plane> planes;
    for (int axis = 0; axis < 3; ++axis) {
        DVec3 normal(0.0);
        normal[axis] = 1.0;
        planes.push_back({normal, 1.0});
        planes.push_back({-normal, 1.0});
    }
    EXPECT_TRUE(HalfSpaceSolid::from_planes(planes));
    std::vector<Plane> redundant = planes;
    redundant.push_back({unit(DVec3(1.0)), 5.0});
    EXPECT_FALSE(HalfSpaceSolid::from_planes(redundant));
    std::vector<Plane> open(planes.begin(), planes.end() - 1);
    EXPECT_FALSE(HalfSpaceSolid::from_planes(open));
    std::vector<Plane> empty = planes;
    empty[0].offset = -2.0;
    EXPECT_FALSE(HalfSpaceSolid::from_planes(empty));
}

TEST(HalfSpaceSolid, OpenAndNonConvexMeshesAreRefused) {
    Mesh open = make_mesh(BoxShape{}).value();
    open.triangles.pop_back();
    open.facet_of_triangle.pop_back();
    EXPECT_FALSE(HalfSpaceSolid::from_mesh(open));
    const Mesh pit = test::pitted_cube();
    ASSERT_TRUE(check_closed(pit));
    EXPECT_FALSE(is_convex(pit));
    EXPECT_FALSE(HalfSpaceSolid::from_mesh(pit));
}

}  // namespace
}  // namespace pol
