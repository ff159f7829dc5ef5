// SPDX-License-Identifier: Apache-2.0
// What holds for every scene, whatever is in it: conservation of energy and independence of where and how large the
// scene is.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/units.h"
#include "geometry/shapes.h"
#include "polarization/measures.h"
#include "support/shipped_scenes.h"
#include "tracer/observers.h"

namespace pol {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct Rendered {
    StokesImage image;
    RenderStatistics statistics;
};

Rendered render_with_statistics(const Scene& scene) {
    Renderer renderer(1);
    renderer.start(test::plan_of(scene));
    while (!renderer.wait_for(1.0)) {
    }
    return {renderer.snapshot(), renderer.progress().statistics};
}

/// Rounding of a sum over a tree, relative to the light it stands for: each of `nodes` additions rounds a sum that is
/// at most 1, and the weights of the leaves, 1 in all, carry the rounding of some 60 operations per surface on their
/// way (40 surfaces).
double tree_rounding(std::uint32_t nodes) {
    return epsilon * (nodes + 40.0 * 60.0);
}

class ShippedScene : public testing::TestWithParam<std::string> {};

std::string name_of(const testing::TestParamInfo<std::string>& parameter) {
    return test::test_name(parameter.param);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScene, testing::ValuesIn(test::shipped_scene_names()), name_of);

TEST_P(ShippedScene, ConservesEnergyAtEveryPixelAndNeverFails) {
    const Rendered r = render_with_statistics(test::small(test::shipped_scene(GetParam()), 20));
    EXPECT_EQ(r.statistics.failures, 0U);
    EXPECT_LE(r.statistics.worst_energy_defect, 1e-11);  // the issue's bound; tree_rounding(1e4) is 2.8e-12
    for (std::size_t p = 0; p < r.image.pixel_count(); ++p) {
        const Stokes<double>& s = r.image.at(0, p);
        const double rounding = tree_rounding(r.statistics.most_nodes) * r.image.brightest[0];
        ASSERT_GE(s.s0, 0.0) << p;
        ASSERT_LE(s.s0, r.image.brightest[0] + rounding) << p;
        ASSERT_LE(polarized_part(s), s.s0 + rounding) << p;
    }
}

/// In uniform unpolarized surroundings everything lossless is invisible: J = L/2 x identity. What was not traced is
/// missing, so S0 + residual L = L to rounding (each leaf of weight w brings w L; the tail stands for all of its
/// weight). The missing part of J has trace residual L, that of the tail is replaced by another of the same trace, so
/// |s| <= (residual + 2 tail) L.
void expect_invisible(const Scene& scene, double radiance) {
    const Rendered r = render_with_statistics(scene);
    const double rounding = radiance * tree_rounding(r.statistics.most_nodes);
    for (std::size_t p = 0; p < r.image.pixel_count(); ++p) {
        const double residual = r.image.plane_value(r.image.residual, 0, p);
        const double tail = r.image.plane_value(r.image.tail, 0, p);
        const Stokes<double>& s = r.image.at(0, p);
        ASSERT_NEAR(s.s0, radiance * (1.0 - residual), rounding) << p;
        ASSERT_LE(polarized_part(s), radiance * (residual + 2.0 * tail) + rounding) << p;
    }
    EXPECT_EQ(r.statistics.failures, 0U);
}

TEST_P(ShippedScene, OfLosslessMediaIsInvisibleInAFurnace) {
    const Scene scene = test::as_furnace(test::small(test::shipped_scene(GetParam()), 20), 0.75);
    if (!test::is_lossless(scene, *test::plan_of(scene))) GTEST_SKIP() << "not lossless";
    expect_invisible(scene, 0.75);
}

// Trees of most scenes of glass end: P = 0 within rounding then.
TEST_P(ShippedScene, OfGlassLeavesNoPolarizationInAFurnace) {
    Scene scene = test::as_furnace(test::small(test::shipped_scene(GetParam()), 8), 1.0);
    const auto plan = test::plan_of(scene);
    if (!test::is_lossless(scene, *plan) || test::has_crystals(*plan)) GTEST_SKIP() << "not lossless glass";
    scene.render.residual = 1e-12;
    scene.render.node_budget = 20000;
    expect_invisible(scene, 1.0);
}

/// Cut by depth alone: which branches are followed does not hang on the last bit of a weight.
Scene cut_by_depth(Scene scene, int depth) {
    scene.render.depth = depth;
    scene.render.residual = 0.0;
    scene.render.node_budget = 1000000;
    return scene;
}

/// Pixels of the two pictures whose Stokes vectors differ by more than `tolerance` times the brightest light.
int differing_pixels(const StokesImage& a, const StokesImage& b, double tolerance) {
    int count = 0;
    for (std::size_t p = 0; p < a.pixel_count(); ++p) {
        const Stokes<double> d = a.at(0, p) - b.at(0, p);
        if (!(std::abs(d.s0) + polarized_part(d) <= tolerance * a.brightest[0])) ++count;
    }
    return count;
}

struct Carry {
    const char* name;
    DMat3 turn;
    double scale;
    DVec3 shift;
};

DMat3 some_rotation() {
    const DVec3 x = unit(DVec3(0.3, -0.7, 0.5));
    const DVec3 y = any_perpendicular(x);
    return {x, y, cross(x, y)};
}

// Directions do not change with size and place, points change by rounding: relative to the scene's extent by 1e-16
// (scaled, turned) or by 1e-16 of the shift (moved by 10 extents). Amplitudes inherit the rounding of the directions
// times the slope of Fresnel's formulas, 1/sqrt(x) at the distance x from the critical angle: with 1e6 interfaces in a
// picture the closest comes within x = 1e-6, slope 1e3, so 1e-15 x 40 surfaces operations x 1e3 < 1e-10. A pixel
// differs for good where a path passes an edge of a facet or of a texel by less than the rounding; the share of such
// pixels is about (edges per pixel) x 1e-15 and none is expected, but 1 % is allowed, since scenes put edges where
// pixel centres are (symmetry).
TEST_P(ShippedScene, LooksTheSameScaledMovedAndTurned) {
    const Scene scene = cut_by_depth(test::small(test::shipped_scene(GetParam()), 16), 5);
    const StokesImage here = test::render(scene);
    const double extent = test::plan_of(scene)->length_scale;
    const DMat3 none(1.0);
    for (const Carry& carry :
         {Carry{"small", none, 1e-6, DVec3(0.0)}, Carry{"large", none, 1e6, DVec3(0.0)},
          Carry{"moved", none, 1.0, DVec3(7.3, -4.1, 5.9) * extent}, Carry{"turned", some_rotation(), 1.0, DVec3(0.0)},
          Carry{"all", some_rotation(), 1e3, DVec3(-2.2e3, 3.1e3, 1e3) * extent}}) {
        const StokesImage there = test::render(test::carried(scene, carry.turn, carry.scale, carry.shift));
        const int flipped = differing_pixels(here, there, 1e-10);
        EXPECT_LE(flipped, 2) << carry.name;
        EXPECT_TRUE(there.failures.empty()) << carry.name;
    }
}

/// A jewel and a distant box, as two half-space solids or as one mesh, which is not convex and goes to Embree.
Scene jewel_scene(bool one_mesh, const std::string& medium) {
    Scene scene = test::scene_of(R"(
camera: {position: [0.35, -4, 3.2], target: [0, 0, -0.1], fov: 34}
background: 0.1
render: {size: [40, 40], depth: 7, residual: 0, node_budget: 1000000}
media:
  glass: 1.5
  crystal: {ordinary: 1.6, extraordinary: 1.5, axis: [1, 0, 1]}
objects:
  - {name: stone, shape: {brilliant: {diameter: 2}}, medium: glass}
  - {name: far box, shape: {box: {size: 0.5}}, transform: [{translate: [1.5, 1.5, 0]}], medium: glass}
  - {name: lamp, shape: {rectangle: {size: 3}}, transform: [{translate: [0, 0, -0.95]}],
     emission: {radiance: 1, polarization: {dop: 1, azimuth: 20, ellipticity: 0.5, handedness: left}}}
)");
    for (std::size_t i = 0; i < 2; ++i) scene.objects[i].role = FilledWith{medium};
    if (!one_mesh) return scene;
    const auto world_mesh = [](const Object& object) {
        return transformed(make_mesh(object.shape).value(), object.to_world).value();
    };
    const Mesh both = test::joined(world_mesh(scene.objects[0]), world_mesh(scene.objects[1]));
    scene.objects[0].shape = MeshShape{"", std::make_shared<const Mesh>(both)};
    scene.objects.erase(scene.objects.begin() + 1);
    return scene;
}

// Planes and normals are the same doubles on both ways, so points agree to a few roundings; tolerance and allowed flips
// as for scaled scenes.
TEST(HalfSpacesAndEmbree, ShowTheSamePictureOfTheSameSolid) {
    for (const std::string medium : {"glass", "crystal"}) {
        Scene exact = jewel_scene(false, medium);
        Scene mesh = jewel_scene(true, medium);
        if (medium == "crystal")
            for (Scene* scene : {&exact, &mesh}) *scene = cut_by_depth(test::small(*scene, 20), 5);
        ASSERT_FALSE(test::plan_of(exact)->features.meshes);
        ASSERT_TRUE(test::plan_of(mesh)->features.meshes);
        const StokesImage a = test::render(exact);
        const StokesImage b = test::render(mesh);
        EXPECT_LE(differing_pixels(a, b, 1e-10), static_cast<int>(a.pixel_count() / 200)) << medium;
        EXPECT_TRUE(b.failures.empty()) << medium;
    }
}

/// Corners of all facets of `mesh`, and midpoints of all triangle edges (diagonals of facets among them).
std::vector<DVec3> corners_and_midpoints(const Mesh& mesh) {
    std::vector<DVec3> points = mesh.vertices;
    for (const auto& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i];
            const std::uint32_t b = t[(i + 1) % 3];
            if (a < b) points.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
        }
    return points;
}

// A ray that meets an edge exactly may take either facet, but must take one: no failure, and no energy lost.
TEST(HalfSpacesAndEmbree, NoRayLeaksThroughAnEdgeOrCornerOfTheBrilliant) {
    for (const bool one_mesh : {false, true}) {
        Scene scene = jewel_scene(one_mesh, "glass");
        scene.render.depth = 6;
        const auto plan = test::plan_of(scene);
        const Mesh stone = make_mesh(BrilliantShape{}).value();
        Silent silent;
        Tracer<false, false, Silent> tracer(*plan, silent);
        int rays = 0;
        for (const DVec3& point : corners_and_midpoints(stone)) {
            for (int i = 0; i < 25; ++i) {
                // Points of a spiral on a sphere around the stone.
                const double height = -0.96 + 0.08 * i;
                const double radius = std::sqrt(1.0 - height * height);
                const DVec3 from = 5.0 * DVec3(radius * std::cos(2.4 * i), radius * std::sin(2.4 * i), height);
                Camera camera;
                camera.position = from;
                camera.target = point;
                camera.up = DVec3(0.1, 0.2, 1.0);
                camera.horizontal_fov = 0.1;
                TraceTask task;
                task.ray = CameraModel(camera, 1, 1).ray(0.5, 0.5);
                task.residual = plan->settings.residual;
                task.node_budget = plan->settings.node_budget;
                Stokes<double> light;
                const TraceResult r = tracer.trace(task, {&light, 1});
                ASSERT_EQ(r.failures, 0U) << "one mesh: " << one_mesh << ", direction " << i;
                ASSERT_NEAR(r.resolved + r.absorbed + r.residual, 1.0, 1e-11);
                ++rays;
            }
        }
        EXPECT_GT(rays, 2000);
    }
}

}  // namespace
}  // namespace pol
