// SPDX-License-Identifier: Apache-2.0
// Solids as sets of half-spaces and as meshes in Embree: one picture, and no ray that leaks.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/geometry_helpers.h"
#include "geometry/shapes.h"
#include "polarization/measures.h"
#include "support/shipped_scenes.h"
#include "tracer/trace_sample.h"

namespace pol {
namespace {

/// Pixels of the two pictures whose Stokes vectors differ by more than `tolerance` times the brightest light.
int differing_pixels(const StokesImage& a, const StokesImage& b, double tolerance) {
    int count = 0;
    for (std::size_t p = 0; p < a.pixel_count(); ++p) {
        const Stokes<double> d = a.at(0, p) - b.at(0, p);
        if (!(std::abs(d.s0) + polarized_part(d) <= tolerance * a.brightest[0])) ++count;
    }
    return count;
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

// Planes and normals are the same doubles on both ways, so points agree to a few roundings. Amplitudes inherit that
// times the slope of Fresnel's formulas, 1/sqrt(x) at the distance x from the critical angle: with 1e6 interfaces in a
// picture the closest comes within x = 1e-6, slope 1e3, so 1e-15 x 40 surfaces operations x 1e3 < 1e-10. A pixel
// differs for good where a path passes an edge by less than the rounding.
TEST(HalfSpacesAndEmbree, ShowTheSamePictureOfTheSameSolid) {
    for (const std::string medium : {"glass", "crystal"}) {
        Scene exact = jewel_scene(false, medium);
        Scene mesh = jewel_scene(true, medium);
        if (medium == "crystal")
            for (Scene* scene : {&exact, &mesh}) *scene = verify::cut_by_depth(test::small(*scene, 20), 5);
        ASSERT_FALSE(test::plan_of(exact)->features.meshes);
        ASSERT_TRUE(test::plan_of(mesh)->features.meshes);
        const StokesImage a = test::render(exact);
        const StokesImage b = test::render(mesh);
        EXPECT_LE(differing_pixels(a, b, 1e-10), static_cast<int>(a.pixel_count() / 200)) << medium;
        EXPECT_TRUE(b.failures.empty()) << medium;
    }
}

/// A ball of 320 triangles before a lamp, all of it 0, 1e3 or 1e6 radii from the origin, in the numbers of the file;
/// `chip`: with a second piece in the file, 1e7 radii away.
Scene far_ball(double distance, bool chip) {
    const std::string x = std::to_string(distance);
    Scene scene = test::scene_of("camera: {type: orthographic, position: [" + x + ", 0, 10], target: [" + x +
                                 ", 0, 0], up: [0, 1, 0], width: 2.2}\nmedia: {glass: 1.5}\n"
                                 "render: {size: [24, 24], residual: 1e-6}\nobjects:\n"
                                 "  - {name: ball, shape: {box: {size: 1}}, medium: glass}\n"
                                 "  - {name: lamp, shape: {rectangle: {size: 2}}, transform: [{translate: [" +
                                 x + ", 0, -4]}], emission: {radiance: 1}}\n");
    test::Triangles ball = test::icosphere(2, {distance, 0.0, 0.0});
    if (chip) {
        const auto first = static_cast<std::uint32_t>(ball.vertices.size());
        const DVec3 corner(1e7, 1e7, 0.0);
        ball.vertices.insert(ball.vertices.end(),
                             {corner, corner + DVec3(1, 0, 0), corner + DVec3(0, 1, 0), corner + DVec3(0, 0, 1)});
        for (const auto& t : {std::array{0U, 2U, 1U}, {0U, 1U, 3U}, {1U, 2U, 3U}, {2U, 0U, 3U}})
            ball.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    const Mesh mesh = mesh_from_triangles(ball.vertices, ball.triangles).value();
    scene.objects[0].shape = MeshShape{"", std::make_shared<const Mesh>(mesh)};
    return scene;
}

// At 1e6 coordinates are rounded to 6e-11, which turns a triangle of width 0.3 by 4e-10 rad. Times the slope of
// Fresnel's formulas, up to 1e3 as above, and a path's ten interfaces: below 1e-5. A pixel differs for good where a
// path passes an edge by less than the rounding.
TEST(Meshes, ShowTheSamePictureWhereverTheyAreAndWhateverElseIsInTheFile) {
    const StokesImage near = test::render(far_ball(0.0, false));
    for (const double distance : {1e3, 1e6}) {
        const StokesImage far = test::render(far_ball(distance, false));
        EXPECT_TRUE(far.failures.empty());
        EXPECT_LE(differing_pixels(near, far, 1e-5), static_cast<int>(near.pixel_count() / 200)) << distance;
    }
    const StokesImage with_chip = test::render(far_ball(0.0, true));
    EXPECT_TRUE(with_chip.failures.empty());
    EXPECT_LE(differing_pixels(near, with_chip, 1e-10), static_cast<int>(near.pixel_count() / 200));
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
                task.residual = plan->settings.residual_in_force();
                task.node_budget = plan->settings.node_budget.value();
                Stokes<double> light;
                const TraceResult r = trace_sample(*plan, task, {&light, 1});
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
