// SPDX-License-Identifier: Apache-2.0
// Which medium is where: nested, overlapping and touching solids against equivalent scenes without them, and closed
// forms.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <string>

#include "geometry/mesh_check.h"
#include "polarization/measures.h"
#include "support/sanitizers.h"
#include "support/shipped_scenes.h"

namespace pol {
namespace {

/// An oblique view of `objects` over a wide polarized lamp; trees followed to a residual of 1e-9 or 20000 rays.
Scene scene_with(const std::string& objects) {
    return test::scene_of(R"(
camera: {position: [1.3, -4.1, 2.7], target: [0.03, 0.02, 0.01], fov: 30}
background: 0.1
render: {size: [10, 10], residual: 1e-9, node_budget: 20000}
media: {light glass: 1.3, same light glass: 1.3, glass: 1.5, same glass: 1.5, dense glass: 1.7, air: 1, calcite: {crystal: calcite}, gold: {conductor: gold}}
objects:
  - {name: lamp, shape: {rectangle: {size: 60}}, transform: [{translate: [0, 0, -1.9]}],
     emission: {radiance: 1, polarization: {dop: 0.7, azimuth: 20, ellipticity: 0.3, handedness: right}}}
)" + objects);
}

/// Largest difference of any pixel, S0 and polarized part added, beyond what the two pictures leave open: each may lack
/// its residual and be off either way by its tail, in S0 and in the polarized part.
double difference(const Scene& a, const Scene& b) {
    const StokesImage image_a = test::render(a);
    const StokesImage image_b = test::render(b);
    double largest = 0.0;
    double most_open = 0.0;
    for (std::size_t p = 0; p < image_a.pixel_count(); ++p) {
        double open = 0.0;
        for (const StokesImage* image : {&image_a, &image_b}) {
            open += 2.0 * image->brightest[0] * image->plane_value(image->residual, 0, p);
            open += 4.0 * image->brightest[0] * image->plane_value(image->tail, 0, p);
        }
        most_open = std::max(most_open, open);
        const Stokes<double> d = image_a.at(0, p) - image_b.at(0, p);
        largest = std::max(largest, std::abs(d.s0) + polarized_part(d) - open);
    }
    EXPECT_TRUE(image_a.failures.empty());
    EXPECT_TRUE(image_b.failures.empty());
    EXPECT_LE(most_open, 0.02) << "the trees are cut too early to tell pictures apart";
    return largest;
}

// Rounding along the paths of a tree, a few hundred operations and a slope of Fresnel's formulas of up to 1e3.
constexpr double same = 1e-10;
/// What a changed index changes somewhere in the picture, at least.
constexpr double visible = 1e-3;

TEST(Nesting, AnIndexMatchedBubbleIsInvisible) {
    const std::string block = "  - {name: block, shape: {box: {size: [2, 2, 2]}}, medium: glass}\n";
    const auto with = [&](const std::string& shape, const std::string& medium) {
        return scene_with(block + "  - {name: bubble, shape: " + shape + ", medium: " + medium + "}\n");
    };
    for (const std::string shape :
         {"{sphere: {radius: 0.6}}", "{box: {size: [0.9, 0.7, 0.8]}}", "{brilliant: {diameter: 1}}"}) {
        EXPECT_LE(difference(scene_with(block), with(shape, "same glass")), same) << shape;
        EXPECT_GE(difference(scene_with(block), with(shape, "air")), visible) << shape;
    }
}

TEST(Nesting, EverySphereOfANestHasARegionOfItsOwn) {
    const Scene scene = scene_with(R"(
  - {name: outer, shape: {sphere: {radius: 1}}, medium: glass}
  - {name: inner, shape: {sphere: {radius: 0.5}}, medium: air}
  - {name: core, shape: {sphere: {radius: 0.2}}, medium: glass}
)");
    const auto plan = test::plan_of(scene);
    ASSERT_EQ(plan->regions.size(), 4U);
    for (const Region& region : plan->regions) {
        const std::size_t depth = region.members.size();
        const char* expected[] = {"vacuum", "glass", "air", "glass"};
        EXPECT_EQ(plan->medium_names[static_cast<std::size_t>(region.medium)], expected[depth]);
    }
}

/// The time grows with the square of their number: with the cube it would be half a minute.
TEST(Nesting, ThousandsOfSeparateSolidsAreArrangedInSeconds) {
    constexpr int count = 2000;
    Scene scene = scene_with("  - {name: bead, shape: {box: {size: 0.01}}, medium: glass}\n");
    const Object bead = scene.objects.back();
    for (int i = 1; i < count; ++i) {
        scene.objects.push_back(bead);
        scene.objects.back().name += std::to_string(i);
        scene.objects.back().to_world[3][0] = 0.02 * i;
    }
    const auto begin = std::chrono::steady_clock::now();
    const auto plan = compile(scene);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    ASSERT_TRUE(plan) << to_string(plan.error());
    EXPECT_EQ(plan.value()->regions.size(), std::size_t{count} + 1);
    EXPECT_LT(took.count(), 10.0 * test::slowdown);
}

TEST(Nesting, EverySharedBoundaryLeadsThereAndBack) {
    for (const std::string& name : test::shipped_scene_names()) {
        const auto plan = test::plan_of(test::small(test::shipped_scene(name), 2));
        for (std::size_t r = 0; r < plan->regions.size(); ++r)
            for (std::size_t s = 0; s < plan->solids.size(); ++s) {
                const int other = plan->regions[r].toggled[s];
                if (other < 0) continue;
                const Region& there = plan->regions[static_cast<std::size_t>(other)];
                EXPECT_EQ(there.toggled[s], static_cast<int>(r)) << name;
                EXPECT_NE(there.members.size(), plan->regions[r].members.size()) << name;
            }
    }
}

/// Along the axis of concentric spheres around the camera, inside a furnace of radiance 1.
Stokes<double> from_the_center(const std::string& objects) {
    return test::look(R"(
camera: {position: [0, 0, 0], target: [0.3, 0.5, 0.7], fov: 10}
background: 1
render: {residual: 1e-12, node_budget: 100000}
media: {glass: 1.5, air: 1}
objects:
)" + objects);
}

// Lossless surroundings of radiance 1 are seen from a medium of index n with radiance n^2 (PHYSICS.md 2.3); the
// residual of 1e-12 may be missing, times n^2. Rays through the centre meet all spheres head-on.
TEST(Nesting, TheCameraMayBeInGlassOrInABubbleInIt) {
    const std::string ball = "  - {name: ball, shape: {sphere: {radius: 2}}, medium: glass}\n";
    const std::string bubble = "  - {name: bubble, shape: {sphere: {radius: 1}}, medium: air}\n";
    const Stokes<double> in_glass = from_the_center(ball);
    EXPECT_NEAR(in_glass.s0, 2.25, 1e-11);
    EXPECT_NEAR(polarized_part(in_glass), 0.0, 1e-11);
    const Stokes<double> in_bubble = from_the_center(ball + bubble);
    EXPECT_NEAR(in_bubble.s0, 1.0, 1e-11);
    EXPECT_NEAR(polarized_part(in_bubble), 0.0, 1e-11);
}

TEST(Nesting, OfOverlappingSolidsTheHigherPriorityOwnsTheVolume) {
    const auto overlapping = [](int of_left, int of_right) {
        return scene_with(
            "  - {name: left, shape: {box: {size: [2, 1, 1]}}, transform: [{translate: [-0.5, 0, 0]}], medium: glass, "
            "priority: " +
            std::to_string(of_left) +
            "}\n  - {name: right, shape: {box: {size: [2, 1, 1]}}, transform: [{translate: [0.5, 0, 0]}], "
            "medium: dense glass, priority: " +
            std::to_string(of_right) + "}\n");
    };
    const auto touching = [](double seam) {
        const double left = seam + 1.5;
        const double right = 1.5 - seam;
        const auto box = [](const std::string& name, double width, double center, const std::string& medium) {
            return "  - {name: " + name + ", shape: {box: {size: [" + std::to_string(width) +
                   ", 1, 1]}}, transform: [{translate: [" + std::to_string(center) + ", 0, 0]}], medium: " + medium +
                   "}\n";
        };
        return scene_with(box("left", left, -1.5 + 0.5 * left, "glass") +
                          box("right", right, 1.5 - 0.5 * right, "dense glass"));
    };
    EXPECT_LE(difference(overlapping(2, 1), touching(0.5)), same);
    EXPECT_LE(difference(overlapping(-1, 0), touching(-0.5)), same);
    EXPECT_GE(difference(overlapping(2, 1), overlapping(1, 2)), visible);
}

// A nested block that fills the upper half of its host, five of its faces flush with the host's: two blocks in contact.
TEST(Nesting, FlushFacesOfANestedSolidAreOneInterface) {
    const Scene flush = scene_with(R"(
  - {name: host, shape: {box: {size: [1.6, 1.2, 2]}}, medium: glass}
  - {name: nested, shape: {box: {size: [1.6, 1.2, 1]}}, transform: [{translate: [0, 0, 0.5]}], medium: dense glass}
)");
    const Scene stacked = scene_with(R"(
  - {name: lower, shape: {box: {size: [1.6, 1.2, 1]}}, transform: [{translate: [0, 0, -0.5]}], medium: glass}
  - {name: upper, shape: {box: {size: [1.6, 1.2, 1]}}, transform: [{translate: [0, 0, 0.5]}], medium: dense glass}
)");
    EXPECT_LE(difference(flush, stacked), same);
}

TEST(Nesting, TheSeamOfTwoTouchingHalvesIsInvisible) {
    const Scene halves = scene_with(R"(
  - {name: left, shape: {box: {size: [1, 1.2, 1]}}, transform: [{translate: [-0.5, 0, 0]}], medium: glass}
  - {name: right, shape: {box: {size: [1, 1.2, 1]}}, transform: [{translate: [0.5, 0, 0]}], medium: same glass}
)");
    const Scene whole = scene_with("  - {name: whole, shape: {box: {size: [2, 1.2, 1]}}, medium: glass}\n");
    EXPECT_LE(difference(halves, whole), same);
}

// A small block on a large one covers a part of its face. The same with the small one sunk into the large one, which
// owns the common volume: dense on light, and gold on glass.
TEST(Nesting, AFaceMayBeTouchedInPart) {
    for (const std::string medium : {"dense glass", "glass", "gold"}) {
        const auto stacked = [&](const std::string& height, const std::string& center) {
            return scene_with(
                "  - {name: large, shape: {box: {size: [2, 1.6, 1]}}, medium: glass, priority: 1, transform: "
                "[{translate: [0, 0, -0.5]}]}\n"
                "  - {name: small, shape: {box: {size: [0.9, 0.7, " +
                height + "]}}, transform: [{translate: [0.2, -0.1, " + center + "]}], medium: " + medium + "}\n");
        };
        EXPECT_LE(difference(stacked("0.6", "0.3"), stacked("1", "0.1")), same) << medium;
    }
}

/// Contacts, flush faces and nests are found by coordinates: turned and moved, they must be found again.
TEST(Nesting, ContactsHoldWhereverTheyAre) {
    const DVec3 x = unit(DVec3(0.3, -0.7, 0.5));
    const DMat3 turn(x, any_perpendicular(x), cross(x, any_perpendicular(x)));
    const Scene scene = scene_with(R"(
  - {name: host, shape: {box: {size: [1.6, 1.2, 1]}}, transform: [{translate: [0, 0, -0.5]}], medium: glass}
  - {name: nested, shape: {box: {size: [0.8, 1.2, 0.5]}}, transform: [{translate: [0.1, 0, -0.25]}], medium: dense glass}
  - {name: neighbor, shape: {box: {size: [1, 1, 0.7]}}, transform: [{translate: [0, 0.2, 0.35]}], medium: light glass}
)");
    for (const double scale : {1e-6, 1.0, 1e6})
        EXPECT_LE(difference(scene, test::carried(scene, turn, scale, DVec3(3.1, -2.3, 4.7) * scale)), same) << scale;
}

/// A trough along y, open above: 1.6 wide, its pit 0.8 wide and 0.5 deep. Not convex.
Mesh trough() {
    const DVec2 outline[] = {{-0.8, -0.5}, {0.8, -0.5}, {0.8, 0.5},  {0.4, 0.5},
                             {0.4, 0.0},   {-0.4, 0.0}, {-0.4, 0.5}, {-0.8, 0.5}};
    const std::array<std::uint32_t, 3> face[] = {{0, 1, 5}, {1, 4, 5}, {1, 2, 4}, {2, 3, 4}, {0, 5, 7}, {5, 6, 7}};
    std::vector<DVec3> vertices;
    for (const double y : {-0.6, 0.6})
        for (const DVec2& p : outline) vertices.emplace_back(p.x, y, p.y);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const auto& t : face) {
        triangles.push_back({t[0], t[1], t[2]});              // front, seen from -y
        triangles.push_back({t[0] + 8, t[2] + 8, t[1] + 8});  // back
    }
    for (std::uint32_t i = 0; i < 8; ++i) {
        const std::uint32_t j = (i + 1) % 8;
        triangles.push_back({i, i + 8, j});
        triangles.push_back({j, i + 8, j + 8});
    }
    return mesh_from_triangles(vertices, triangles).value();
}

// A mesh and a block that fills its pit to the brim: touching, or the block larger and the trough owning what both
// claim.
TEST(Nesting, AMeshAndAFlatSolidTouchWithoutAGap) {
    const auto filled = [](const std::string& block, const std::string& medium) {
        Scene scene = scene_with(
            "  - {name: trough, shape: {box: {size: 1}}, medium: light glass, priority: 1}\n"
            "  - {name: filling, shape: {box: {size: " +
            block + ", medium: " + medium + "}\n");
        scene.objects[1].shape = MeshShape{"", std::make_shared<const Mesh>(trough())};
        return scene;
    };
    const std::string touching = "[0.8, 1.2, 0.5]}}, transform: [{translate: [0, 0, 0.25]}]";
    const std::string sunk = "[1.1, 1.2, 0.9]}}, transform: [{translate: [0, 0, 0.05]}]";
    ASSERT_TRUE(test::plan_of(filled(touching, "glass"))->features.meshes);
    EXPECT_LE(difference(filled(touching, "glass"), filled(sunk, "glass")), same);
    // filled with its own medium it is a plain block
    const Scene block = scene_with("  - {name: block, shape: {box: {size: [1.6, 1.2, 1]}}, medium: light glass}\n");
    EXPECT_LE(difference(filled(touching, "same light glass"), block), same);
    EXPECT_LE(difference(filled(sunk, "same light glass"), block), same);
    EXPECT_GE(difference(filled(sunk, "glass"), block), visible);
}

// Glass on dense glass, seen along the axis: one interface with R = ((n1 - n2)/(n1 + n2))^2 and no air between.
TEST(Nesting, TouchingFacesReflectAsOneInterface) {
    const Explanation e = test::explain_look(test::scene_of(R"(
camera: {type: orthographic, position: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], width: 0.1}
background: 1
render: {residual: 0.02}
media: {glass: 1.5, dense glass: 1.7}
objects:
  - {name: lower, shape: {box: {size: 1}}, transform: [{translate: [0, 0, -0.5]}], medium: dense glass}
  - {name: upper, shape: {box: {size: 1}}, transform: [{translate: [0, 0, 0.5]}], medium: glass}
)"));
    const double entered = 0.96;
    const double seam = (0.2 / 3.2) * (0.2 / 3.2);
    bool found = false;
    for (const RayTreeNode& node : e.tree.nodes)
        if (node.interaction == Interaction::reflected && node.start.depth == 2 && node.start.origin.z == 0.0) {
            EXPECT_NEAR(node.start.weight, entered * seam, 1e-15);
            found = true;
        }
    EXPECT_TRUE(found);
}

// A solid that stands on an emitter is seen as if a gap of a billionth were between them; the lamp is wide and even, so
// that shifts of 1e-9 change nothing else.
TEST(Nesting, ASolidMayStandOnAnEmitter) {
    for (const std::string shape : {"{box: {size: [1, 1, 3.8]}}", "{box: {size: [2.5, 1, 3.8]}}"}) {
        const auto standing = [&](const std::string& gap, const std::string& medium) {
            return scene_with("  - {name: block, shape: " + shape + ", transform: [{translate: [0, 0, " + gap +
                              "]}], medium: " + medium + "}\n");
        };
        EXPECT_LE(difference(standing("0", "glass"), standing("1e-6", "glass")), same) << shape;
    }
}

// In the glass itself an unpolarized lamp of radiance L brings L/n^2 to an eye in air, times what the surface passes:
// 0.96 for n = 1.5 seen head-on (the 4 % that are reflected outside see black). Two roundings a factor: 1e-15.
TEST(Nesting, AnEmitterInsideGlassIsSeenThroughItsSurface) {
    const Stokes<double> s = test::look(R"(
camera: {type: orthographic, position: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], width: 0.1}
render: {residual: 1e-12}
media: {glass: 1.5}
objects:
  - {name: block, shape: {box: {size: 2}}, medium: glass}
  - {name: lamp, shape: {rectangle: {size: 1}}, emission: {radiance: 1}}
)");
    EXPECT_NEAR(s.s0, 0.96 / 2.25, 2e-15);
    EXPECT_NEAR(polarized_part(s), 0.0, 1e-15);
}

}  // namespace
}  // namespace pol
